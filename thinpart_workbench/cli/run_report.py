"""What a run says while it goes on: lines for programs, or a bar for people, on stderr."""

import json
import os
import shutil
import sys
from contextlib import contextmanager

from ..core.errors import ThinPartError
from .plain_table import text_width
from .terminal_table import has_rich, printable


def new_report(as_json):
    """The report for whoever reads: JSON lines, a bar on a terminal, else failures alone."""
    if as_json:
        return JsonReport()
    if not sys.stderr.isatty():
        return Report()
    return BarReport() if has_rich() else LineReport()


class Report:
    """Failures, one sentence each; the rest of what a run tells is for the other reports.

    A ``with`` block lasts as long as the run.
    """

    def __enter__(self):
        return self

    def __exit__(self, *reason):
        return None

    def state(self, name):
        """The run is ``searching``, ``running`` or ``paused`` now."""

    def found(self, count):
        """So many documents were found so far."""

    def started(self, progress):
        """All documents are known."""

    def ended(self, outcome, progress):
        """One file has ended."""
        self.failures(outcome)

    def note(self, sentence):
        """Something that holds for the whole run."""
        _say(f"thinpart: {sentence}")

    def failures(self, outcome):
        """What could not be analysed, one sentence each."""
        errors = [outcome["error"]] if "error" in outcome else outcome["failures"]
        for error in errors:
            option = _OPTION_FOR.get(error["kind"])
            hint = f" See {option}." if option and "--" not in error["message"] else ""
            _say(f"thinpart: {printable(outcome['file'])}: {printable(error['message'])}{hint} "
                 f"[{error['kind']}]")


class JsonReport(Report):
    """Records on stdout and progress on stderr, a JSON object a line."""

    def state(self, name):
        _say(json.dumps({"state": name}))

    def started(self, progress):
        self._progress(progress, None)

    def ended(self, outcome, progress):
        self.failures(outcome)
        self._progress(progress, outcome["file"])

    def failures(self, outcome):
        super().failures(outcome)
        with standard_output() as stream:
            for line in json_lines(outcome):
                # In one piece: a reader that looks at any time finds whole lines.
                stream.write(json.dumps(line, ensure_ascii=False) + "\n")

    @staticmethod
    def _progress(progress, file):
        _say(json.dumps({"progress": progress.content(file)}))


class BarReport(Report):
    """A bar with the pace and the time left."""

    def __enter__(self):
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn

        self._bar = Progress(TextColumn("{task.description}", markup=False),
                             BarColumn(bar_width=None), TextColumn("{task.fields[told]}", markup=False),
                             console=Console(stderr=True, highlight=False), expand=True)
        self._bar.start()
        self._task = self._bar.add_task("Starting", total=None, told="")
        self._name = None
        return self

    def __exit__(self, *reason):
        self._bar.stop()

    def state(self, name):
        self._name = name.capitalize()
        self._bar.update(self._task, description=self._name)

    def found(self, count):
        self._bar.update(self._task, told=f"{count:,} parts")

    def started(self, progress):
        self._show(progress)

    def ended(self, outcome, progress):
        self.failures(outcome)
        self._show(progress)

    def _show(self, progress):
        is_over = progress.done == progress.total
        self._bar.update(self._task, total=progress.total, completed=progress.done,
                         told=_told(progress.content()), description="Done" if is_over else self._name)


class LineReport(Report):
    """The same in a line without a bar, which takes no library."""

    def __init__(self):
        self._name, self._line = "Starting", ""

    def __exit__(self, *reason):
        if self._line:
            _say("")

    def state(self, name):
        self._name = name.capitalize()
        self._show(self._name)

    def found(self, count):
        self._show(f"{self._name} {count:,} parts")

    def started(self, progress):
        self._told(progress)

    def ended(self, outcome, progress):
        self.failures(outcome)
        self._told(progress)

    def failures(self, outcome):
        self._show("")
        super().failures(outcome)

    def note(self, sentence):
        self._show("")
        super().note(sentence)

    def _told(self, progress):
        name = "Done" if progress.done == progress.total else self._name
        self._show(f"{name} {_told(progress.content())}")

    def _show(self, line):
        # A line that the terminal breaks would not be written over.
        line = line[:shutil.get_terminal_size().columns - 1]
        sys.stderr.write(f"\r{line}{' ' * (text_width(self._line) - text_width(line))}" + ("" if line else "\r"))
        sys.stderr.flush()
        self._line = line


def _told(content):
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
    return ", ".join(words)


def _pace(per_second):
    return f"{per_second:.1f} a second" if per_second >= 1 else f"{60 * per_second:.1f} a minute"


def _duration(seconds):
    minutes, seconds = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{seconds:02}" if hours else f"{minutes}:{seconds:02}"


def json_lines(outcome):
    """The records that ``--json`` prints for one file: parts, then failures."""
    file = outcome["file"]
    if "error" in outcome:
        return [{"file": file, "error": outcome["error"]}]
    lines = [{"file": file, **part} for part in outcome["parts"]]
    for each in outcome["failures"]:
        error = {"kind": each["kind"], "message": each["message"]}
        lines.append({"file": file, "name": each["part"], "label": each.get("label"),
                      "error": error})
    return lines


@contextmanager
def standard_output():
    """The stream for what was asked for; flushed at the end of the block.

    Raises
    ------
    ThinPartError
        When there is no room where it goes. A reader that has seen enough is another matter.
    """
    try:
        yield sys.stdout
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        # What is still in the buffer would fail again when the process ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise ThinPartError(f"The output cannot be written ({error.strerror}): make room for it.",
                            "failed") from None


_OPTION_FOR = {"info_write": "--info-dir", "timeout": "--timeout", "memory": "--memory"}


def _say(line):
    sys.stderr.write(line + "\n")
    sys.stderr.flush()
