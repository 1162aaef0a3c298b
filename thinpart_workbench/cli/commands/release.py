# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart release``: make the tag and the zip that FreeCAD's index of add-ons is given. Nothing is sent anywhere.

The tag has the files of the current commit without those that only developers need: the index takes no add-on that has
a folder ``tests`` at its top, which FreeCAD puts on Python's path. ``publisher.json`` is the one place for who publishes
ThinPart and where; it is filled in here, so that a checkout names no address that the Addon Manager would prefer to its own.
"""

import json
import os
import re
import subprocess
import tempfile
from html import escape
from pathlib import Path

from ... import __version__
from ...core.errors import ThinPartError
from ...core.foreign_text import printable

ROOT = Path(__file__).resolve().parents[3]
TAG, ARCHIVE = f"v{__version__}", f"ThinPart-{__version__}.zip"

LEFT_OUT = (".ci", ".git-blame-ignore-revs", ".gitignore", "benchmarks", "mypy.ini", "pytest.ini", "ruff.toml", "tests")
"""What only developers need."""

KEYS = ("maintainer", "email", "repository", "branch", "raw_files", "bugtracker")
"""Of publisher.json."""

_PLACEHOLDER = re.compile(r"\.invalid\b")  # the top-level domain that nobody has (RFC 2606)
_EMAIL, _ADDRESS = re.compile(r"[^@\s]+@[^@\s]+\.[^@\s]+"), re.compile(r"https://[^\s\"<>]+")
_PICTURE = re.compile(r"(!\[[^\]]*\]\()(?!\w+:)([^)]+\))")
_LATEST = re.compile(r"^## (\S+) - (\S+)$", re.MULTILINE)


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("--dry-run", action="store_true",
                        help="make all of it in a temporary folder, say what a release still needs, and keep nothing")


def run(options):
    """Make the release and return the exit status."""
    publisher = _publisher()
    needed = _needed(publisher)
    if needed and not options.dry_run:
        raise ThinPartError(needed[0])
    with tempfile.TemporaryDirectory() as folder:
        git = _Git(folder, keeps=not options.dry_run)
        tree = _tree(git, publisher)
        if options.dry_run:
            git("archive", "--format=zip", "--prefix=ThinPart/", "-o", os.path.join(folder, ARCHIVE), tree)
            files = git("ls-tree", "-r", "--name-only", tree).splitlines()
            print(f"{TAG} would have {len(files)} files, {os.path.getsize(os.path.join(folder, ARCHIVE)):,} bytes as zip.")
            for sentence in needed:
                print(printable(f"Needed before: {sentence}"))
            return 0
        archive = ROOT.parent / ARCHIVE
        if os.path.lexists(archive):
            raise ThinPartError(f"{archive} already exists: move it away and start again.")
        commit = git("commit-tree", tree, "-p", "HEAD", "-m", f"ThinPart {__version__}")
        git("archive", "--format=zip", "--prefix=ThinPart/", "-o", os.fspath(archive), commit)
        git("tag", "-a", TAG, "-m", f"ThinPart {__version__}", commit)
    print(printable(f"{archive}\nTo publish the tag {TAG}, and the branch that the index names:\n  git push "
                    f"{publisher['repository']} {TAG} {TAG}^{{commit}}:refs/heads/{publisher['branch']}"))
    return 0


def _publisher():
    """Who publishes ThinPart, and where: dict of str with `KEYS`."""
    try:
        content = json.loads((ROOT / "publisher.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ThinPartError(f"publisher.json cannot be read ({error}): it is an object with the texts "
                            f"{', '.join(KEYS)}.") from None
    if not isinstance(content, dict) or set(content) != set(KEYS) or not all(
            isinstance(each, str) and each.strip() for each in content.values()):
        raise ThinPartError(f"publisher.json is an object with the texts {', '.join(KEYS)} and nothing else: correct it.")
    return content


def _needed(publisher):
    """Sentences: what has to be done before a release."""
    needed = []
    for name, form in (("email", _EMAIL), *((key, _ADDRESS) for key in ("repository", "raw_files", "bugtracker"))):
        value = publisher[name]
        if _PLACEHOLDER.search(value):
            needed.append(f"{value} in publisher.json is a placeholder: put in your own {name}.")
        elif not form.fullmatch(value):
            needed.append(f"{value} in publisher.json is no {name} as the index needs it: correct it.")
    latest = _LATEST.search((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
    date = _element("date")
    if _element("version") != __version__:
        needed.append(f"package.xml has another version than ThinPart {__version__}: write it there.")
    if latest is None or latest.groups() != (__version__, date):
        needed.append(f"CHANGELOG.md does not begin with '## {__version__} - {date}', the version and date of package.xml: "
                      "date both.")
    git = _Git()
    if git("status", "--porcelain"):
        needed.append("There are changes that are not committed: commit them first.")
    if git("tag", "--list", TAG):
        needed.append(f"The tag {TAG} already exists: a release has a version of its own.")
    return needed


def _element(name):
    found = re.search(f"<{name}>(.*?)</{name}>", (ROOT / "package.xml").read_text(encoding="utf-8"))
    return found[1] if found else None


def _tree(git, publisher):
    """The files of a release, as a tree of git: its name."""
    git("read-tree", "HEAD")
    git("rm", "-r", "-q", "--cached", "--ignore-unmatch", "--", *LEFT_OUT)
    for name, made in (("package.xml", _package), ("Overview.md", _overview)):
        blob = git("hash-object", "-w", "--stdin", input=made((ROOT / name).read_text(encoding="utf-8"), publisher))
        git("update-index", "--add", "--cacheinfo", f"100644,{blob},{name}")
    return git("write-tree")


def _package(text, publisher):
    """package.xml with the maintainer and the addresses."""
    address = publisher["repository"]
    people = [f"<maintainer email=\"{escape(publisher['email'])}\">{escape(publisher['maintainer'])}</maintainer>"]
    urls = [f"<url type=\"repository\" branch=\"{escape(publisher['branch'])}\">{escape(address)}</url>",
            f"<url type=\"bugtracker\">{escape(publisher['bugtracker'])}</url>",
            f"<url type=\"readme\">{escape(publisher['raw_files'])}Overview.md</url>"]
    text = re.sub(r"<!-- No repository.*?-->\n", "", text, count=1, flags=re.DOTALL)
    return re.sub(r"<maintainer.*?</maintainer>", lambda _: "\n  ".join(people + urls), text, count=1)


def _overview(text, publisher):
    """Overview.md with the addresses of its pictures, which the Addon Manager takes as they are."""
    return _PICTURE.sub(lambda found: found[1] + publisher["raw_files"] + found[2], text)


class _Git:
    """Calls git in the checkout, with an index of its own in a folder; what it makes is kept in the repository or there."""

    def __init__(self, folder=None, keeps=True):
        self._variables = {}
        if folder is not None:
            self._variables["GIT_INDEX_FILE"] = os.path.join(folder, "index")
        if not keeps:
            objects = _Git()("rev-parse", "--path-format=absolute", "--git-path", "objects")
            kept = os.path.join(folder, "objects")
            os.mkdir(kept)
            self._variables.update(GIT_OBJECT_DIRECTORY=kept, GIT_ALTERNATE_OBJECT_DIRECTORIES=objects)

    def __call__(self, *arguments, **more):
        try:
            done = subprocess.run(["git", *arguments], cwd=ROOT, env={**os.environ, **self._variables}, encoding="utf-8",
                                  capture_output=True, **({} if more else {"stdin": subprocess.DEVNULL}), **more)
        except OSError as error:
            raise ThinPartError(f"A release needs git ({error.strerror}): install it.") from None
        if done.returncode:
            said = " ".join(done.stderr.split()) or f"status {done.returncode}"
            raise ThinPartError(f"git {arguments[0]} failed ({said}): a release is made in a checkout with its repository.")
        return done.stdout.strip()
