#!/usr/bin/env python3
"""Writes golden.json beside this script: filters, spectrum and calibration of recordings by SciPy and NumPy.

  taps        firwin with a Kaiser window of beta 5.653, -6 dB at 17.69075 Hz, at the authors' nominal rate and at others
  butterworth freqz of butter(4), squared since it runs forwards and backwards; filtfilt of a signal, far from its ends
  spectrum    rfft of a signal without the line from its first to its last sample, under a Hann window
  calibration polyfit of a table of readings and loads; without a constant numpy.linalg.lstsq

Deterministic; Python 3.11, NumPy 1.24.2, SciPy 1.10.1 (Debian 12). Nothing of Palpate is used.
"""
import json
import math
import pathlib

import numpy as np
from scipy import signal

CUTOFF, BETA = 17.69075, 5.653


def taps():
    rows = []
    for count, rate in ((49, 1000.0 / 3.0), (55, 373.0), (145, 1000.0)):
        h = signal.firwin(count, CUTOFF, window=("kaiser", BETA), fs=rate)
        rows.append({"taps": count, "rate_hz": rate, "from_the_middle": h[count // 2:].tolist()})
    return rows


def sample(i, rate):
    """A slow stroke and three lines, of a hand and of a noise."""
    t = i / rate
    return (10 * math.sin(0.4 * math.pi * t) ** 2 + 0.5 * math.sin(2 * math.pi * 3 * t)
            + 0.3 * math.sin(2 * math.pi * 8 * t) + 0.1 * math.sin(2 * math.pi * 50 * t))


def butterworth():
    rows = []
    for rate, cutoff in ((1000.0, 5.0), (1000.0, 20.0), (373.0, 5.0)):
        b, a = signal.butter(4, cutoff, fs=rate)
        frequencies = [0.5, 1, 2, 4, 5, 6, 10, 20, 50, 100]
        _, response = signal.freqz(b, a, worN=frequencies, fs=rate)
        count = int(12 * rate)
        x = [sample(i, rate) for i in range(count)]
        sos = signal.butter(4, cutoff, fs=rate, output="sos")
        y = signal.sosfiltfilt(sos, x, padlen=int(2 * rate))
        places = list(range(count // 3, 2 * count // 3, count // 30))
        rows.append({
            "rate_hz": rate, "cutoff_hz": cutoff, "samples": count,
            "frequencies_hz": frequencies, "gains": (np.abs(response) ** 2).tolist(),
            "places": places, "filtered": [y[i] for i in places]})
    return rows


def spectrum():
    rate, count = 200.0, 600  # 2^3 * 3 * 5^2: nothing is padded
    x = np.array([sample(i, rate) + 0.01 * i for i in range(count)])
    line = x[0] + (x[-1] - x[0]) * np.arange(count) / (count - 1)
    amplitude = 4 / count * np.abs(np.fft.rfft((x - line) * signal.windows.hann(count, sym=True)))
    return {"rate_hz": rate, "samples": count, "amplitudes": amplitude.tolist()}


def calibration():
    """Loads of 0 to 9 N, three times each, and what a resistor that saturates reads under them, in whole counts."""
    rng = np.random.default_rng(2022)
    forces = np.tile(np.arange(0.0, 9.5, 1.0), 3)
    readings = np.round(1023 * (1 - np.exp(-forces / 4.5)) + rng.normal(0, 12, forces.size) * (forces > 0))
    fits = []
    for order in range(1, 6):
        for through_zero in (False, True):
            powers = np.vander(readings / 1000, order + 1, increasing=True)[:, 1 if through_zero else 0:]
            if through_zero:
                c = np.linalg.lstsq(powers, forces, rcond=None)[0]
            else:
                c = np.polyfit(readings / 1000, forces, order)[::-1]
            residuals = powers @ c - forces
            fits.append({
                "order": order, "through_zero": through_zero, "residuals_n": residuals.tolist(),
                "rms_n": float(np.sqrt(np.mean(residuals ** 2))),
                "standard_error_n": float(np.sqrt(np.sum(residuals ** 2) / (forces.size - c.size))),
                "at_500_n": float(np.sum(c * 0.5 ** np.arange(1 if through_zero else 0, order + 1)))})
    return {"readings": readings.tolist(), "forces_n": forces.tolist(), "fits": fits}


def main():
    golden = {"taps": taps(), "butterworth": butterworth(), "spectrum": spectrum(), "calibration": calibration()}
    pathlib.Path(__file__).with_name("golden.json").write_text(json.dumps(golden, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
