# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports on a run in progress: JSON lines for programs, or a progress bar for people, on stderr."""

import json
import os
import shutil
import sys
from contextlib import contextmanager

from ..core.errors import ThinPartError
from ..core.foreign_text import json_text, printable
from ..core.message import with_messages
from ..storage.thumbnails import thumbnail_path
from .plain_table import text_width

_BAR_WIDTH = 20
"""Characters of the bar."""


def new_report(as_json, for_window=False):
    """Make the report that suits the reader: JSON lines, a progress bar on a terminal, else failures only.

    Parameters
    ----------
    as_json : bool
    for_window : bool
        Whether JSON lines include what a window shows besides: the templates and values of their sentences, which it
        translates, and ``thumbnail``, the path of a part's picture, whether or not it exists; null where it can have none.
    """
    if as_json:
        return JsonReport(for_window)
    if not sys.stderr.isatty():
        return RunReport()
    return BarReport()


class RunReport:
    """Report of failures only, one sentence each; base class of the other reports.

    A context manager: its ``with`` block lasts as long as the run.
    """

    def __enter__(self):
        return self

    def __exit__(self, *reason):
        return None

    def state(self, name):
        """Report that the run is now ``searching``, ``running`` or ``paused``."""

    def found(self, count):
        """Report the number of documents found so far."""

    def started(self, progress):
        """Report that all documents are found and the analysis starts."""
        self._show_progress(progress)

    def ended(self, outcome, progress):
        """Report the outcome of one file."""
        self.failures(outcome)
        self.counted(outcome, progress)

    def counted(self, outcome, progress):
        """Report that one more file is done; its outcome is reported elsewhere."""
        self._show_progress(progress, outcome["file"])

    def step(self, progress, step):
        """Report what is done with a part of a file at the moment; see `mesh_sizes`."""
        self._show_progress(progress, step=step)

    def note(self, sentence):
        """Report a sentence about the whole run."""
        _write_line(f"thinpart: {printable(sentence)}")

    def failures(self, outcome):
        """Report the failures of one file, one sentence each."""
        errors = [outcome["error"]] if "error" in outcome else outcome["failures"]
        for error in errors:
            option = _OPTION_FOR.get(error["kind"])
            hint = f" See {option}." if option and "--" not in error["message"] else ""
            _write_line(f"thinpart: {printable(outcome['file'])}: {printable(error['message'])}{hint} [{error['kind']}]")

    def _show_progress(self, progress, file=None, step=None):
        """Show how far the run is, after a file that has just ended or before a step."""


class JsonReport(RunReport):
    """Records on stdout and progress on stderr, one JSON object per line; see `new_report`."""

    def __init__(self, for_window=False):
        self._is_for_window = for_window

    def state(self, name):
        _write_line(json.dumps({"state": name}))

    def failures(self, outcome):
        super().failures(outcome)
        with standard_output() as stream:
            for line in json_lines(outcome):
                if self._is_for_window:
                    line = with_messages({**line, "thumbnail": _thumbnail(outcome, line)})
                # One write per line, so that a reader always finds complete lines.
                stream.write(json_text(line) + "\n")

    def _show_progress(self, progress, file=None, step=None):
        _write_line(json.dumps({"progress": {**progress.content(file), **(step or {})}}))


class BarReport(RunReport):
    """A line with a bar, the pace and the time left, which is written over again and again."""

    def __init__(self):
        self._name, self._line = "Starting", ""

    def __exit__(self, *reason):
        if self._line:
            _write_line("")

    def state(self, name):
        self._name = name.capitalize()
        self._show(self._name)

    def found(self, count):
        self._show(f"{self._name} {count:,} parts")

    def failures(self, outcome):
        self._show("")
        super().failures(outcome)

    def note(self, sentence):
        self._show("")
        super().note(sentence)

    def _show_progress(self, progress, file=None, step=None):
        name = "Done" if progress.done == progress.total else self._name
        done = round(_BAR_WIDTH * progress.done / max(progress.total, 1))
        self._show(f"{name} [{'=' * done}{' ' * (_BAR_WIDTH - done)}] {_progress_text(progress.content(), step)}")

    def _show(self, line):
        # Cut the line: one that the terminal wraps could not be overwritten.
        line = line[:shutil.get_terminal_size().columns - 1]
        sys.stderr.write(f"\r{line}{' ' * (text_width(self._line) - text_width(line))}" + ("" if line else "\r"))
        sys.stderr.flush()
        self._line = line


def _progress_text(content, step=None):
    words = [f"{content['done']:,} of {content['total']:,} files"]
    for count, what in ((content["failed"], "failed"), (content["reused"], "unchanged")):
        if count:
            words.append(f"{count:,} {what}")
    if content["done"] and content["seconds"] > 0:
        words.append(_pace(content["done"] / content["seconds"]))
    if content["done"] == content["total"]:
        words.append(f"{_duration(content['seconds'])} in all")
    elif content["seconds_left"] is not None:
        words.append(f"{_duration(content['seconds_left'])} left")
    if step is not None:
        words.append(_step_text(step))
    return ", ".join(words)


_STEPS = {"read": "reading", "measure": "measuring", "mesh_at_one_size": "meshing at one size", "mesh": "meshing",
          "shell": "making a shell of"}


def _step_text(step):
    """What is done with which part, such as "lid.step: meshing Lid (2 of 3), attempt 2"."""
    text = f"{printable(os.path.basename(step['file']))}: {_STEPS[step['step']]} {printable(step['part'])}".rstrip()
    if step["parts"] > 1:
        text += f" ({step['number']} of {step['parts']})"
    return text if step["attempt"] == 1 else f"{text}, attempt {step['attempt']}"


def _pace(per_second):
    return f"{per_second:.1f} a second" if per_second >= 1 else f"{60 * per_second:.1f} a minute"


def _duration(seconds):
    minutes, seconds = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{seconds:02}" if hours else f"{minutes}:{seconds:02}"


def json_lines(outcome):
    """The records that ``--json`` prints for one file: parts, then failures."""
    # A file that was rejected before it reached a worker has no confinement. The keys of `about` come last again, so
    # that a part cannot override its file.
    about = {"file": outcome["file"]}
    if outcome.get("confinement"):
        about["confinement"] = outcome["confinement"]
    if "error" in outcome:
        return [{**about, "error": outcome["error"]}]
    lines = [{**about, **part, **about} for part in outcome["parts"]]
    for failure in outcome["failures"]:
        error = {"kind": failure["kind"], "message": failure["message"]}
        lines.append({**about, "name": failure["part"], "label": failure.get("label"), "error": error})
    return lines


def _thumbnail(outcome, line):
    """The path of the picture of a part of an outcome, None where it can have none; no record can name another file."""
    if "error" in line or "sha256" not in outcome:
        return None
    try:
        path = thumbnail_path(outcome["sha256"], line["name"])
    except OSError:
        return None  # there is no folder for pictures
    return None if path is None else os.fspath(path)


@contextmanager
def standard_output():
    """Context manager for the standard output, flushed at the end of the block.

    Raises a ThinPartError if it cannot be written, but a BrokenPipeError for a closed pipe.
    """
    try:
        yield sys.stdout
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        # Otherwise the rest of the buffer would fail again when the process ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise ThinPartError(f"The output cannot be written ({error.strerror}): make room for it.",
                            "failed") from None


_OPTION_FOR = {"info_write": "--info-dir", "timeout": "--timeout", "memory": "--memory"}


def _write_line(line):
    sys.stderr.write(line + "\n")
    sys.stderr.flush()
