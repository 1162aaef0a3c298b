# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot of `mesh_worth`: nodes and error of each mesh, as SVG."""

import matplotlib

matplotlib.use("svg")

import matplotlib.pyplot as plt
import numpy as np

from benchmarks.plot_file import save_plot
from benchmarks.worth_tables import ERRORS, LEAST_ERROR, UNIFORM

_MOST = 2.0


def write_plot(parts, file):
    """Write the plot as SVG.

    Parameters
    ----------
    parts : list of WorthPart
    file : str or Path
    """
    known = [part for part in parts if part.reference is not None]
    ways = (("one size", [f"uniform {share:g}" for share in UNIFORM], "#888888", "o"),
            ("Gmsh, sizes from curvature", ["curvature"], "#d9822b", "^"),
            ("ThinPart", [f"ThinPart {error:g}" for error in ERRORS], "#2b6cb0", "s"))
    with plt.rc_context({"svg.hashsalt": "thinpart", "font.family": "sans-serif", "font.size": 9}):
        figure, axes = plt.subplots(figsize=(7.2, 4.4), layout="constrained")
        for title, names, colour, mark in ways:
            middle = []
            for name in names:
                points = [(part.meshes[name]["nodes"], min(max(part.error(name), LEAST_ERROR), _MOST)) for part in known
                          if name in part.meshes and part.meshes[name]["frequencies"]]
                if points:
                    axes.scatter(*zip(*points), s=10, color=colour, alpha=0.25, linewidths=0)
                    middle.append(np.median(points, axis=0))
            if middle:
                axes.plot(*zip(*middle), color=colour, marker=mark, label=f"{title}, median")
        axes.axhline(0.02, color="#222222", linewidth=0.6, linestyle=":")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("nodes")
        axes.set_ylabel("greatest error of six frequencies and a deflection")
        axes.set_yticks([0.001, 0.01, 0.02, 0.1, 1.0], ["0.1 %", "1 %", "2 %", "10 %", "100 %"])
        axes.legend(frameon=False)
        save_plot(figure, file)
        plt.close(figure)
