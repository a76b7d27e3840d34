"""Motions made here, with exactly known supports."""
