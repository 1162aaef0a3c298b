# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that searches libraries for the window: it reads, filters and compares parts, and stores annotations.

It handles requests in their order: JSON objects with ``ask``, the name of a method of `LibraryWorker`, and the
parameters of that method. Of several pending ``find`` requests it only handles the last.
"""

import queue

from ..api.annotations import annotate_part, mesh_settings
from ..api.found_parts import record_and_profile, stored_row
from ..api.open_libraries import OpenLibraries
from ..core.errors import ThinPartError
from ..core.judging.conditions import search_conditions
from .json_lines import JsonLines

FIRST_ROWS = 100
"""Rows that the ``found`` message contains."""

_UNUSED_KEYS = ("faces",)
"""Keys of a part record that are large and never shown."""


class LibraryWorker:
    """The open libraries and what the window was told of them.

    Parameters
    ----------
    send : callable
        Sends a message, given as keyword arguments, to the parent.
    post_request : callable
        Queues a request that the worker makes to itself, from another thread.
    """

    def __init__(self, send, post_request):
        self._send = send
        self._libraries = OpenLibraries(post_request)
        self._serial = None
        self._conditions = ()

    def open(self, roots):
        """Search these libraries from now on; sends ``libraries`` at once and after each refresh."""
        self._libraries.open(roots)
        self._send_new_libraries()

    def refresh(self, roots=None):
        """Refresh libraries, all of them by default; sends ``progress`` and ``libraries``."""
        self._libraries.refresh(roots)
        self._send_libraries()

    def stop(self):
        """Stop refreshing; what was read so far is kept."""
        self._libraries.stop()

    def progress(self, root, done, total):
        """Handle the progress of a refresh."""
        if root in self._libraries:
            self._send(progress={"root": root, "done": done, "total": total})

    def grown(self, root):
        """Handle that a refresh has added parts to the index."""
        if self._libraries.grown(root):
            self._send_new_libraries()

    def refreshed(self, root, index, problems, stopped):
        """Handle the end of a refresh."""
        if self._libraries.refreshed(root, index, problems, stopped):
            self._send_new_libraries()

    def find(self, serial, query, sort="file", descending=False, current=None, like=None):
        """Send ``found``: counts, first rows and the position of the current part.

        For conditions that cannot be parsed, ``refusal`` says why; the last valid ones stay in effect.

        Parameters
        ----------
        serial : int
        query : dict
            Fields of a PartQuery; ``conditions`` as text, ``changed_since`` as ISO date, ``ranges`` by column.
        sort : str
            See `OpenLibraries.find`.
        descending : bool
        current : list of str, optional
            Library, info file and name of a part.
        like : dict, optional
            ``record``, ``excluding`` (info file and name, or None) and ``same_size``: search the
            parts most similar to that record, among those that match the query.
        """
        refusal = self._read_conditions(query.pop("conditions", ""))
        similar = {} if like is None else {
            "like": like["record"], "excluding": like["excluding"] and tuple(like["excluding"]),
            "same_size": like["same_size"]}
        matches = self._libraries.find(self._conditions, sort=sort, descending=descending, **similar, **query)
        self._serial = serial
        self._send(found={
            "serial": serial, "refusal": refusal, "count": matches.count, "matching": matches.choices.count,
            "total": matches.total, **{name: value for name, value in vars(matches.choices).items() if name != "count"},
            "current": None if current is None else self._libraries.position_of(*current),
            "rows": self._row_contents(0, FIRST_ROWS),
        })

    def rows(self, serial, start, end):
        """Send ``rows`` of the last search."""
        if serial == self._serial:
            self._send(rows={"serial": serial, "start": start, "rows": self._row_contents(start, end)})

    def record(self, info_file, name):
        """Send ``record``: a part's record and the profile by which it was judged."""
        response = {"info_file": info_file, "name": name}
        try:
            record, profile = record_and_profile(info_file, name)
        except ThinPartError as error:
            self._send(record={**response, "sentence": str(error)})
            return
        shown = {key: value for key, value in record.items() if key not in _UNUSED_KEYS}
        self._send(record={**response, "record": shown, "profile": profile})

    def keep(self, root, info_file, name, notes, mesh, link):
        """Set annotations of a part; None leaves an annotation unchanged.

        Sends ``kept``, with a sentence if it failed.
        """
        response = {"info_file": info_file, "name": name}
        try:
            settings = None if mesh is None else mesh_settings(mesh)
            annotate_part(info_file, name, notes=notes, mesh=settings, link=link)
        except ThinPartError as error:
            self._send(kept={**response, "sentence": str(error)})
            return
        self._send(kept={**response, "sentence": ""})
        if root in self._libraries:
            self.refresh([root])

    def _read_conditions(self, text):
        """Parse conditions; returns the error message, empty on success."""
        try:
            self._conditions = search_conditions(text) if text.strip() else ()
        except ThinPartError as error:
            return str(error)
        return ""

    def _send_new_libraries(self):
        """Send the state of libraries whose parts were read anew: the rows of the last search are no longer theirs."""
        self._serial = None
        self._send_libraries()

    def _send_libraries(self):
        self._send(libraries=[vars(state) for state in self._libraries.states])

    def _row_contents(self, start, end):
        return [part and self._row_content(part) for part in self._libraries.rows(start, end)]

    def _row_content(self, part):
        content = {**stored_row(part.stored), "root": self._libraries.root_of(part)}
        if part.score is not None:
            content.update(score=part.score, reasons=part.reasons)
        return content


_REQUESTS = ("open", "refresh", "stop", "find", "rows", "record", "keep")
_INTERNAL_REQUESTS = ("progress", "grown", "refreshed")


def main():
    """Handle requests until the parent closes the pipe."""
    parent = JsonLines()
    with parent.reporting_failures():
        _serve(parent)


def _serve(parent):
    worker = LibraryWorker(parent.send, parent.incoming.put)
    while True:
        requests = [parent.incoming.get()]
        while True:
            try:
                requests.append(parent.incoming.get_nowait())
            except queue.Empty:
                break
        kinds = [request["ask"] if request else None for request in requests]
        for position, request in enumerate(requests):
            if request is None:
                parent.end()  # the next refresh does what this one has not finished
            if request["ask"] == "find" and "find" in kinds[position + 1:]:
                continue
            ask = request.pop("ask")
            if ask not in _REQUESTS + _INTERNAL_REQUESTS:
                raise KeyError(ask)
            getattr(worker, ask)(**request)


if __name__ == "__main__":
    main()
