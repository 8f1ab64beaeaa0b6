"""Pairs of real parts."""
