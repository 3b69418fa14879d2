"""Rows that are later than now decide nothing: they are left out, named, and scored when their time comes."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest

import engines
import gam_db
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from test_two_writers import Plant

MINUTE = 60_000_000
#: 2026-01-01, in microseconds.
BEGIN = 1_767_225_600_000_000
FAR = 4_070_908_800_000_000  # 2099-01-01
