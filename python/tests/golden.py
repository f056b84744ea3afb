"""The golden data of `tests/golden`: what the originals computed."""

import csv
import math
import struct
from pathlib import Path

import numpy as np

import atraj
import atraj.f32

DIRECTORY = Path(__file__).parents[2] / "tests/golden"


class Real:
    """A real type: its classes, its NumPy type and its bits in the golden tables."""

    def __init__(self, name, module, dtype, code):
        self.name, self.module, self.dtype, self.code = name, module, dtype, code

    def parse(self, cell):
        return math.nan if cell == "nan" else struct.unpack(f">{self.code}", bytes.fromhex(cell))[0]

    def bits(self, numbers):
        """One integer for each number, and one for all NaN."""
        array = np.asarray(numbers, dtype=self.dtype)
        bits = array.view(f"u{array.itemsize}")
        return np.where(np.isnan(array), -1, bits.astype(object)).tolist()


REALS = [Real("f64", atraj, np.float64, "d"), Real("f32", atraj.f32, np.float32, "f")]


def rows(table):
    """The rows of a table, without its head."""
    with open(DIRECTORY / f"{table}.csv") as file:
        found = list(csv.reader(file))[1:]
    assert found, table
    return found
