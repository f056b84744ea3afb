"""Pictures of profiles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from . import Path, Profile

QUANTITIES = ["position", "velocity", "acceleration", "jerk"]


def plot(profile: Profile | Path) -> Figure:
    """Position, velocity, acceleration and jerk over time, under each other. A trapezoid has no jerk to show."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot needs matplotlib: pip install 'atraj[plot]'") from error
    t, *curves = profile.sample(n=1001)
    shown = [(name, y) for name, y in zip(QUANTITIES, curves) if not np.isnan(y).all()]
    figure, axes = plt.subplots(len(shown), sharex=True, layout="constrained")
    for axis, (name, y) in zip(axes, shown):
        axis.plot(t, y)
        axis.set_ylabel(name)
        axis.grid(alpha=0.3)
    axes[-1].set_xlabel("time, s")
    figure.align_ylabels()
    return figure


def plot_path(path: Path) -> Figure:
    """The same for several axes, in a colour each, with a dot at each way point."""
    figure = plot(path)
    positions = figure.axes[0]
    positions.legend(positions.lines, [f"axis {k}" for k in range(len(positions.lines))])
    positions.plot(path.times, path.position(path.times), "k.")
    return figure
