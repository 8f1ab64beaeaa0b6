"""Plans in MuJoCo: models of scenes and arms, and motions on them."""
