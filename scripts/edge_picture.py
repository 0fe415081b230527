#!/usr/bin/env python3
"""Draws a scan from above with the edges that a run found in it: left ones red, right ones blue, drops as triangles.

Usage: edge_picture.py RUN SCAN PICTURE.png [RANGE_M]

RUN is the output folder of `berm run` with an edge method, SCAN a file of its recording: KITTI's .bin, or a PCD in
binary. Where labels lie beside the scans, road is dark and sidewalk green, else grey says height. Needs numpy and
matplotlib.
"""
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROAD, SIDEWALK = 40, 48
CODES = {"F": "f", "I": "i", "U": "u"}


def read_pcd(data):
    start = data.index(b"DATA binary\n") + len(b"DATA binary\n")
    header = {line.split()[0]: line.split()[1:] for line in data[:start].decode().splitlines() if line[0] != "#"}
    columns = zip(header["FIELDS"], header["SIZE"], header["TYPE"], header["COUNT"])
    row = np.dtype([(f"{i}{name}" if name == "_" else name, f"<{CODES[code]}{size}", (int(count),))
                    for i, (name, size, code, count) in enumerate(columns)])
    points = np.frombuffer(data[start:], row, int(header["POINTS"][0]))
    return np.column_stack([points[name][:, 0] for name in "xyz"]).astype(float)


def read_scan(path):
    data = path.read_bytes()
    return np.frombuffer(data, "<f4").reshape(-1, 4)[:, :3].astype(float) if path.suffix == ".bin" else read_pcd(data)


def to_base(points, mount):
    """The mount of the machine: yaw, then pitch, then roll."""
    yaw, pitch, roll = (np.radians(mount[f"{angle}_deg"]) for angle in ("yaw", "pitch", "roll"))
    about_z = np.array([[np.cos(yaw), -np.sin(yaw), 0], [np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
    about_y = np.array([[np.cos(pitch), 0, np.sin(pitch)], [0, 1, 0], [-np.sin(pitch), 0, np.cos(pitch)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]])
    return points @ (about_z @ about_y @ about_x).T + [0, 0, mount["height_m"]]


def colours(scan, points):
    labels = scan.parent.parent / "labels" / f"{scan.stem}.label"
    if not labels.exists():
        return np.clip(0.85 - 0.4 * points[:, 2], 0.1, 0.9).astype(str)
    label = np.fromfile(labels, "<u4") & 0xFFFF
    return np.select([label == ROAD, label == SIDEWALK], ["#444444", "#3a9d4f"], "#cccccc")


def main(run, scan, picture, range_m=30.0):
    run, scan = pathlib.Path(run), pathlib.Path(scan)
    mount = json.loads((run / "run.json").read_text())["machine"]["mount"]
    points = to_base(read_scan(scan), mount)
    figure, axes = plt.subplots(figsize=(10, 10))
    axes.scatter(points[:, 0], points[:, 1], s=0.4, c=colours(scan, points), linewidths=0)
    with open(run / "edge_points.csv", encoding="utf-8") as file:
        edges = [row for row in csv.DictReader(file) if row["scan"] == scan.stem]
    for edge in edges:
        axes.plot(float(edge["x"]), float(edge["y"]), "^" if edge["kind"] == "drop" else "o", markersize=5,
                  color="#d62728" if edge["side"] == "left" else "#1f77b4", alpha=max(float(edge["confidence"]), 0.3))
    limit_m = float(range_m)
    axes.set(xlim=(-limit_m, limit_m), ylim=(-limit_m, limit_m), aspect="equal", xlabel="x, m", ylabel="y, m",
             title=f"{scan.stem}: {len(edges)} edge points")
    figure.savefig(picture, dpi=100, bbox_inches="tight")


if __name__ == "__main__":
    if not 4 <= len(sys.argv) <= 5 or "--help" in sys.argv:
        sys.exit(__doc__)
    main(*sys.argv[1:])
