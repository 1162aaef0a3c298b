# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall by manufacturing process, in mm, as data: the shipped table and a user's own."""

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from ..errors import ThinPartError
from ..kinds import file_marks
from ..kinds.compound_kinds import ListOf, Record
from ..kinds.json_file import UnreadableJson, read_json
from ..kinds.value_kinds import LARGEST, Number, OrNull, Text, Whole
from ..message import Message, message

SHIPPED = Path(__file__).resolve().parents[3] / "resources" / "wall_limits.json"

_ID = Text(longest=40, pattern=r"^[A-Za-z0-9_\-]+$", meaning="letters, digits, - and _")
_LIMIT = OrNull(Number(1 / LARGEST, LARGEST))
_SOURCE = Record({}, {"author": Text(), "title": Text(), "year": Whole(), "url": Text()})
_LIMITS = {"id": _ID, "title": Text(), "min_mm": _LIMIT, "max_mm": _LIMIT}
_MATERIAL = Record(_LIMITS, {"note": Text(), "source": _SOURCE})
_PROCESS = Record(_LIMITS, {"note": Text(), "source": _SOURCE, "materials": ListOf(_MATERIAL, most=1000, distinct="id")})
_TABLE = Record({"format": Text(), "version": Whole(), "processes": ListOf(_PROCESS, most=1000, distinct="id")})


@dataclass(frozen=True)
class WallLimits:
    """The least and the greatest wall of a process, or of a process with one material.

    Attributes
    ----------
    name : str
        By which people choose it: ``FDM``, or ``die_casting:zinc`` with a material.
    title : str
        For people.
    min_mm, max_mm : float or None, mm
        At least one is set.
    material : str
        Title of the material; empty for the process itself.
    note, source : str
        What the figures are about, and where they are from.
    """

    name: str
    title: str
    min_mm: Optional[float]
    max_mm: Optional[float]
    material: str = ""
    note: str = ""
    source: str = ""

    @property
    def full_title(self):
        """Message: the title, with the material where one was chosen."""
        title = Message(_literal(self.title), {})
        if not self.material:
            return title
        return message("{process} ({material})", process=title, material=Message(_literal(self.material), {}))


def shipped_limits():
    """The limits that come with ThinPart, by name: dict of str to WallLimits."""
    return read_limits(SHIPPED)


def read_limits(path):
    """Read a table of limits: dict of str to WallLimits by name, each process followed by its materials.

    Raises ThinPartError, kind ``usage``: one sentence that names the file, the place in it and what is wrong there.
    """
    return {limits.name: limits for process in limits_content(path)["processes"] for limits in _limits_of(process)}


def limits_content(path):
    """The content of a table of limits: dict, as in the file. Parameters and errors are those of `read_limits`."""
    try:
        content = read_json(path)
    except FileNotFoundError:
        raise ThinPartError(message("There is no file {file} with limits of walls: copy {shipped} and edit it.",
                                    file=path, shipped=SHIPPED), "usage") from None
    except UnreadableJson as problem:
        raise ThinPartError(message("The limits of walls {file} cannot be read ({problem}).", file=path,
                                    problem=str(problem)), "usage") from None
    fault = limits_fault(content)
    if fault:
        raise ThinPartError(message("The limits of walls {file} are not well formed: {problem}.", file=path, problem=fault),
                            "usage")
    return content


def chosen_limits(known, names):
    """The limits that people name: tuple of WallLimits, each once, in the order of the names.

    Raises ThinPartError, kind ``usage`` where there is no such process or material.

    Parameters
    ----------
    known : dict of str to WallLimits
    names : iterable of str
        Names of `known`, in whatever case; empty ones are left out.
    """
    by_name = {name.casefold(): limits for name, limits in known.items()}
    chosen: dict = {}
    for name in filter(None, map(str.strip, names)):
        limits = by_name.get(name.casefold())
        if limits is None:
            raise ThinPartError(message("There are no limits of walls for {process!r}: there are {known}.",
                                        process=name, known=_listing(known, name)), "usage")
        chosen[limits.name] = limits
    return tuple(chosen.values())


def _listing(known, name):
    """The processes, or the materials of the one that a name begins with."""
    process, _, material = name.casefold().partition(":")
    own = [each for each in known if material and each.casefold().startswith(f"{process}:")]
    return ", ".join(own or [each for each in known if ":" not in each])


def limits_fault(content):
    """What is wrong with the content of a table of limits, with its place: str; None where nothing is."""
    if not file_marks.LIMITS.is_of(content):
        return message("format is not {format!r}", format=file_marks.LIMITS.format)
    if content.get("version") != 1:
        return message("version is {version}, and this reads version 1", version=repr(content.get("version")))
    fault = _TABLE.fault(content, "")
    if fault:
        return fault
    for number, process in enumerate(content["processes"]):
        materials = enumerate(process.get("materials", ()))
        for place, row in [("", process), *((f".materials[{index}]", row) for index, row in materials)]:
            least, most = row["min_mm"], row["max_mm"]
            if least is None and most is None:
                return message("processes[{number}]{place} has neither min_mm nor max_mm", number=number, place=place)
            if least is not None and most is not None and least >= most:
                return message("processes[{number}]{place} has a min_mm of {least:g}, not below its max_mm of {most:g}",
                               number=number, place=place, least=least, most=most)
    return None


def _limits_of(process):
    yield WallLimits(process["id"], process["title"], process["min_mm"], process["max_mm"], "",
                     process.get("note", ""), _source(process))
    for row in process.get("materials", ()):
        yield WallLimits(f"{process['id']}:{row['id']}", process["title"], row["min_mm"], row["max_mm"], row["title"],
                         row.get("note", ""), _source(row) or _source(process))


def _source(row):
    source = row.get("source", {})
    return ", ".join(str(source[key]) for key in ("author", "title", "year", "url") if source.get(key))


def _literal(text):
    """A text as a template without fields."""
    return text.replace("{", "{{").replace("}", "}}")
