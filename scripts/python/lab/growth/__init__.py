"""How a solve grows."""
