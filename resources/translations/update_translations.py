#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings ThinPart.ts, the template of new translations, and ThinPart_*.ts up to date with the texts of the code, compiles
these to ThinPart_*.qm for Qt, and writes what is said outside of the window to sentences_*.json.

    /usr/bin/python3 resources/translations/update_translations.py

Finished translations are kept, texts that are gone are dropped, and those that wait for a translation are
listed: write it into the .ts file (Qt's Linguist does that too), take out type="unfinished", and call this
once more. A new language is an empty file ThinPart_CODE.ts. Services such as Crowdin take ThinPart.ts.
"""

import sys
from pathlib import Path

from texts_of_code import BELOW, all_texts
from ts_file import compile_ts, read_ts, write_sentences, write_ts

HERE = Path(__file__).resolve().parent
TEMPLATE = "ThinPart.ts"


def main():
    """Update and compile all languages; the status is 1 where something is left to do."""
    texts, status = all_texts(), 0
    write_ts(HERE / TEMPLATE, "", dict.fromkeys(texts, ""))
    for path in sorted(HERE.glob("ThinPart_*.ts")):
        before = read_ts(path) if path.stat().st_size else {}
        after = {key: before.get(key, "") for key in texts}
        language = path.stem.partition("_")[2]
        write_ts(path, language, after)
        write_sentences(path.with_name(f"sentences_{language}.json"), after, BELOW)
        waiting = [text for (_, text), translation in after.items() if not translation]
        print(f"{path.name}: {len(after)} texts, {len(set(before) - set(after))} dropped, "
              f"{len(waiting)} to be translated{':' if waiting else '.'}")
        print("".join(f"    {text!r}\n" for text in waiting), end="")
        if not compile_ts(path):
            print(f"{path.with_suffix('.qm').name} was not compiled, since Qt's lrelease is not installed: "
                  "install it with 'apt-get install qttools5-dev-tools'.")
            status = 1
        status = 1 if waiting else status
    return status


if __name__ == "__main__":
    sys.exit(main())
