"""Which jerk limit halves the residual vibration of a 5 Hz load, and what does it cost in time? Does a shaper cost less?

    pip install './python[plot]'
    python python/examples/vibration.py docs/img/vibration.svg docs/img/shaper-or-jerk.svg

An axis carries a load on a spring: a gripper on a long finger, a glass on a tray. Seen from the axis, the load at y obeys

    y'' + 2 D w y' + w^2 y = -a(t)

with the acceleration a of the axis. After the move the load swings on at its own frequency, and the residual vibration is the
amplitude of this swing. A lower jerk limit makes the acceleration rise and fall in longer ramps. A ramp that lasts one period of
the load leaves no vibration.

Who does not know the frequency well needs more. The second part compares shapers with lower jerks that leave as little where the frequency
may be wrong by 20 %.
"""

from __future__ import annotations

import io
import math
import re
import sys
from typing import TYPE_CHECKING, Any

import numpy as np

import numpy.typing as npt

import atraj

if TYPE_CHECKING:
    from matplotlib.figure import Figure, SubFigure

    Array = npt.NDArray[np.float64]

DISTANCE = 0.5  # m
VELOCITY = 1.0  # m/s
ACCELERATION = 4.0  # m/s^2
FREQUENCY = 5.0  # Hz
DAMPING = 0.01  # of the critical damping
WRONG = 0.2  # of the frequency
SAMPLES = 8001

POLE = 2 * math.pi * FREQUENCY * complex(-DAMPING, math.sqrt(1 - DAMPING**2))  # 1/s


def plan(jerk: float) -> atraj.Move:
    """The fastest move over the distance. An infinite jerk makes it a trapezoid."""
    limits = atraj.Limits(jerk=jerk, acceleration=ACCELERATION, velocity=VELOCITY)
    return atraj.Move.plan(limits, 0, DISTANCE)


def load(move: atraj.Move, t: float, pole: Any = POLE) -> Any:
    """The swing of the load at the time t: its imaginary part is y, its magnitude the amplitude. Exact, phase by phase. An array of poles gives
    the swings of as many loads."""
    swing = 0 * pole
    for phase in move.phases:
        d = min(phase.duration, t - phase.start)
        if d > 0:
            moved = (np.exp(pole * d) - 1) / pole
            driven = phase.acceleration * moved + phase.jerk * (moved - d) / pole
            swing = swing - np.exp(pole * (t - phase.start - d)) * driven / pole.imag
    return swing


def residual(jerk: float) -> float:
    """Residual vibration with this jerk limit, m."""
    move = plan(jerk)
    return float(abs(load(move, move.t)))


def halving_jerk() -> float:
    """The highest jerk limit that leaves half of the vibration, m/s^3. Scans downwards, then halves the last step."""
    half = residual(math.inf) / 2
    low = 1000 * ACCELERATION
    while residual(low) > half:
        low /= 1.01
    high = 1.01 * low
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if residual(middle) <= half else (low, middle)
    return low


def quietest_jerk(below: float) -> float:
    """The jerk limit that leaves least of the vibration, between half of `below` and `below`, m/s^3."""
    jerks = np.linspace(below / 2, below, 5001)
    return float(min(jerks, key=residual))


def report(name: str, jerk: float) -> None:
    """Prints what a jerk limit leaves and what it costs."""
    trapezoid, move = plan(math.inf), plan(jerk)
    left, cost = residual(jerk), move.t - trapezoid.t
    print(
        f"{name}: jerk {jerk:.2f} m/s^3, vibration {1e3 * left:.3f} mm ({left / residual(math.inf):.1%}), "
        f"{move.t:.4f} s, {cost:+.4f} s ({cost / trapezoid.t:+.1%})"
    )


def residuals(motion: atraj.Profile, frequencies: Array) -> Array:
    """Residual vibration of loads of these frequencies, m."""
    poles = 2 * np.pi * frequencies * complex(-DAMPING, math.sqrt(1 - DAMPING**2))
    if isinstance(motion, atraj.Move):
        return np.asarray(np.abs(load(motion, motion.t, poles)))
    # The velocity is continuous and ends at rest, so its sum is as good as an integral.
    t, _, v, _, _ = motion.sample(n=SAMPLES)
    moved = np.array([(np.exp(pole * (motion.t - t)) * v).sum() for pole in poles]) * (t[1] - t[0])
    return np.asarray(np.abs(poles * moved) / poles.imag)


def worst(motion: atraj.Profile) -> float:
    """The largest residual vibration where the frequency may be wrong, m."""
    return float(residuals(motion, FREQUENCY * np.linspace(1 - WRONG, 1 + WRONG, 21)).max())


Compared = list[tuple[str, atraj.Profile, atraj.Move]]
"""Kinds of shapers, shaped moves, and moves with a lower jerk that leave as little."""


def compare() -> Compared:
    """A shaper of each kind and a lower jerk."""
    shaped = [atraj.Shaper(kind, FREQUENCY, DAMPING).shape(plan(math.inf)) for kind in atraj.ShaperKind]
    # What is left does not fall evenly with the jerk, so every jerk is tried, down to one that suits the gentlest shaper.
    leaves = [worst(motion) for motion in shaped]
    jerk = 1000 * ACCELERATION
    tried = [(worst(plan(jerk)), plan(jerk))]
    while tried[-1][0] > min(leaves):
        jerk *= 0.995
        move = plan(jerk)
        tried.append((worst(move), move))
    gentle = [next(move for left, move in tried if left <= most) for most in leaves]
    return [(kind.name, motion, move) for kind, motion, move in zip(atraj.ShaperKind, shaped, gentle)]


DARK = "<style>@media (prefers-color-scheme: dark) {svg {filter: invert(.93) hue-rotate(180deg)}}</style>"
"""What readers of dark pages see."""


def style() -> Any:
    """Text stays text, the same picture has the same bytes, and curves have no more points than they need."""
    import matplotlib.pyplot as plt

    return plt.rc_context({"svg.fonttype": "none", "svg.hashsalt": "atraj", "path.simplify_threshold": 0.3})


def save(figure: Figure, file: str) -> None:
    """Saves a picture as SVG. Its numbers have one decimal, and a path stands on one line."""
    svg = io.StringIO()
    figure.savefig(svg, format="svg", metadata=dict.fromkeys(["Creator", "Date", "Format", "Type"]))
    text = re.sub(r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.1f}", svg.getvalue())
    text = re.sub(r"\s*\n\s*(?=[MLQCz\"]|</)", " ", text).replace(" <defs>", f" {DARK}\n <defs>", 1)
    with open(file, "w", encoding="utf-8") as out:
        out.write(text)


Shown = list[tuple[str, float, str]]
"""What a picture shows: names, jerk limits and colours."""


def draw_limits(figure: SubFigure, shown: Shown) -> None:
    """Draws vibration and duration over the jerk limit."""
    vibration, duration = figure.subplots(2, sharex=True)
    jerks = np.geomspace(8, 800, 400)
    vibration.plot(jerks, [1e3 * residual(jerk) for jerk in jerks], color="0.3")
    duration.plot(jerks, [plan(jerk).t for jerk in jerks], color="0.3")
    for _, jerk, color in shown:
        for axis, value in [(vibration, 1e3 * residual(jerk)), (duration, plan(jerk).t)]:
            if math.isinf(jerk):
                axis.axhline(value, color=color, linestyle="--")
            else:
                axis.plot(jerk, value, "o", color=color, clip_on=False, zorder=3)
    vibration.set(ylabel="residual vibration, mm", ylim=(0, 1.15e3 * residual(math.inf)))
    duration.set(ylabel="duration, s", ylim=(0.6, 1.4))
    duration.set(xlabel="jerk limit, m/s³", xscale="log", xticks=[10, 30, 100, 300])
    duration.set_xticks([], minor=True)
    duration.xaxis.set_major_formatter("{x:.0f}")


def draw_swings(figure: SubFigure, shown: Shown) -> None:
    """Draws how the load swings, for each jerk limit."""
    axes = figure.subplots(len(shown), sharex=True, sharey=True)
    times = np.linspace(0, 1.6, 500)
    for axis, (name, jerk, color) in zip(axes, shown):
        move = plan(jerk)
        axis.axvspan(0, move.t, color="0.93")
        axis.plot(times, [1e3 * load(move, t).imag for t in times], color=color)
        title = f"{name}: {move.t:.2f} s, leaves {1e3 * residual(jerk):.1f} mm"
        axis.set_title(title, loc="left", fontsize=10, color=color)
    axes[1].set_ylabel("load relative to the axis, mm")
    axes[-1].set(xlabel="time, s; grey: the axis moves", xlim=(0, times[-1]))


def draw_comparison(file: str, compared: Compared) -> None:
    """Draws vibration over the frequency of the load, and the durations, as SVG."""
    import matplotlib.pyplot as plt

    with style():
        figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
        frequencies = FREQUENCY * np.linspace(0.6, 1.4, 161)
        left.axvspan(FREQUENCY * (1 - WRONG), FREQUENCY * (1 + WRONG), color="0.93")
        left.plot(frequencies, 1e3 * residuals(plan(math.inf), frequencies), color="0.3", label="no shaper")
        for (name, shaped, _), color in zip(compared, ["tab:blue", "#cc5500", "tab:green", "tab:brown", "tab:purple"]):
            left.plot(frequencies, 1e3 * residuals(shaped, frequencies), label=name, color=color)
        left.set(xlabel="true frequency of the load, Hz", ylabel="residual vibration, mm", ylim=(0, 6))
        left.set_xlim(frequencies[0], frequencies[-1])
        left.legend(loc="upper right")
        places = np.arange(len(compared))
        right.bar(places - 0.2, [shaped.t for _, shaped, _ in compared], 0.4, label="with the shaper")
        right.bar(places + 0.2, [lower.t for _, _, lower in compared], 0.4, label="with a lower jerk", color="0.6")
        right.axhline(plan(math.inf).t, color="0.3", linestyle="--", label="neither, and swings")
        right.set(ylabel="duration, s", xticks=places, ylim=(0, 3.5))
        right.set_xticklabels([f"{name}\n{1e3 * worst(shaped):.2f} mm" for name, shaped, _ in compared])
        right.legend(loc="upper left")
        save(figure, file)


def draw(file: str, half: float, quiet: float) -> None:
    """Draws the picture as SVG."""
    import matplotlib.pyplot as plt

    shown = [
        ("No jerk limit", math.inf, "#cc5500"),
        (f"{half:.0f} m/s³, half the vibration", half, "tab:blue"),
        (f"{quiet:.0f} m/s³, ramps of one period", quiet, "tab:green"),
    ]
    with style():
        figure = plt.figure(figsize=(9, 5), layout="constrained")
        left, right = figure.subfigures(1, 2, squeeze=False)[0]
        draw_limits(left, shown)
        draw_swings(right, shown)
        save(figure, file)


def main() -> None:
    trapezoid, half = plan(math.inf), halving_jerk()
    quiet = quietest_jerk(below=half)
    print(f"no jerk limit: vibration {1e3 * residual(math.inf):.3f} mm, {trapezoid.t:.4f} s")
    report("half", half)
    report("a ramp of one period", quiet)
    compared = compare()
    for name, shaped, lower in compared:
        print(f"{name}: at most {1e3 * worst(shaped):.2f} mm, {shaped.t:.3f} s; with a lower jerk {lower.t:.3f} s")
    for file in sys.argv[1:2]:
        draw(file, half, quiet)
    for file in sys.argv[2:]:
        draw_comparison(file, compared)


if __name__ == "__main__":
    main()
