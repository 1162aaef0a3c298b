# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers with their unit drawn into a picture, where there is neither a screen nor a font."""

import numpy as np

HEIGHT, WIDTH = 7, 5
"""Pixels of a character, before it is enlarged; between two of them is one pixel."""

_ROWS = {
    "0": "01110 10001 10011 10101 11001 10001 01110", "1": "00100 01100 00100 00100 00100 00100 01110",
    "2": "01110 10001 00001 00110 01000 10000 11111", "3": "11111 00010 00100 00010 00001 10001 01110",
    "4": "00010 00110 01010 10010 11111 00010 00010", "5": "11111 10000 11110 00001 00001 10001 01110",
    "6": "00110 01000 10000 11110 10001 10001 01110", "7": "11111 00001 00010 00100 01000 01000 01000",
    "8": "01110 10001 10001 01110 10001 10001 01110", "9": "01110 10001 10001 01111 00001 00010 01100",
    ".": "00000 00000 00000 00000 00000 01100 01100", ",": "00000 00000 00000 00000 01100 00100 01000",
    "-": "00000 00000 00000 11111 00000 00000 00000", "+": "00000 00100 00100 11111 00100 00100 00000",
    "e": "00000 00000 01110 10001 11111 10000 01110", "i": "00100 00000 01100 00100 00100 00100 01110",
    "m": "00000 00000 11010 10101 10101 10101 10101", "n": "00000 00000 10110 11001 10001 10001 10001",
    " ": "00000 00000 00000 00000 00000 00000 00000",
}
_GLYPHS = {each: np.array([[mark == "1" for mark in row] for row in rows.split()]) for each, rows in _ROWS.items()}


def text_mask(text, enlarged=1):
    """Draw a text: ndarray of shape (HEIGHT * enlarged, n), bool, True where the text is.

    Parameters
    ----------
    text : str
        Of digits, signs and units of length; spaces of any width are one.
    enlarged : int
        Pixels for each pixel of a character.
    """
    columns = []
    for character in text.replace("\u00a0", " "):
        columns += [_GLYPHS[character], np.zeros((HEIGHT, 1), dtype=bool)]
    mask = np.concatenate(columns[:-1], axis=1) if columns else np.zeros((HEIGHT, 0), dtype=bool)
    return np.kron(mask, np.ones((enlarged, enlarged), dtype=bool)).astype(bool)
