"""The commands, a module each: `add_arguments` adds to a parser, `run` does what the parsed arguments say.

`PACKAGES` names what a command needs. Packages are imported by `run` alone, so that help needs none of them.
"""
