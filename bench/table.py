#!/usr/bin/env python3
"""Prints the medians of a google-benchmark JSON file as tables: CPU time per scan, reference beside default, and both
against the yardsticks of the same run.

usage: table.py bench.json
"""
import json
import sys

YARDSTICKS = ("yardstick_memcpy", "yardstick_atan2f")


def medians_us(path):
    """{(stage, scan): CPU time in us}, of the medians over the repetitions."""
    with open(path, encoding="utf-8") as file:
        results = json.load(file)["benchmarks"]
    to_us = {"ns": 1e-3, "us": 1.0, "ms": 1e3}
    times = {}
    for result in results:
        if result.get("aggregate_name") == "median" and not result["run_name"].startswith("sim"):
            stage, scan = result["run_name"].split("/")[:2]
            times[stage, scan] = result["cpu_time"] * to_us[result["time_unit"]]
    return times


def print_simulator(path):
    """Beams per second of CPU time on one core, and what the world of 1 km takes."""
    with open(path, encoding="utf-8") as file:
        results = json.load(file)["benchmarks"]
    rows = [("simulator, world of 1 km", "M beams/s", "times real time", "MiB")]
    for result in results:
        if result.get("aggregate_name") == "median" and result["run_name"].startswith("sim/"):
            world, sensor = result["run_name"].split("/")[1:3]
            rows.append((f"{world}, {sensor}", f"{result['items_per_second'] * 1e-6:.2f}",
                         f"{result['times_real']:.1f}", f"{result['memory_mib']:.0f}"))
    if len(rows) > 1:
        print_rows(rows)


def print_rows(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        first, *rest = (cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
        print("  ".join([first, *rest]))


def by_size(times, stage):
    """Scans that the stage was measured on, smallest first."""
    scans = [scan for measured, scan in times if measured == stage]
    return sorted(scans, key=lambda scan: times.get((YARDSTICKS[1], scan), times[stage, scan]))


def print_ground(times):
    rows = [("ground, us of CPU", "default", "reference", "memcpy", "atan2f", "default / (memcpy + atan2f)",
             "reference / default")]
    for scan in by_size(times, "ground_default"):
        default, reference, memcpy, atan2f = (times.get((stage, scan), float("nan"))
                                              for stage in ("ground_default", "ground_reference", *YARDSTICKS))
        rows.append((scan, f"{default:.0f}", f"{reference:.0f}", f"{memcpy:.0f}", f"{atan2f:.0f}",
                     f"{default / (memcpy + atan2f):.2f}", f"{reference / default:.1f}"))
    print_rows(rows)


def print_others(times):
    stages = sorted({stage for stage, _ in times if not stage.startswith(("ground_", "yardstick_"))})
    if not stages:
        return
    scans = by_size(times, stages[0])
    rows = [("us of CPU", *scans)]
    for stage in stages:
        rows.append((stage, *(f"{times.get((stage, scan), float('nan')):.0f}" for scan in scans)))
    print_rows(rows)


def main():
    times = medians_us(sys.argv[1])
    if any(stage == "ground_default" for stage, _ in times):
        print_ground(times)
        print()
    print_others(times)
    print()
    print_simulator(sys.argv[1])


if __name__ == "__main__":
    main()
