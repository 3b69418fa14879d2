"""The page for people who look: what the tables of a monitor know, in one HTML file."""

from gam_db.report.report import write
from gam_db.report.wishes import Wishes

__all__ = ["Wishes", "write"]
