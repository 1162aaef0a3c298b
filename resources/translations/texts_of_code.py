# SPDX-License-Identifier: LGPL-2.1-or-later
"""All texts of ThinPart that people see in the window, read from its code without running it."""

import ast
import json
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "thinpart_workbench"
BELOW = "ThinPartCore"
"""Context of what layers below the window say: sentences, reasons, titles, meanings."""

_MARKS = ("translate", "QT_TRANSLATE_NOOP")
LAYERS_BELOW = ("core", "storage", "freecad_adapter", "workflow", "api", "cli", "window_processes")
"""Layers whose messages the window may show: those of ``api`` and ``cli`` are told by the commands that it starts."""

TABLES = (("core/descriptors/descriptor_table.py", "QUANTITIES"), ("core/errors.py", "KINDS"),
          ("core/reuse/similarity.py", "TERMS"))
"""Tables with texts that are shown one by one: the module and the name of each."""

_WORDS = re.compile(r"[A-Za-z]{2,} [a-z]{2,}|[a-z]{2,} .*\.$", re.DOTALL)
_SQL = re.compile(r"\b(SELECT|INSERT|DELETE|UPDATE|CREATE|PRAGMA|BEGIN|ORDER|JOIN|TEXT|BLOB|NULL|OR|IN|LIKE)\b")


def all_texts():
    """Everything that is to be translated.

    Returns
    -------
    list of (str, str)
        Context and text, sorted, each once.

    Raises
    ------
    ValueError
        Where a text is put together before it is translated.
    """
    texts = {(BELOW, text) for text in [*texts_from_below(), *profile_titles(), *limit_titles(), *report_texts()]}
    return sorted(texts.union(marked_texts(), form_texts()))


def marked_texts():
    """Context and text of every ``translate`` and ``QT_TRANSLATE_NOOP``."""
    for path in [ROOT / "InitGui.py", *sorted(PACKAGE.rglob("*.py"))]:
        for call in calls(tree_of(path)):
            context, text = call.args
            for each in (text.body, text.orelse) if isinstance(text, ast.IfExp) else (text,):
                if isinstance(each, ast.Constant):
                    yield context.value, each.value
                elif any(isinstance(part, (ast.JoinedStr, ast.BinOp)) for part in ast.walk(each)):
                    raise ValueError(f"{path}, line {call.lineno}: a text is translated first, and then "
                                     "its fields are filled in.")


def form_texts():
    """Context and text of everything in forms (.ui)."""
    for path in sorted((ROOT / "resources").rglob("*.ui")):
        form = ElementTree.parse(path).getroot()
        for element in form.iter("string"):
            if element.text and element.get("notr") != "true":
                yield form.findtext("class"), element.text


def texts_from_below():
    """set of str: what other layers say, templates of messages with their fields by name."""
    found = set()
    for layer in LAYERS_BELOW:
        for path in sorted((PACKAGE / layer).rglob("*.py")):
            found.update(templates(path))
    return found.union(*(table_texts(place, name) for place, name in TABLES))


def templates(path):
    """Templates of the messages that a file makes.

    Raises
    ------
    ValueError
        Where one is no literal.
    """
    for call in calls(tree_of(path), ("message",)):
        if not isinstance(call.args[0], ast.Constant):
            raise ValueError(f"{path}, line {call.lineno}: the template of a message is a literal.")
        yield call.args[0].value


def table_texts(place, name):
    """set of str: texts of one of `TABLES`."""
    table = next(node.value for node in tree_of(PACKAGE / place).body if isinstance(node, ast.Assign)
                 and isinstance(node.targets[0], ast.Name) and node.targets[0].id == name)
    return prose(ast.Module([ast.Expr(table)], []))


def profile_titles():
    """Titles and meanings of the profiles that come with ThinPart, and where their thresholds are from."""
    for path in sorted((ROOT / "resources" / "profiles").glob("*.json")):
        profile = json.loads(path.read_text(encoding="utf-8"))
        yield from (profile["title"], profile["source"])
        for category in profile["categories"]:
            yield from (category["title"], category["meaning"])
            yield from (each["title"] for each in category["criteria"])


def limit_titles():
    """Titles and notes of the processes that come with limits of the wall, and titles of their materials.

    The sources of the limits are titles of documents, which stay as they are.
    """
    table = json.loads((ROOT / "resources" / "wall_limits.json").read_text(encoding="utf-8"))
    for process in table["processes"]:
        yield from (process[key] for key in ("title", "note") if key in process)
        yield from (material["title"] for material in process.get("materials", ()))


def report_texts():
    """Texts of the pages of reports.

    Raises
    ------
    ValueError
        Where one is no literal.
    """
    for path in sorted((PACKAGE / "workflow" / "report").glob("*.py")):
        for call in calls(tree_of(path), ("_",)):
            if not isinstance(call.args[0], ast.Constant):
                raise ValueError(f"{path}, line {call.lineno}: a text of a page is a literal.")
            yield call.args[0].value


def prose(tree):
    """set of str: texts of a syntax tree that look as if people read them."""
    collector = _Prose()
    collector.visit(tree)
    return collector.texts


def tree_of(path):
    """Syntax tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"))


def calls(tree, names=_MARKS):
    """list of ast.Call: calls of functions by these names alone, of those that mark texts otherwise."""
    return [node for node in ast.walk(tree) if isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name) and node.func.id in names]


class _Prose(ast.NodeVisitor):
    """Literals and f-strings with two words in a row, or that end as sentences do.

    No SQL, no documentation and no names of fields.
    """

    def __init__(self):
        self.texts = set()

    def visit_Expr(self, node):
        """A docstring is no text for users."""
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_Assign(self, node):
        """Neither is one that is assigned."""
        if getattr(node.targets[0], "attr", "") != "__doc__":
            self.generic_visit(node)

    def visit_Call(self, node):
        """Fields of a namedtuple are written as words; what is marked has a place of its own, as templates have."""
        name = getattr(node.func, "id", "")
        if name in ("message", "_"):
            for each in node.keywords:
                self.visit(each)
        elif name not in ("namedtuple", *_MARKS):
            self.generic_visit(node)

    def visit_Compare(self, node):
        """What is looked for in a text of others is no text of ours."""
        if not isinstance(node.left, ast.Constant):
            self.generic_visit(node)

    def visit_Constant(self, node):
        """A literal."""
        if isinstance(node.value, str):
            self._add(node.value, node.value)

    def visit_JoinedStr(self, node):
        """An f-string; what stands in its fields may be a text of its own."""
        pieces = [each.value if isinstance(each, ast.Constant) else None for each in node.values]
        self._add("".join("{}" if each is None else each.replace("{", "{{").replace("}", "}}")
                          for each in pieces),
                  "".join("0" if each is None else each for each in pieces))
        for each in node.values:
            if isinstance(each, ast.FormattedValue):
                self.visit(each.value)

    def _add(self, text, words):
        if _WORDS.search(words) and not _SQL.search(words):
            self.texts.add(text)
