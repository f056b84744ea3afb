"""Plans each path of the standard input with toppra, and prints the sums of the durations in seconds and of the times in milliseconds."""

import json
import sys
import time

import numpy
import toppra
import toppra.algorithm
import toppra.constraint

toppra.setup_logging("ERROR")
STATIONS = numpy.linspace(0, 1, 1001)


def duration(path):
    points = numpy.array(path["points"])
    spline = toppra.SplineInterpolator(numpy.linspace(0, 1, len(points)), points)
    limits = [
        toppra.constraint.JointVelocityConstraint(numpy.array(path["velocity"])),
        toppra.constraint.JointAccelerationConstraint(numpy.array(path["acceleration"])),
    ]
    planner = toppra.algorithm.TOPPRA(limits, spline, gridpoints=STATIONS, parametrizer="ParametrizeConstAccel")
    return planner.compute_trajectory(0, 0).duration


paths = [json.loads(line) for line in sys.stdin]
start = time.perf_counter()
seconds = sum(duration(path) for path in paths)
print(seconds, 1e3 * (time.perf_counter() - start))
