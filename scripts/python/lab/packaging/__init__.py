"""Licences of what packages hold."""
