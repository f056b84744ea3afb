"""Pictures of motions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes as Plot
    from matplotlib.figure import Figure

    from . import Axes, Limits, Profile

QUANTITIES = ["position", "velocity", "acceleration", "jerk"]
SAMPLES = 1001


def plot(
    profile: Profile,
    axes: Sequence[Plot] | None,
    limits: Limits | None,
    unit: str | None,
    label: str | None,
    offset: float,
) -> Figure:
    """Position, velocity, acceleration and jerk over time, under each other. A trapezoid has no jerk to show."""
    t, *curves = profile.sample(n=SAMPLES)
    t = t + offset
    shown = [k for k, y in enumerate(curves) if not np.isnan(y).all()]
    plots = plots_over_time(len(shown), axes, unit)
    for k, place in zip(shown, plots):
        (line,) = place.plot(t, curves[k], label=label)
        draw_limits(place, k, limits, line.get_color())
    if label is not None:
        plots[0].legend()
    return whole(plots[0])


def plot_axes(
    motion: Axes,
    axes: Sequence[Plot] | None,
    limits: Sequence[Limits] | None,
    unit: str | None,
    labels: Sequence[str] | None,
    plane: tuple[int, int] | None,
    offset: float,
) -> Figure:
    """The same for several axes, in a colour each, with a dot at each waypoint."""
    t, *curves = motion.sample(n=SAMPLES)
    times = getattr(motion, "times", t[[0, -1]])
    points = motion.position(times)
    t, times = t + offset, times + offset
    names = [f"axis {k}" for k in range(points.shape[1])] if labels is None else list(labels)
    if plane is not None:
        return plot_plane(curves[0], points, axes, unit, names, plane)
    plots = plots_over_time(len(QUANTITIES), axes, unit)
    for k, (place, rows) in enumerate(zip(plots, curves)):
        for axis, name in enumerate(names):
            (line,) = place.plot(t, rows[:, axis], label=name)
            draw_limits(place, k, None if limits is None else limits[axis], line.get_color())
    for axis in range(len(names)):
        plots[0].plot(times, points[:, axis], "k.")
    plots[0].legend()
    return whole(plots[0])


def plot_plane(
    positions: Any, points: Any, axes: Sequence[Plot] | None, unit: str | None, names: list[str], plane: tuple[int, int]
) -> Figure:
    """Two axes in their plane, on equal scales."""
    if max(plane) >= len(names):
        raise ValueError(f"the plane {plane} needs an axis {max(plane)}, and there are {len(names)} axes")
    place = figure_of(1)[0] if axes is None else np.ravel(np.asarray(axes, dtype=object))[0]
    x, y = plane
    place.plot(positions[:, x], positions[:, y])
    place.plot(points[:, x], points[:, y], "k.")
    place.set(xlabel=titled(names[x], 0, unit), ylabel=titled(names[y], 0, unit), aspect="equal")
    place.grid(True, alpha=0.3)
    return whole(place)


def plots_over_time(count: int, axes: Sequence[Plot] | None, unit: str | None) -> list[Plot]:
    """The places of the quantities, under each other."""
    if axes is not None:
        places = list(np.ravel(np.asarray(axes, dtype=object)))
        if len(places) < min(count, 3):
            raise ValueError(f"axes has {len(places)} places, and {count} quantities are drawn")
        return places
    places = figure_of(count)
    for k, place in enumerate(places):
        place.set_ylabel(titled(QUANTITIES[k], k, unit))
        place.grid(True, alpha=0.3)
    places[-1].set_xlabel("time, s")
    whole(places[0]).align_ylabels()
    return places


def figure_of(count: int) -> list[Plot]:
    """The places of a new figure, under each other."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot needs matplotlib: pip install 'atraj[plot]'") from error
    size = (6.4, max(4.8, 1.8 * count))  # inches
    figure, places = plt.subplots(count, figsize=size, sharex=True, squeeze=False, layout="constrained")
    return list(places[:, 0])


def whole(place: Plot) -> Figure:
    """The figure of a place."""
    return cast("Figure", place.figure)


def titled(name: str, derivative: int, unit: str | None) -> str:
    """A name with its unit: that of the position by a power of seconds."""
    if unit is None:
        return name
    return f"{name}, {unit}{['', '/s', '/s²', '/s³'][derivative]}"


def draw_limits(place: Plot, derivative: int, limits: Limits | None, color: Any) -> None:
    """The limits of a derivative of the position as dashed lines. An infinite limit is none."""
    if limits is None or derivative == 0:
        return
    for limit in list(limits)[2 * derivative - 2 : 2 * derivative]:
        if np.isfinite(limit):
            place.axhline(limit, color=color, linestyle="--", linewidth=0.8)
