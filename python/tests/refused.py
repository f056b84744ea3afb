"""Shared: the table of requests that are refused, each with the sentence that says why."""

import csv
import math
from pathlib import Path

import pytest

import atraj


def assert_refused(about, **names):
    """Makes the calls of a part of the table. They know the module's names, and these."""
    with open(Path(__file__).with_name("bad_requests.csv")) as table:
        rows = [row for row in csv.DictReader(table) if row["about"] == about]
    assert rows, about
    for row in rows:
        with pytest.raises(ValueError, match=row["sentence"]):
            eval(row["call"], {**vars(atraj), "nan": math.nan, "inf": math.inf, **names})
            pytest.fail(f"{row['call']} is not refused")
