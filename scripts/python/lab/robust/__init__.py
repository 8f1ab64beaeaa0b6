"""Robust plans of many scenes, made and played."""
