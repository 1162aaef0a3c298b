#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which pages of the guide lag behind the English ones: docs/guide/de/keys.md translates docs/guide/keys.md.

    /usr/bin/python3 resources/translations/update_guide.py                           lists the pages that lag behind
    /usr/bin/python3 resources/translations/update_guide.py docs/guide/de/keys.md     says that this page does not any more

The first line of a translated page names the English text that it translates, by the id that git gives to that content,
so that git can show what has changed since. A new language is a folder beside the others; what it does not have is shown
in English.
"""

import hashlib
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GUIDE = ROOT / "docs" / "guide"

_DIGITS = 12
_HEAD = re.compile(r"<!-- Translates docs/guide/\S+ ([0-9a-f]+) -->\n")


def english_of(page):
    """The English page that a page of docs/guide/de or another language translates: Path."""
    return page.parents[1] / page.name


def content_id(page):
    """Git's id of what a file contains, abbreviated: str."""
    content = page.read_bytes().replace(b"\r\n", b"\n")
    return hashlib.sha1(b"blob %d\0" % len(content) + content).hexdigest()[:_DIGITS]


def translated_id(page):
    """Id of the English text that a page says it translates: str, empty where it does not say."""
    head = _HEAD.match(page.read_text(encoding="utf-8"))
    return head[1] if head else ""


def mark(page):
    """Write into the first line of a page that it translates the English page as that is now."""
    english = english_of(page)
    rest = _HEAD.sub("", page.read_text(encoding="utf-8"), count=1)
    page.write_text(f"<!-- Translates docs/guide/{english.name} {content_id(english)} -->\n{rest}", encoding="utf-8")


def lag(page):
    """What is to be done about a page: a sentence, empty where it translates the English page as that is now."""
    name, english = (path.resolve().relative_to(ROOT).as_posix() for path in (page, english_of(page)))
    if not english_of(page).is_file():
        return f"{name} has no English page {english}: rename or delete it."
    before = translated_id(page)
    if before == content_id(english_of(page)):
        return ""
    shown = f"see what has changed with 'git diff {before} {english}'" if before else f"compare it with {english}"
    return (f"{name} lags behind the English page: {shown}, translate that, then run "
            f"'/usr/bin/python3 resources/translations/update_guide.py {name}'.")


def translated_pages():
    """The pages in other languages: list of Path."""
    return sorted(GUIDE.glob("*/*.md"))


def main(names):
    """Mark the pages that are named, or list those that lag behind; the status is 1 where there are any."""
    pages = [Path(name).resolve() for name in names]
    for page in pages:
        if page not in translated_pages():
            print(f"{page} is no translated page of the guide: name one such as docs/guide/de/keys.md.", file=sys.stderr)
            return 1
    for page in pages:
        mark(page)
    lagging = [sentence for sentence in map(lag, translated_pages()) if sentence]
    print("\n".join(lagging) or "All translated pages are up to date.")
    return 1 if lagging else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
