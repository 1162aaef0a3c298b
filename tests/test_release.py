# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart release``: what the index of add-ons asks for is there, and the tag and the zip are made of it."""

import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import pytest

from thinpart_workbench import __version__
from thinpart_workbench.cli.commands.release import KEYS, LEFT_OUT

ROOT = Path(__file__).resolve().parents[1]

PUBLISHER = {"maintainer": "Anna & Bert", "email": "anna@example.org", "repository": "https://example.org/anna/thinpart",
             "branch": "release", "raw_files": "https://example.org/anna/thinpart/raw/release/",
             "bugtracker": "https://example.org/anna/thinpart/issues"}

ALLOWED = {"numpy", "scipy", "scikit-learn"}
"""Of FreeCAD's list of Python packages, those that ThinPart uses; see docs/index-of-addons.md."""


def git(folder, *arguments):
    return subprocess.run(["git", "-c", "user.name=Test", "-c", "user.email=test@example.org", *arguments], cwd=folder,
                          check=True, capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL).stdout.strip()


@pytest.fixture
def checkout(tmp_path):
    """A checkout with its repository that is ready for a release, in a folder of its own."""
    folder = tmp_path / "parent" / "checkout"
    for name in ("docs", "resources", "thinpart_workbench"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "samples", "gui"))
    for path in ROOT.iterdir():
        if path.is_file() and path.name != ".git":
            shutil.copy(path, folder)
    for name in ("tests", "benchmarks"):
        (folder / name).mkdir()
        (folder / name / "a.py").write_text("", encoding="utf-8")
    date = re.search("<date>(.*)</date>", (folder / "package.xml").read_text(encoding="utf-8"))[1]
    changes = folder / "CHANGELOG.md"
    changes.write_text(re.sub("^## .*$", f"## {__version__} - {date}", changes.read_text(encoding="utf-8"), count=1,
                              flags=re.MULTILINE), encoding="utf-8")
    (folder / "publisher.json").write_text(json.dumps(PUBLISHER), encoding="utf-8")
    git(folder, "init", "-q", "-b", "main")
    for name, value in (("user.name", "Test"), ("user.email", "test@example.org")):
        git(folder, "config", name, value)
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "-m", "all")
    return folder


def release(folder, *arguments):
    return subprocess.run([sys.executable, "-B", "-m", "thinpart_workbench", "release", *arguments], cwd=folder,
                          capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)


def state(folder):
    return (sorted(folder.parent.rglob("*")), git(folder, "status", "--porcelain"), git(folder, "tag"),
            git(folder, "count-objects"))


def test_a_release_is_a_tag_and_a_zip_with_the_publisher_and_without_tests(checkout):
    run = release(checkout)
    assert run.returncode == 0, run.stderr
    archive, tag = checkout.parent / f"ThinPart-{__version__}.zip", f"v{__version__}"
    assert str(archive) in run.stdout and f"git push {PUBLISHER['repository']} {tag}" in run.stdout
    assert git(checkout, "tag") == tag and git(checkout, "status", "--porcelain") == ""
    assert git(checkout, "rev-parse", f"{tag}^") == git(checkout, "rev-parse", "main")

    with zipfile.ZipFile(archive) as opened:
        files = {name.partition("/")[2]: opened.read(name) for name in opened.namelist() if not name.endswith("/")}
    assert set(files) == set(git(checkout, "ls-tree", "-r", "--name-only", tag).splitlines())
    assert {name.partition("/")[0] for name in files}.isdisjoint(LEFT_OUT)
    assert {"InitGui.py", "Init.py", "LICENSE", "README.md", "SECURITY.md", "thinpart", "docs/guide/README.md",
            "docs/guide/de/README.md", "docs/guide/fr/README.md"} <= set(files)

    package = ElementTree.fromstring(files["package.xml"])
    assert check_package(package) == []
    maintainer = package.find("{*}maintainer")
    assert (maintainer.text, maintainer.attrib) == (PUBLISHER["maintainer"], {"email": PUBLISHER["email"]})
    urls = {each.get("type"): (each.text, each.get("branch")) for each in package.iterfind("{*}url")}
    assert urls == {"repository": (PUBLISHER["repository"], "release"), "bugtracker": (PUBLISHER["bugtracker"], None),
                    "readme": (PUBLISHER["raw_files"] + "Overview.md", None)}

    overview = files["Overview.md"].decode()
    pictures = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", overview)
    assert len(pictures) == 3 and all(each.startswith(PUBLISHER["raw_files"]) for each in pictures)
    assert {each.removeprefix(PUBLISHER["raw_files"]) for each in pictures} <= set(files)


def test_a_dry_run_makes_all_of_it_and_keeps_nothing(checkout):
    before = state(checkout)
    run = release(checkout, "--dry-run")
    assert run.returncode == 0 and run.stderr == "" and state(checkout) == before
    assert re.fullmatch(rf"v{__version__} would have \d+ files, [\d,]+ bytes as zip\.\n", run.stdout)


def test_a_dry_run_of_the_checkout_says_what_is_missing_and_a_release_refuses(checkout):
    shutil.copy(ROOT / "publisher.json", checkout)
    git(checkout, "commit", "-qam", "as it comes")
    before = state(checkout)
    dry, real = release(checkout, "--dry-run"), release(checkout)
    assert dry.returncode == 0 and dry.stdout.count("is a placeholder: put in your own") == 4
    assert real.returncode == 1 and real.stdout == "" and real.stderr.count("\n") == 1
    assert real.stderr == ("thinpart: maintainer@example.invalid in publisher.json is a placeholder: put in your own "
                           "email.\n")
    assert state(checkout) == before


def spoil(folder, name, old, new):
    path = folder / name
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


@pytest.mark.parametrize("name, old, new, said", [
    ("publisher.json", "anna@example.org", "anna", "anna in publisher.json is no email"),
    ("publisher.json", "https://example.org/anna/thinpart\"", "ssh://x\"", "is no repository"),
    ("publisher.json", "\"branch\"", "\"brunch\"", "is an object with the texts"),
    ("publisher.json", "{", "", "cannot be read"),
    ("package.xml", f"<version>{__version__}<", "<version>9.9.9<", "package.xml has another version"),
    ("CHANGELOG.md", f"## {__version__} - ", "## 9.9.9 - ", "CHANGELOG.md does not begin with"),
    ("README.md", "# ", "## ", "not committed"),
])
def test_what_does_not_fit_together_is_one_sentence(checkout, name, old, new, said):
    spoil(checkout, name, old, new)
    if name != "README.md":
        git(checkout, "commit", "-qam", "wrong")
    before = state(checkout)
    run = release(checkout)
    assert run.returncode == 1 and said in run.stderr and run.stderr.count("\n") == 1, run.stderr
    assert state(checkout) == before


def test_nothing_is_released_twice_or_over_a_file(checkout):
    archive = checkout.parent / f"ThinPart-{__version__}.zip"
    archive.write_bytes(b"mine")
    run = release(checkout)
    assert run.returncode == 1 and "already exists" in run.stderr
    assert archive.read_bytes() == b"mine" and git(checkout, "tag") == ""
    archive.unlink()
    assert release(checkout).returncode == 0
    run = release(checkout)
    assert run.returncode == 1 and f"The tag v{__version__} already exists" in run.stderr


def test_without_a_repository_it_is_one_sentence(checkout, monkeypatch):
    shutil.rmtree(checkout / ".git")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(checkout.parent))
    run = release(checkout, "--dry-run")
    assert run.returncode == 1 and "with its repository" in run.stderr and run.stderr.count("\n") == 1


# -- package.xml: the rules of FreeCAD's schema for manifests, see docs/index-of-addons.md

ONCE = {"name", "description", "version", "date", "icon", "content", "freecadmin", "pythonmin"}
OFTEN = {"maintainer": 1, "author": 1, "license": 1, "tag": 3, "url": 0, "depend": 0}
FORMS = {"version": r"\d+\.\d+\.\d+", "date": r"\d{4}-\d\d-\d\d", "freecadmin": r"\d+\.\d+\.\d+",
         "pythonmin": r"\d+\.\d+\.\d+", "name": r'[^/\\?%*:|"<>]+', "description": r"[^<>]{20,300}", "tag": r"[a-z]+"}
ATTRIBUTES = {"maintainer": {"email"}, "author": {"email"}, "license": {"file"}, "url": {"type", "branch"},
              "depend": {"type", "optional"}}


def check_package(root):
    """What is wrong with a manifest: list of str."""
    names = [each.tag.rpartition("}")[2] for each in root]
    wrong = [f"{name} is there {names.count(name)} times" for name in ONCE if names.count(name) != 1]
    wrong += [f"{name} is there {names.count(name)} times" for name, least in OFTEN.items() if names.count(name) < least]
    wrong += [f"{name} is unknown" for name in names if name not in {*ONCE, *OFTEN}]
    for name, each in zip(names, root):
        if name in FORMS and not re.fullmatch(FORMS[name], each.text):
            wrong.append(f"{name} is {each.text}")
        if set(each.attrib) - ATTRIBUTES.get(name, set()):
            wrong.append(f"{name} has {each.attrib}")
        if name == "depend" and each.get("optional") not in ("true", "false"):
            wrong.append(f"{each.text} does not say whether it is optional")
    content = [[each.tag.rpartition("}")[2] for each in item] for item in root.find("{*}content")]
    return wrong + ([] if content == [["classname", "subdirectory"]] else [f"content has {content}"])


def test_package_xml_is_as_the_schema_of_manifests_has_it():
    root = ElementTree.parse(ROOT / "package.xml").getroot()
    assert root.attrib == {"format": "1"} and root.tag == "{https://wiki.freecad.org/Package_Metadata}package"
    assert check_package(root) == []
    packages = {each.text: each.get("optional") for each in root.iterfind("{*}depend")}
    assert packages == {"numpy": "false", "scipy": "false", "scikit-learn": "true"} and set(packages) == ALLOWED
    assert len(root.findall("{*}tag")) <= 7


def test_one_place_says_who_publishes_and_the_documents_name_it():
    assert list(json.loads((ROOT / "publisher.json").read_text(encoding="utf-8"))) == list(KEYS)
    for name in ("README.md", "SECURITY.md", "docs/index-of-addons.md"):
        assert "publisher.json" in (ROOT / name).read_text(encoding="utf-8"), name
