"""Records of MuJoCo and of players, for tests to compare with."""
