# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot of `solver_truth`: the error of the automatic mesh of each part, by label and by verdict, as SVG."""

import matplotlib

matplotlib.use("svg")

import matplotlib.pyplot as plt
import numpy as np

from benchmarks.plot_file import save_plot
from benchmarks.solver_tables import groupings
from thinpart_workbench.workflow.learning.validation import share_of
from thinpart_workbench.workflow.solving.mesh_trouble import ERROR

_COLOURS = {"thin": "#c0392b", "thin_features": "#d9822b", "normal": "#2b6cb0"}
_LEAST, _MOST, _NO_ERROR = 1e-3, 3.0, 7.0
"""Ends of the axis of errors, and where a part without an error is drawn."""


def write_plot(parts, profiles, file):
    """Write the plot as SVG.

    Parameters
    ----------
    parts : list of SolvedPart
    profiles : list of Profile
        Those of their verdicts.
    file : str or Path
    """
    known = [part for part in parts if part.trouble is not None]
    groups = [(title, *group) for title, found in groupings(known, profiles) for group in found if title != "label, all"]
    with plt.rc_context({"svg.hashsalt": "thinpart", "font.family": "sans-serif", "font.size": 9}):
        figure, (errors, shares) = plt.subplots(
            1, 2, sharey=True, figsize=(8.6, 0.42 * len(groups) + 1.1), gridspec_kw={"width_ratios": (3, 1)},
            layout="constrained")
        for row, (_, category, members) in enumerate(groups):
            _draw_errors(errors, row, members, _COLOURS[category])
            _draw_share(shares, row, members, _COLOURS[category])
        _dress(errors, shares, groups)
        save_plot(figure, file)
        plt.close(figure)


def _draw_errors(axes, row, members, colour):
    error = np.sort([_NO_ERROR if part.truth.error is None else min(max(part.truth.error, _LEAST), _MOST)
                     for part in members])
    # Neighbours are moved apart by a pattern that is the same in every run.
    number = np.arange(len(error))
    beside = row + 0.56 * (number * 0.618 % 1.0 - 0.5)
    has_error = error < _NO_ERROR
    axes.scatter(error[has_error], beside[has_error], s=9, color=colour, alpha=0.6, linewidths=0)
    apart = 10.0 ** (0.3 * (number * 0.382 % 1.0 - 0.5))
    axes.scatter((error * apart)[~has_error], beside[~has_error], s=14, color=colour, marker="x", linewidths=1)
    if has_error.any():
        axes.plot(np.median(error[has_error]), row, "|", color="#222222", markersize=13, markeredgewidth=1.6)


def _draw_share(axes, row, members, colour):
    share = share_of([part.trouble for part in members])
    if share.total:
        axes.barh(row, share.count / share.total, height=0.6, color=colour, alpha=0.8)
        axes.plot([share.low, share.high], [row, row], color="#222222", linewidth=1)
        axes.text(1.02, row, f"{share.count} of {share.total}", va="center", fontsize=8)


def _dress(errors, shares, groups):
    titles = [title for title, *_ in groups]
    errors.set_yticks(range(len(groups)), [f"{title}: {category.replace('_', ' ')}" for title, category, _ in groups])
    errors.set_ylim(len(groups) - 0.5, -0.5)
    errors.set_xscale("log")
    errors.set_xlim(0.8 * _LEAST, 2.0 * _NO_ERROR)
    errors.set_xticks([0.001, 0.01, 0.04, 0.1, 1.0, _NO_ERROR], ["0.1 %", "1 %", "4 %", "10 %", "100 %", "none"])
    errors.minorticks_off()
    errors.axvline(ERROR, color="#222222", linewidth=0.8, linestyle="--")
    errors.set_title("greatest error of the first six frequencies; x: no mesh, or refused", fontsize=9)
    shares.set_xlim(0.0, 1.0)
    shares.set_xticks([0.0, 0.5, 1.0], ["0", "50 %", "100 %"])
    shares.set_title("in trouble", fontsize=9)
    for axes in (errors, shares):
        axes.tick_params(axis="y", length=0)
        axes.spines[["top", "right"]].set_visible(False)
        for row in range(1, len(groups)):
            if titles[row] != titles[row - 1]:
                axes.axhline(row - 0.5, color="#bbbbbb", linewidth=0.6)
