# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of `meshing_study`: poor elements and layers of each part, at one size and as proposed, as SVG."""

import math

from benchmarks.plot_file import LICENCE
from thinpart_workbench.core.foreign_text import xml_text

POOR_LEAST = 1e-5
"""Share of poor elements at which the logarithmic axis begins; fewer are drawn there."""

_WIDTH, _ROW, _LEFT, _TOP, _GAP, _PLOT = 860, 9, 130, 64, 60, 320
_BEFORE, _AFTER, _LINE, _TEXT = "#d9822b", "#2b6cb0", "#bbbbbb", "#333333"
_POOR_TICKS = ((1e-5, "0.001 %"), (1e-3, "0.1 %"), (0.03, "3 %"), (1.0, "100 %"))
_LAYER_TICKS = ((0.0, "0 %"), (0.5, "50 %"), (0.9, "90 %"), (1.0, ""))


def meshing_plot(groups):
    """The plot: a row for each part, from one size to as proposed.

    Parameters
    ----------
    groups : list of (str, list of dict)
        Title and part records with ``check``, as of `thinpart_workbench.api.mesh_sizes.mesh_sizes`.

    Returns
    -------
    str
        SVG.
    """
    groups = [(title, sorted(parts, key=_order)) for title, parts in groups if parts]
    rows = sum(len(parts) for _, parts in groups) + 2 * len(groups)
    height = _TOP + _ROW * rows + 30
    out = [LICENCE, f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}" font-family="sans-serif" '
           f'font-size="11" fill="{_TEXT}">', f'<rect width="{_WIDTH}" height="{height}" fill="#ffffff"/>',
           *_legend(), *_axis(_LEFT, "elements with gamma under 0.3", _POOR_TICKS, _poor_place, height),
           *_axis(_LEFT + _PLOT + _GAP, "thin walls with the wanted layers", _LAYER_TICKS, _share_place, height)]
    y = _TOP + _ROW
    for title, parts in groups:
        out.append(f'<text x="8" y="{y + 4}">{xml_text(title.replace("_", " "))}</text>')
        for part in parts:
            out += _row(part["check"], y)
            y += _ROW
        y += 2 * _ROW
    return "\n".join([*out, "</svg>", ""])


def _order(part):
    """Parts without a mesh at one size come first, then those with most poor elements."""
    before = part["check"]["default"]
    return bool(before["elements"]), -(before["poor_share"] or 0.0)


def _row(check, y):
    before, after = check["default"], check["proposed"]
    for left, key, place in ((_LEFT, "poor_share", _poor_place), (_LEFT + _PLOT + _GAP, "layers_share", _share_place)):
        ends = [left + place(mesh[key]) if mesh["elements"] and mesh[key] is not None else None for mesh in (before, after)]
        if None not in ends:
            yield f'<path d="M{ends[0]:.1f} {y}H{ends[1]:.1f}" stroke="{_LINE}"/>'
        for x, mesh, colour in zip(ends, (before, after), (_BEFORE, _AFTER)):
            if x is not None:
                yield f'<circle cx="{x:.1f}" cy="{y}" r="3" fill="{colour}"/>'
            elif not mesh["elements"]:
                yield _cross(left + _PLOT + (10 if mesh is before else 20), y, colour)


def _cross(x, y, colour):
    return f'<path d="M{x - 3} {y - 3}l6 6m0 -6l-6 6" stroke="{colour}" stroke-width="2"/>'


def _legend():
    for x, colour, text in ((_LEFT, _BEFORE, "one size"), (_LEFT + 90, _AFTER, "as proposed")):
        yield f'<circle cx="{x}" cy="14" r="4" fill="{colour}"/><text x="{x + 9}" y="18">{text}</text>'
    yield _cross(_LEFT + 205, 14, _TEXT) + f'<text x="{_LEFT + 214}" y="18">no mesh</text>'


def _axis(left, title, ticks, place, height):
    yield f'<text x="{left}" y="38">{title}</text>'
    for value, text in ticks:
        x = left + place(value)
        yield (f'<path d="M{x:.1f} {_TOP - 6}V{height - 20}" stroke="#e4e4e4"/>'
               f'<text x="{x:.1f}" y="{_TOP - 10}" text-anchor="middle">{text}</text>')


def _poor_place(share):
    return _PLOT * (math.log10(max(share, POOR_LEAST)) - math.log10(POOR_LEAST)) / -math.log10(POOR_LEAST)


def _share_place(share):
    return _PLOT * share
