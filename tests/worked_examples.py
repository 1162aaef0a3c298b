# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worked examples of docs/extending.md, and what becomes of a copy of the program that follows them."""

import re
from pathlib import Path
from typing import NamedTuple

DOCUMENT = Path(__file__).resolve().parents[1] / "docs" / "extending.md"

_BLOCK = re.compile(r"^```\w+\n# (?P<file>[\w./]+)(?:, (?P<place>[^\n]+))?\n(?P<code>.*?)^```$", re.MULTILINE | re.DOTALL)
_FIRST_IMPORT = re.compile(r"^from \.", re.MULTILINE)


class Block(NamedTuple):
    """Code, the file of the checkout that it goes into, and where in it; "" where it is the whole file."""

    file: str
    place: str
    code: str


def examples():
    """dict of the examples' titles, each with its list of `Block`."""
    sections = re.split(r"^## ", DOCUMENT.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    return {section.partition("\n")[0]: [Block(found["file"], found["place"] or "", found["code"])
                                         for found in _BLOCK.finditer(section)] for section in sections}


def follow_example(title, package):
    """Put an example into a copy of the program.

    Parameters
    ----------
    title : str
    package : Path
        The copied package's folder.
    """
    for block in examples()[title]:
        file = package.parent / block.file
        if block.place:
            file.write_text(_changed(file.read_text(encoding="utf-8"), block), encoding="utf-8")
        else:
            assert not file.exists(), file
            file.parent.mkdir(exist_ok=True)
            file.write_text(block.code, encoding="utf-8")


def _changed(content, block):
    """A file's content with the code of a block in its place."""
    where, _, name = block.place.partition(" ")
    if block.place == "among the imports":
        at = _FIRST_IMPORT.search(content).start()
        return content[:at] + block.code + content[at:]
    if where == "before":
        before, line, after = _divided(content, rf"^{name} = ")
        return f"{before}{block.code}\n\n{line}{after}"
    assert where == "in", block.place
    before, line, after = _divided(content, rf"^{name} = (?:[({{]|{{.* in \()\n")
    rows, end, rest = _divided(after, r"^[)}]+\n", times=None)
    return before + line + rows + block.code + end + rest


def _divided(text, pattern, times=1):
    """What stands before a pattern's first match, the match, and what follows it.

    Parameters
    ----------
    times : int or None
        How often it has to be there; None for any number above 0.
    """
    found = list(re.finditer(pattern, text, re.MULTILINE))
    assert len(found) == times if times else found, pattern
    return text[:found[0].start()], found[0].group(), text[found[0].end():]
