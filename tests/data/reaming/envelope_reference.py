#!/usr/bin/env python3
"""Envelopes over depth, from the CSV files alone: for tests/haptics/reaming/material/envelope_golden_test.cpp.

    palpate material synthesise series        # seed 1
    python3 envelope_reference.py series > envelope_golden.json

Python 3, NumPy 1.24, SciPy 1.10. Written from the rule as docs/reaming.md states it, not from the program:

- up to the depth at which the first test ends, minimum, mean and maximum of all;
- a static test that ended at 800 N counts on with the force at its end;
- any other that has ended counts with the value at its end and a weight that falls from 1 to 0 over 0.5 mm;
  the mean is weighted, an extreme is the expected one where each specimen is drawn with its weight;
- no curve falls because a specimen leaves: the fall is added again, and is taken back only as far as the
  specimens that are left carry the curve above where it has been since.

Forces of dynamic tests are filtered by SciPy: Butterworth, order 4, forwards and backwards, -6 dB at 0.1 Hz.
"""
import csv
import glob
import json
import os
import re
import sys

import numpy as np
from scipy.signal import butter, sosfiltfilt

STEP = 0.01  # [mm]
HALF = 0.005  # a value is the mean of the samples so near [mm]
LEAVES_OVER = 0.5  # [mm]
LIMIT = 800.0  # [N]
CUTOFF = 0.1  # [Hz]
RATE = 100.0  # [Hz]
DEPTHS = [1, 2, 4, 6, 8, 10, 12, 14, 16, 18]  # [mm]
# What the synthetic study spoils on purpose: changed feeds, break-outs, reamed through.
LEFT_OUT = {"dynamic-1": {1, 2}, "dynamic-2": set(range(3, 11))}


def columns_of(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}


def filtered(values):
    # filtfilt squares the gain, so that -3 dB of one pass are -6 dB of both.
    return sosfiltfilt(butter(4, CUTOFF, fs=RATE, output="sos"), values, padlen=int(3 * RATE / CUTOFF))


def specimens_of(folder, test_set, quantity):
    for path in sorted(glob.glob(os.path.join(folder, f"*{test_set}.csv"))):
        number = int(re.search(r"specimen-(\d+)", path).group(1))
        if number in LEFT_OUT.get(test_set, set()):
            continue
        columns = columns_of(path)
        depth = columns["displacement_mm"] - columns["displacement_mm"][0]
        values = columns[quantity]
        if test_set != "static":
            values = filtered(values)
        yield depth, values


def at(depth, values, x):
    first, last = np.searchsorted(depth, [x - HALF, x + HALF])
    return values[first:last].mean() if last > first else np.interp(x, depth, values)


def expected(values, weights, best_first):
    order = np.argsort(values)[::-1] if best_first else np.argsort(values)
    result, left = 0.0, 1.0
    for i in order:
        result += left * weights[i] * values[i]
        left *= 1.0 - weights[i]
    return result


STATISTICS = {
    "minimum": lambda v, w: expected(v, w, False),
    "average": lambda v, w: float(np.sum(v * w) / np.sum(w)),
    "maximum": lambda v, w: expected(v, w, True),
}


def curves_of(specimens, is_static):
    ends = np.array([depth[-1] for depth, _ in specimens])
    lasts = np.array([at(depth, values, depth[-1]) for depth, values in specimens])
    is_held = is_static & (lasts >= 0.98 * LIMIT)
    places = np.arange(0.0, ends.max(), STEP)
    value = np.empty((len(places), len(specimens)))
    for s, (depth, values) in enumerate(specimens):
        value[:, s] = [at(depth, values, x) if x <= ends[s] else lasts[s] for x in places]
    past = np.maximum(0.0, places[:, None] - ends[None, :])
    weight = np.where(is_held[None, :], 1.0, np.clip(1.0 - past / LEAVES_OVER, 0.0, 1.0))
    curves = {}
    for name, statistic in STATISTICS.items():
        plain = [statistic(value[i], weight[i]) for i in range(len(places))]
        owed, moved, top = 0.0, 0.0, 0.0
        curve = [plain[0]]
        for i in range(1, len(places)):
            same_people = statistic(value[i], weight[i - 1])
            moved += same_people - plain[i - 1]  # by forces
            if owed == 0.0:
                top = moved
            elif moved > top:
                owed = max(0.0, owed - (moved - top))
                top = moved
            owed = max(0.0, owed - (plain[i] - same_people))  # by leaving
            curve.append(plain[i] + owed)
        curves[name] = np.array(curve)
    curves["average"] = np.minimum(curves["average"], curves["maximum"])
    measured = (places[:, None] <= ends[None, :]).sum(axis=1)
    held = ((places[:, None] > ends[None, :]) & is_held[None, :]).sum(axis=1)
    return places, curves, measured, held, ends.min()


def main():
    folder = sys.argv[1]
    golden = {"made_by": "envelope_reference.py of 'palpate material synthesise', seed 1", "sets": []}
    for test_set, quantity in [
        ("static", "force_n"),
        ("dynamic-1", "force_n"),
        ("dynamic-1", "torque_nm"),
        ("dynamic-2", "force_n"),
        ("dynamic-2", "torque_nm"),
    ]:
        specimens = list(specimens_of(folder, test_set, quantity))
        places, curves, measured, held, first_end = curves_of(specimens, test_set == "static")
        rows = []
        for depth in DEPTHS:
            if depth > places[-1]:
                continue
            i = int(round(depth / STEP))
            row = {"depth_mm": depth, "measured": int(measured[i]), "held": int(held[i])}
            row.update({name: round(float(curve[i]), 4) for name, curve in curves.items()})
            rows.append(row)
        golden["sets"].append(
            {
                "test_set": test_set,
                "quantity": quantity,
                "specimens": len(specimens),
                "first_end_mm": round(float(first_end), 4),
                "rows": rows,
            }
        )
    json.dump(golden, sys.stdout, indent=1)
    print()


main()
