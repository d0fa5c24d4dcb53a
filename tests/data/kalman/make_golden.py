#!/usr/bin/env python3
"""Writes golden.json beside this script: a Kalman filter over travel whose recording is missing, or partly trusted, at times.

Equations (12) to (24) of the punch paper, written with NumPy's matrices and nothing of Palpate. A hand closes, rests, opens and closes
again, beyond both ends of the recording. Where the recorded force is missing its correction is left out. Where it is trusted by a share
s in (0, 1), it has the variance (R + (1 - s) P11) / s. Deterministic; needs Debian's python3-numpy.
"""
import json
import math
import pathlib

import numpy as np

STEPS = 120
R_ELEMENTS, R_RECORDED, WANDERING = 0.001, 7.742, 7.0275
FIRST, LAST, RAMP = 2.1, 10.8, 1.5  # of the recording [travel units]

READINGS = {
    "as-printed": [[7.0275, 0.02772], [0.2772, 6.1024]],
    "symmetrised": [[7.0275, 0.2772], [0.2772, 6.1024]],
    "state-order": [[6.1024, 0.2772], [0.2772, 7.0275]],
    "product": [[7.0275, 6.5486], [6.5486, 6.1024]],
}
SCHEMES = ("paper-text", "authors-firmware", "sequential", "space-domain")


def travel(step):
    """From 0 to 13 travel units, a rest in the recording and one beyond it, back to 1, and again to 13."""
    way = [(0, 0.0), (30, 6.5), (38, 6.5), (58, 13.0), (66, 13.0), (95, 1.0), (STEPS - 1, 13.0)]
    return float(np.interp(step, [s for s, _ in way], [t for _, t in way]))


def trust(place):
    return min(max(min(place - FIRST, LAST - place) / RAMP, 0.0), 1.0)


def elastic(place):
    return min(max(12.0 / 7.0 * (place - 4.0), 0.0), 7.0)


def recorded(place):
    return 1.7 * max(place - 3.8, 0.0) * math.exp(-0.08 * place) if trust(place) > 0.0 else 0.0


class Filter:
    def __init__(self, scheme, q):
        self.scheme, self.q = scheme, np.array(q)
        self.x = np.zeros((2, 1))
        self.p = self.q.copy()
        self.turn = 0

    def predict(self, way):
        a = np.array([[1.0, way], [0.0, 1.0]])
        q = self.q
        if self.scheme == "space-domain":
            q = WANDERING * np.array([[abs(way) ** 3 / 3.0, way * abs(way) / 2.0], [way * abs(way) / 2.0, abs(way)]])
        self.x = a @ self.x
        self.p = a @ self.p @ a.T + q

    def correct(self, force, variance):
        h = np.array([[1.0, 0.0]])
        gain = self.p @ h.T @ np.linalg.inv(h @ self.p @ h.T + variance)
        self.x = self.x + gain @ (force - h @ self.x)
        self.p = (np.eye(2) - gain @ h) @ self.p

    def correct_recorded(self, force, share):
        if share == 0.0:
            return  # no measurement: a prediction only
        self.correct(force, (R_RECORDED + (1.0 - share) * self.p[0, 0]) / share)

    def step(self, way, elastic_force, recorded_force, share):
        self.predict(way)
        if self.scheme == "paper-text":
            if self.turn % 2 == 0:
                self.correct(elastic_force, R_ELEMENTS)
            else:
                self.correct_recorded(recorded_force, share)
            self.turn += 1
            return
        self.correct(elastic_force, R_ELEMENTS)
        if self.scheme == "authors-firmware":
            self.predict(way)
        self.correct_recorded(recorded_force, share)


def digits(numbers):
    return [float(f"{number:.13g}") for number in numbers]


def main():
    places = [travel(step) for step in range(STEPS)]
    ways = [0.0] + [after - before for before, after in zip(places, places[1:])]
    ways = digits(ways)
    elastics, recordeds, shares = (digits(map(f, places)) for f in (elastic, recorded, trust))
    golden = {"travelled": ways, "elastic": elastics, "recorded": recordeds, "trust": shares, "cases": []}
    for scheme in SCHEMES:
        for reading, q in READINGS.items():
            if scheme == "space-domain" and reading == "as-printed":
                continue  # that Q is one per step
            kalman = Filter(scheme, q)
            forces, variances = [], []
            for step in zip(ways, elastics, recordeds, shares):
                kalman.step(*step)
                forces.append(kalman.x[0, 0])
                variances.append(kalman.p[0, 0])
            golden["cases"].append({"scheme": scheme, "process": reading, "force": digits(forces),
                                    "variance": digits(variances)})
    text = json.dumps(golden, separators=(",", ":")).replace(",\"", ",\n\"").replace("},{", "},\n{")
    pathlib.Path(__file__).with_name("golden.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
