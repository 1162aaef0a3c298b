# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names, labels, notes and paths that mean something in a language that ThinPart writes, or break its lines."""

import random

NAMED = {
    "plain": "bracket 3 mm",
    "umlaut": "Größe 1",
    "empty": "",
    "gmsh": "a\"; SystemCall 'touch PWNED'; ",
    "gmsh back": 'a\\"; SystemCall "touch PWNED"; //',
    "gmsh line": 'a\nSystemCall "touch PWNED";',
    "gmsh long": "x" * 1100 + ';SystemCall "touch PWNED";',
    "gmsh long wide": "\N{GREEK SMALL LETTER ALPHA}" * 600,
    "percent": "%n%s%d%%",
    "calculix": "x" * 1310 + "\n*INCLUDE, INPUT=secret.inp",
    "calculix long": "x" * 1287 + "*INCLUDE, INPUT=secret.inp",
    "msh": "x\n$EndComments\n$Nodes\n0\n$EndNodes",
    "msh long": "x" * 226 + "$EndComments",
    "unv": "x\n    -1\n    -1\n  2411",
    "terminal": "red\x1b[31m\x1b]0;title\x07\x9b2J\r",
    "direction": "a\u202egnp.exe\u2066\u200e",
    "breaks": "one\ntwo\r\nthree\x0b\x0c\x1c\x1d\x1e\x85\u2028\u2029four",
    "formula": "=HYPERLINK(\"http://x\")",
    "formulas": "+1", "minus": "-2+3", "at": "@SUM(A1)", "tab": "\t=1", "return": "\r=1",
    "csv": 'a,"b";c\n"d',
    "apostrophe": "'=1",
    "html": "</title><script>alert(1)</script><img src=x onerror=alert(1)>&amp;&#60;",
    "template": "{{ 7 * 7 }}{% raw %}{0.__class__}",
    "xml": "]]></a><b c='\"'>&lt;<!-- \x00\x08\x0b\ufffe\uffff",
    "sql": "'; DROP TABLE parts; --",
    "like": "100%_!!%",
    "json": '"}\n{"file": "forged"}',
    "nul": "a\0b",
    "bytes": "caf\udce9\udcff.step",
    "surrogate": "\udce9\udc80",
    "astral": "\U0001f600\U000e0001\U0010ffff",
    "option": "--overwrite",
    "path": "../../../etc/passwd",
    "long": "note " * 24_000,
}
"""By what each of them is about."""


def made(count=300, seed=27):
    """Texts of random pieces of all of them, the same in each run: list of str."""
    chosen, pieces = random.Random(seed), [text[:40] for text in NAMED.values()] + list('\\"\'`$;%<>&\r\n\t\0\x1b,={}*#!_-/')
    return ["".join(chosen.choices(pieces, k=chosen.randint(1, 6))) for _ in range(count)]


ALL = [*NAMED.values(), *made()]
