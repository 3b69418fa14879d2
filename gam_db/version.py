"""The version, for those who need it and may not import the whole package."""

__version__ = "0.1.0"
