"""Writes TOML."""

import json


def text(table: dict, prefix: str = "") -> str:
    """A table: its values, then the tables in it."""
    tables = {key: entry for key, entry in table.items() if isinstance(entry, dict)}
    lists = {
        key: entry for key, entry in table.items() if isinstance(entry, list) and entry and isinstance(entry[0], dict)
    }
    plain = {key: entry for key, entry in table.items() if key not in tables | lists}
    # Strings, numbers and lists of numbers are written as in JSON.
    lines = "".join(f"{key} = {json.dumps(entry)}\n" for key, entry in plain.items())
    for key, entry in tables.items():
        lines += f"\n[{prefix}{key}]\n" + text(entry, f"{prefix}{key}.")
    for key, entries in lists.items():
        for entry in entries:
            lines += f"\n[[{prefix}{key}]]\n" + text(entry, f"{prefix}{key}.")
    return lines
