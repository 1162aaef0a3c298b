# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options by which commands check walls against the limits of processes, and the results as texts."""

from ..core.judging.wall_check import check_walls
from ..storage.user_limits import limits_named, user_limits_file
from .terminal_table import FAILURE, TableColumn

CHECK_FAILED = 3
"""Exit status where a part fails a check and nothing worse happened."""

_WORDS = {True: "passes", False: "FAILS", None: "unknown"}
_STYLES = {True: "green", False: FAILURE, None: "magenta"}


def add_check_options(parser, has_status=True):
    """Declare the options; `has_status` says whether the exit status tells of failed checks."""
    parser.add_argument("--check", metavar="PROCESS", action="append", default=[],
                        help="check the walls against the limits of a process: injection_molding, die_casting, "
                             "sand_casting, sheet_metal, machining, FDM, SLA, SLS, or with a material as in "
                             "die_casting:zinc; several with commas between them" + (
                                 f"; exit status {CHECK_FAILED} if a part fails" if has_status else ""))
    parser.add_argument("--limits", metavar="FILE",
                        help=f"your own limits, instead of those in {user_limits_file()}".replace("%", "%%"))


def checked_limits(options):
    """The processes after --check: tuple of WallLimits. Raises a ThinPartError, kind ``usage``, where one is not known,
    or the file after --limits cannot be used.
    """
    return named_limits(options.check, options.limits)


def named_limits(texts, file):
    """The processes in texts with commas: tuple of WallLimits; see `limits_named`."""
    return limits_named([name for names in texts for name in names.split(",")], file)


class PartChecks:
    """Checks the parts of a run against WallLimits.

    Attributes
    ----------
    failed : int
        Number of parts that failed so far.
    """

    def __init__(self, limits):
        self.limits, self.failed = limits, 0

    def of(self, record):
        """The results for a part record, as JSON has them: list of dict."""
        found = [check_walls(record, limits).content() for limits in self.limits]
        self.failed += any(check["passes"] is False for check in found)
        return found

    def added_to(self, outcome):
        """The outcome of a file, with ``checks`` in every part where there is something to check."""
        if not self.limits or not outcome.get("parts"):
            return outcome
        return {**outcome, "parts": [{**part, "checks": self.of(part)} for part in outcome["parts"]]}

    def exit_status(self, status):
        """The exit status of a command that would have ended with `status`."""
        return CHECK_FAILED if status == 0 and self.failed else status


def check_columns(limits, checks_of):
    """Columns of a printed table for limits; `checks_of` gives what `PartChecks.of` returned for a row, or None."""
    def column(number, title):
        def passes(row):
            checks = checks_of(row)
            return checks[number]["passes"] if checks else ""

        return TableColumn(title, lambda row: _WORDS.get(passes(row), ""), False, lambda row: _STYLES.get(passes(row), ""))

    return [column(number, each.name) for number, each in enumerate(limits)]


def check_remarks(checks, is_brief):
    """Sentences on the checks of a part for a terminal: list of str; where `is_brief`, none on those that plainly passed."""
    return [check["sentence"] for check in checks
            if not is_brief or check["within_tolerance"] or not check["passes"]]
