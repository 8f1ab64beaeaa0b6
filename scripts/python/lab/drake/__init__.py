"""Plans of free bodies in Drake."""
