#!/usr/bin/env python3
"""12 nodes of a curve and what splines of SciPy make of them: for tests/haptics/reaming/material/node_choice_test.cpp.

    python3 nodes_reference.py > nodes_golden.json      # some minutes

Python 3, NumPy 1.24, SciPy 1.10. The curve is closed: a lamella and a rise, 2001 places over 12 mm, plus 5 N so
that no force is 0. The error is max |v - s| / max(|v|, 10 N). The least largest error of 12 nodes is searched for by
scipy.optimize.differential_evolution; nobody proves that it is the least of all.
"""
import json
import sys

import numpy as np
from scipy.interpolate import CubicHermiteSpline, CubicSpline
from scipy.optimize import differential_evolution

PLACES = 2001
NODES = 12
FLOOR = 10.0


def force(mm):
    step = lambda at, width: 1.0 / (1.0 + np.exp(-(mm - at) / width))
    past = np.maximum(0.0, mm - 3.6)
    return 5.0 + 110.0 * step(3.6, 0.30) - 45.0 * step(5.2, 0.35) + 9.0 * past + 0.9 * past**2


X = 12.0 * np.arange(PLACES) / (PLACES - 1)
Y = force(X)
SLOPES = np.gradient(Y, X, edge_order=2)


def spline_of(kind, nodes):
    if kind == "cubic-natural":
        return CubicSpline(X[nodes], Y[nodes], bc_type="natural")
    return CubicHermiteSpline(X[nodes], Y[nodes], SLOPES[nodes])


def error_of(kind, nodes):
    return float(np.max(np.abs(spline_of(kind, nodes)(X) - Y) / np.maximum(np.abs(Y), FLOOR)))


def nodes_of(inner):
    nodes = np.unique(np.concatenate([[0], np.round(np.sort(inner)).astype(int), [PLACES - 1]]))
    return nodes


def search(kind):
    def cost(inner):
        nodes = nodes_of(inner)
        return error_of(kind, nodes) if len(nodes) == NODES else 1e3

    best = None
    for seed in (1, 2, 3):
        found = differential_evolution(
            cost, [(1, PLACES - 2)] * (NODES - 2), seed=seed, popsize=20, maxiter=1500, tol=1e-10, mutation=(0.3, 0.9)
        )
        if best is None or found.fun < best.fun:
            best = found
    return nodes_of(best.x)


def main():
    golden = {"made_by": "nodes_reference.py", "splines": []}
    even = [round(i * (PLACES - 1) / (NODES - 1)) for i in range(NODES)]
    for kind in ("cubic-natural", "hermite-data-slope"):
        nodes = search(kind)
        golden["splines"].append(
            {
                "kind": kind,
                "even_nodes": even,
                "even_error": error_of(kind, np.array(even)),
                "best_nodes": [int(n) for n in nodes],
                "best_error": error_of(kind, nodes),
            }
        )
    json.dump(golden, sys.stdout, indent=1)
    print()


main()
