"""Is the answer that the example prints right? The load is integrated here by the rule of Runge and Kutta along a double-S of liba."""

import math
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import atraj

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "python/examples/vibration.py"
PICTURES = ["vibration.svg", "shaper-or-jerk.svg"]

DISTANCE, VELOCITY, ACCELERATION = 0.5, 1.0, 4.0  # m, m/s, m/s^2
W, D = 2 * math.pi * 5, 0.01  # rad/s, and of the critical damping
STEPS = 4000


def amplitude(jerk):
    """Amplitude of the swing at the end of the move, m."""
    move = atraj.Bell(jerk, ACCELERATION, VELOCITY, 0, DISTANCE)
    a = move.sample(n=2 * STEPS + 1).a.tolist()
    dt = move.t / STEPS

    def slope(y, v, a):
        return v, -a - 2 * D * W * v - W * W * y

    y = v = 0.0
    for k in range(0, 2 * STEPS, 2):
        k1, l1 = slope(y, v, a[k])
        k2, l2 = slope(y + dt / 2 * k1, v + dt / 2 * l1, a[k + 1])
        k3, l3 = slope(y + dt / 2 * k2, v + dt / 2 * l2, a[k + 1])
        k4, l4 = slope(y + dt * k3, v + dt * l3, a[k + 2])
        y, v = y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4), v + dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
    return math.hypot(y, (v + D * W * y) / (W * math.sqrt(1 - D * D)))


def run(*arguments):
    command = [sys.executable, str(EXAMPLE), *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


@pytest.fixture(scope="module")
def printed():
    """Name, and numbers of each printed line."""
    return {line.split(":")[0]: [float(x) for x in re.findall(r"[-+]?\d+\.\d+", line)] for line in run()}


def test_without_a_limit(printed):
    vibration, duration = printed["no jerk limit"]
    assert amplitude(1e5) * 1e3 == pytest.approx(vibration, rel=2e-3)  # a step is longer than the ramps
    assert duration == DISTANCE / VELOCITY + VELOCITY / ACCELERATION


@pytest.mark.parametrize("name", ["half", "a ramp of one period"])
def test_each_limit(printed, name):
    jerk, vibration, percent, duration, cost, cost_percent = printed[name]
    unlimited, shortest = printed["no jerk limit"]
    assert amplitude(jerk) * 1e3 == pytest.approx(vibration, abs=2e-3)
    assert percent == pytest.approx(100 * vibration / unlimited, abs=0.06)
    assert cost == pytest.approx(ACCELERATION / jerk, abs=1e-4)
    assert duration == pytest.approx(shortest + cost, abs=1e-4)
    assert cost_percent == pytest.approx(100 * cost / shortest, abs=0.06)


def test_half_is_half_and_no_higher_limit_halves(printed):
    jerk, unlimited = printed["half"][0], printed["no jerk limit"][0]
    assert amplitude(jerk) * 1e3 == pytest.approx(unlimited / 2, rel=1e-3)
    assert all(amplitude(higher) * 1e3 > unlimited / 2 for higher in np.geomspace(1.01 * jerk, 100 * jerk, 60))


def test_one_period(printed):
    jerk = printed["a ramp of one period"][0]
    assert ACCELERATION / jerk == pytest.approx(2 * math.pi / W, rel=2e-3)


def test_the_page_says_so(printed):
    jerk, *_, cost_percent = printed["half"]
    page = (ROOT / "docs/for-python.md").read_text().replace("\n", " ")
    assert f"answers: {jerk:.1f} m/s³, and the move takes {cost_percent:.0f} % longer" in page


KINDS = ["ZV", "ZVD", "MZV", "EI", "EI2"]


@pytest.mark.parametrize("kind", KINDS)
def test_the_page_of_the_shapers_says_so(printed, kind):
    """The table of that page is computed in Rust, in another way."""
    row = re.search(rf"^\| {kind} \|(.*)", (ROOT / "docs/machine.md").read_text().split("wrong by 20 %")[-1], re.M)[1]
    *_, vibration, with_shaper, with_jerk = [float(x) for x in re.findall(r"\d+\.\d+", row)]
    assert printed[kind] == [vibration, with_shaper, pytest.approx(with_jerk, abs=0.0011)]


def test_a_shaper_costs_less_than_a_lower_jerk(printed):
    for kind in KINDS:
        _, with_shaper, with_jerk = printed[kind]
        assert with_shaper < with_jerk
    page = (ROOT / "docs/for-python.md").read_text().replace("\n", " ")
    left, with_shaper, with_jerk = printed["EI"]
    assert f"{left:.2f} mm in {with_shaper:.2f} s with EI, and {with_jerk:.2f} s with a lower jerk" in page


def test_pictures(tmp_path):
    run(*[tmp_path / name for name in PICTURES])
    for name in PICTURES:
        committed = (ROOT / "docs/img" / name).read_text()
        assert (tmp_path / name).read_text() == committed, f"draw docs/img/{name} again"
