# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PNG file as a program reads it that has nothing to do with ours."""

import subprocess

import numpy as np


def read_png(path):
    """Red, green, blue and alpha, ndarray of shape (height, width, 4), uint8."""
    found = subprocess.run(["identify", "-format", "%m %w %h", path], check=True, capture_output=True,
                           text=True).stdout.split()
    assert found[0] == "PNG"
    raw = subprocess.run(["convert", path, "-depth", "8", "rgba:-"], check=True, capture_output=True).stdout
    return np.frombuffer(raw, np.uint8).reshape(int(found[2]), int(found[1]), 4)
