"""Plans played in MuJoCo, compared with solutions that are known and with the program's own simulator."""
