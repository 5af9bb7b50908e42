#!/usr/bin/python3
"""Writes synthetic-quake.csv beside itself: an invented ground motion, the same on every machine.

a(t) = envelope(t) x sum of sines from 0.5 to 12 Hz, their phases spread by the golden ratio, scaled to 0.15 g. The
envelope rises over 2 s as a square, stays until 8 s and decays with a time of 3 s. The linear acceleration that would
leave the ground moving at the end is taken off.
"""

import math
import pathlib

STEP, LENGTH = 0.02, 20.0  # [s]
PEAK = 0.15 * 9.80665  # [m/s2]
WAVES = 24
GOLDEN = (math.sqrt(5) - 1) / 2


def envelope(t):
    return (t / 2) ** 2 if t < 2 else 1.0 if t < 8 else math.exp(-(t - 8) / 3)


def drift(a):
    """Velocity and displacement at the end, for an acceleration linear between rows."""
    velocity = displacement = 0.0
    for first, second in zip(a, a[1:]):
        displacement += STEP * velocity + STEP**2 * (2 * first + second) / 6
        velocity += STEP * (first + second) / 2
    return velocity, displacement


def main():
    times = [k * STEP for k in range(round(LENGTH / STEP) + 1)]
    waves = [(0.5 * (12 / 0.5) ** (k / (WAVES - 1)), 2 * math.pi * (k * GOLDEN % 1)) for k in range(WAVES)]
    a = [envelope(t) * sum(math.sin(2 * math.pi * f * t + phase) for f, phase in waves) for t in times]
    velocity, displacement = drift(a)
    slope = 12 * (velocity * LENGTH / 2 - displacement) / LENGTH**3
    start = velocity / LENGTH - slope * LENGTH / 2
    a = [value - start - slope * t for value, t in zip(a, times)]
    scale = PEAK / max(abs(value) for value in a)
    rows = [f"{t:.2f}, {scale * value:.6f}" for t, value in zip(times, a)]
    text = "# made by make_synthetic_quake.py: time [s], acceleration [m/s2]\n" + "\n".join(rows) + "\n"
    pathlib.Path(__file__).with_name("synthetic-quake.csv").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
