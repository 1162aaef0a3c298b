# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots as files that name their licence."""

import io

LICENCE = "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->"


def save_plot(figure, file):
    """Write a figure of matplotlib as SVG, the same whenever it is drawn.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    file : str
    """
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
    head, rest = drawn.getvalue().split("\n", 1)
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(f"{head}\n{LICENCE}\n{rest}")
