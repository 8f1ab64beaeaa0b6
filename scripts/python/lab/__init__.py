"""Measures, validates, records, and makes files beside the program itself."""
