#!/usr/bin/env python3
"""Draws the rosette of sensors/livox_mid70.yaml beside a recorded one: docs/images/rosette_comparison.png.

Usage: rosette_comparison.py MID40.pcd PICTURE.png

The recording is of a Livox Mid-40, same prisms, 38.4 degrees: 3 s in firing order, beams without return left out. Needs
numpy, matplotlib and PyYAML. The figures that it prints are those of docs/simulator.md.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import yaml

RADIUS_DEG = 19.2
MIDDLE_DEG = -0.396 - 0.497j  # boresight of the recorded sensor in its own frame
CELL_DEG = 0.2


def read_recorded(path):
    data = pathlib.Path(path).read_bytes()
    start = data.index(b"DATA binary\n") + len(b"DATA binary\n")
    x, y, z, _ = np.frombuffer(data[start : start + (len(data) - start) // 16 * 16], "<f4").reshape(-1, 4).T
    angle = np.degrees(np.arctan2(np.hypot(y, z), x))
    return angle * np.exp(1j * np.arctan2(z, y)) - MIDDLE_DEG


def simulate(seconds, start_s=0.0):
    file = pathlib.Path(__file__).parent.parent / "sensors" / "livox_mid70.yaml"
    pattern = yaml.safe_load(file.read_text())["pattern"]
    t = start_s + np.arange(int(seconds * pattern["points_per_s"])) / pattern["points_per_s"]
    turn = 2j * np.pi * pattern["prism_hz"] * t
    share = pattern["prism_share"]
    return RADIUS_DEG * (share * np.exp(turn) + (1 - share) * np.exp(turn * pattern["prism_ratio"]))


def recorded_times(deflections, petals_per_s):
    """Time of each point by the petals before it: lost beams leave the count of points behind the clock."""
    near = np.flatnonzero(np.abs(deflections) < 2.0)
    groups = np.split(near, np.flatnonzero(np.diff(near) > 1) + 1)
    starts = [group[np.argmin(np.abs(deflections[group]))] for group in groups]
    return np.interp(np.arange(deflections.size), starts, np.arange(len(starts)) / petals_per_s)


def in_sector(deflections):
    """The third of the circle below the horizon, where next to no beam was lost."""
    angle = np.degrees(np.angle(deflections))
    return (angle > -150) & (angle < -30) & (np.abs(deflections) < RADIUS_DEG - 0.1)


def coverage(deflections):
    """Share of the cells of the sector that hold a point."""
    grid = (np.arange(-100, 100) + 0.5) * CELL_DEG
    cells = in_sector(grid[:, None] + 1j * grid[None, :]).sum()
    inside = deflections[in_sector(deflections)]
    return len(set(zip(np.floor(inside.real / CELL_DEG), np.floor(inside.imag / CELL_DEG)))) / cells


def main(recording, picture):
    real = read_recorded(recording)
    times = recorded_times(real, 200.5)
    made = simulate(3.0)
    figure, axes = plt.subplots(2, 3, figsize=(13, 8.6))
    for row, (name, points, clock) in enumerate(
        [("recorded, Mid-40", real, times), ("simulated", made, np.arange(made.size) / 1e5)]
    ):
        for column, seconds in enumerate((0.1, 1.0)):
            shown = points[clock < seconds]
            axes[row, column].plot(shown.real, shown.imag, ".", markersize=1.2 if column == 0 else 0.5, color="#1f4e79")
            axes[row, column].set(title=f"{name}, {seconds:g} s", aspect="equal", xlim=(-20, 20), ylim=(-20, 20))
            axes[row, column].set(xlabel="to the left (deg)", ylabel="up (deg)")

    edges = np.arange(2, 20, 0.5)
    for name, points, style in (("recorded", real, "-"), ("simulated", made, "--")):
        density, _ = np.histogram(np.abs(points[in_sector(points)]), edges, density=True)
        axes[0, 2].plot(edges[:-1] + 0.25, density, style, label=name)
    axes[0, 2].set(title="beams per degree from the middle", xlabel="angle to the boresight (deg)")
    axes[0, 2].legend()

    spans = (0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 2.5)
    real_share = [coverage(real[times < span]) for span in spans]
    made_share = [np.mean([coverage(simulate(span, start)) for start in (0.0, 3.7, 7.1)]) for span in spans]
    for span, recorded, simulated in zip(spans, real_share, made_share):
        print(f"{span:.1f} s: recorded {recorded:.3f}, simulated {simulated:.3f}")
    axes[1, 2].plot(spans, real_share, "-o", label="recorded")
    axes[1, 2].plot(spans, made_share, "--o", label="simulated")
    axes[1, 2].set(title=f"share of {CELL_DEG} degree cells that were hit", xlabel="time (s)", ylim=(0, 1))
    axes[1, 2].legend()
    figure.tight_layout()
    figure.savefig(picture, dpi=80)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
