# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translation files as Qt reads them: .ts for people, compiled to .qm for programs."""

import json
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from itertools import groupby
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from thinpart_workbench.core.foreign_text import xml_text

COMPILERS = ("lrelease", "/usr/lib/qt5/bin/lrelease", "/usr/lib/qt6/bin/lrelease")


def read_ts(path):
    """Translations of a file.

    Parameters
    ----------
    path : Path

    Returns
    -------
    dict of (str, str) to str
        By context and text; empty where a translation is missing or not finished. Empty without a file.
    """
    found = {}
    for context in ElementTree.parse(path).iter("context") if path.is_file() else ():
        for message in context.iter("message"):
            translation = message.find("translation")
            finished = translation.get("type") is None
            found[context.findtext("name"), message.findtext("source")] = (
                translation.text or "" if finished else "")
    return found


def write_ts(path, language, translations):
    """Write a file, without places in the code: those would change with every line.

    Parameters
    ----------
    path : Path
    language : str
        As Qt calls it: ``de``; empty for a template.
    translations : dict of (str, str) to str
        As `read_ts` gives them.
    """
    target = f' language="{language}"' if language else ""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", f'<TS version="2.1"{target} sourcelanguage="en">']
    for context, group in groupby(sorted(translations.items()), key=lambda each: each[0][0]):
        lines += ["<context>", f"    <name>{xml_text(context)}</name>"]
        for (_, text), translation in group:
            mark = "" if translation else ' type="unfinished"'
            lines += ["    <message>", f"        <source>{xml_text(text)}</source>",
                      f"        <translation{mark}>{xml_text(translation)}</translation>", "    </message>"]
        lines.append("</context>")
    path.write_text("\n".join([*lines, "</TS>", ""]), encoding="utf-8")


def write_sentences(path, translations, context):
    """Write the translations of a context for programs without Qt: a JSON object, by text.

    Parameters
    ----------
    path : Path
    translations : dict of (str, str) to str
        As `read_ts` gives them.
    context : str
    """
    found = {text: translation for (of, text), translation in translations.items() if of == context and translation}
    path.write_text(json.dumps(found, ensure_ascii=False, indent=0, sort_keys=True) + "\n", encoding="utf-8")


def compile_ts(path):
    """Write the .qm file beside a .ts file; False where Qt's compiler is not installed."""
    for compiler in filter(shutil.which, COMPILERS):
        command = [compiler, "-silent", "-nounfinished", path, "-qm", path.with_suffix(".qm")]
        # Debian's lrelease may be a link to one that is not there.
        if subprocess.run(command, stdin=subprocess.DEVNULL).returncode == 0:
            return True
    return False
