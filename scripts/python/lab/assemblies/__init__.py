"""Pairs of plugs and sockets: read, planned and played."""
