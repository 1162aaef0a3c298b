"""The process behind a window that searches libraries: it reads, filters, compares and keeps.

It answers requests, JSON objects with ``ask`` and what the request takes, in their order; see the
methods of `LibraryWorker`. Of several ``find`` only the last is answered.
"""

import os
import queue
import time
from collections import Counter
from datetime import datetime

import numpy as np

from ..core.conditions import search_conditions
from ..core.errors import ThinPartError
from ..storage.info_file import read_info
from ..storage.library_index import LibraryIndex
from ..storage.part_query import PartQuery
from ..storage.thumbnails import thumbnail_path
from .json_lines import JsonLines
from .kept_notes import keep_with_part, mesh_settings, one_of
from .library_refresh import LibraryRefresh
from .part_columns import PartColumns
from .similar_parts import similar_parts

MOST_SIMILAR = 200

FIRST_ROWS = 100
"""Rows that come with what was found."""

_LEFT_OUT = ("faces",)
"""Keys of a part record that nobody shows, and that are long."""


class LibraryWorker:
    """Libraries, and what was found in them last.

    Parameters
    ----------
    say : callable
        Takes what the parent is told, as keywords.
    tell : callable
        Takes requests that the worker makes of itself, from another thread.
    """

    def __init__(self, say, tell):
        self._say = say
        self._refresh = LibraryRefresh(tell)
        self._indexes, self._states = {}, {}
        self._columns = PartColumns([])
        self._serial, self._rows, self._like = None, np.empty(0, np.int64), {}
        self._conditions = ()
        self._loaded, self._load_seconds = 0.0, 0.0

    def open(self, roots):
        """Search these libraries from now on; tells ``libraries``, at once and after each refresh."""
        for root in roots:
            if root not in self._indexes:
                self._indexes[root] = LibraryIndex(root)
                self._states[root] = {"problems": [], "busy": True}
                self._refresh.add(root)
        for root in set(self._indexes) - set(roots):
            self._indexes.pop(root).close()
            self._states.pop(root)
        self._indexes = {root: self._indexes[root] for root in roots}
        self._load()

    def refresh(self, roots=None):
        """Bring libraries up to date, all of them when left out; tells ``progress`` and ``libraries``."""
        for root in roots or self._indexes:
            self._states[root]["busy"] = True
            self._refresh.add(root)
        self._tell_libraries()

    def stop(self):
        """Leave off refreshing; what was read is kept."""
        self._refresh.stop()

    def progress(self, root, done, total):
        """A refresh goes on."""
        if root in self._indexes:
            self._say(progress={"root": root, "done": done, "total": total})

    def grown(self, root):
        """A refresh has made more of a library readable."""
        # Loading takes as long as the library is large: most of the time is left for reading.
        if root in self._indexes and time.monotonic() - self._loaded > 10.0 * self._load_seconds:
            self._load()

    def refreshed(self, root, index, problems, stopped):
        """A refresh has ended."""
        if root not in self._indexes:
            return  # removed meanwhile
        if index is not None and index.warning:
            self._indexes[root] = index  # in memory, so this is the only one that knows
        self._states[root] = {"problems": problems, "busy": False, "stopped": stopped}
        self._load()

    def find(self, serial, query, sort="file", descending=False, current=None, like=None):
        """Tells ``found``: counts, first rows and the place of the current part.

        Conditions that are not understood are told as ``refusal``; the last ones that were hold on.

        Parameters
        ----------
        serial : int
        query : dict
            Fields of a PartQuery; ``conditions`` as text, ``changed_since`` as ISO date.
        sort : str
            One of `SORTABLE`, or ``score``.
        descending : bool
        current : list of str, optional
            Library, info file and name of a part.
        like : dict, optional
            ``record``, ``excluding`` (info file and name, or None) and ``same_size``: the parts most
            like one, among those that fulfil the query.
        """
        refusal = self._read_conditions(query.pop("conditions", ""))
        selection = self._columns.select(_query(query, self._conditions))
        rows, self._like = selection.rows, {}
        matching = len(rows)
        if like is not None:
            rows = self._most_like(rows, **like)
        if sort != "score":
            rows = self._columns.sorted(rows, sort, descending)
        self._serial, self._rows = serial, rows
        self._say(found={
            "serial": serial, "refusal": refusal,
            "count": len(rows), "matching": matching, "total": len(self._columns),
            "categories": selection.categories, "criteria": selection.criteria,
            "flags": selection.flags, "histograms": selection.histograms, "scales": self._columns.scales,
            "current": self._place_of(current), "rows": self._told_rows(0, FIRST_ROWS),
        })

    def rows(self, serial, start, end):
        """Tells ``rows`` of what was found last."""
        if serial == self._serial:
            self._say(rows={"serial": serial, "start": start, "rows": self._told_rows(start, end)})

    def record(self, info_file, name):
        """Tells ``record``: a part's record and the profile by which it was judged."""
        told = {"info_file": info_file, "name": name}
        try:
            content = read_info(info_file)
            record = one_of(content["parts"], name, info_file)
        except ThinPartError as error:
            self._say(record={**told, "sentence": str(error)})
            return
        record = {key: value for key, value in record.items() if key not in _LEFT_OUT}
        self._say(record={**told, "record": record, "profile": content["profile"]})

    def keep(self, root, info_file, name, notes, mesh, link):
        """Set what is kept with a part, None leaves as it is.

        Tells ``kept``, with a sentence where it failed.
        """
        told = {"info_file": info_file, "name": name}
        try:
            settings = None if mesh is None else mesh_settings(mesh)
            keep_with_part(info_file, name, notes=notes, mesh=settings, link=link)
        except ThinPartError as error:
            self._say(kept={**told, "sentence": str(error)})
            return
        self._say(kept={**told, "sentence": ""})
        if root in self._indexes:
            self.refresh([root])

    def _read_conditions(self, text):
        """A sentence where they are not understood, else empty."""
        try:
            self._conditions = search_conditions(text) if text.strip() else ()
        except ThinPartError as error:
            return str(error)
        return ""

    def _load(self):
        started = time.monotonic()
        self._columns = PartColumns(self._indexes.values())
        self._serial = None
        self._loaded = time.monotonic()
        self._load_seconds = self._loaded - started
        self._tell_libraries()

    def _tell_libraries(self):
        counts = Counter(dict(zip(self._indexes, self._columns.counts)))
        self._say(libraries=[{"root": root, "parts": counts[root], **state}
                             for root, state in self._states.items()])

    def _most_like(self, rows, record, excluding, same_size):
        indexes = list(self._indexes.values())
        found = similar_parts(
            indexes, record, MOST_SIMILAR, same_size, excluding and tuple(excluding),
            self._columns.ids_by_index(rows))
        places = {index.root: place for place, index in enumerate(indexes)}
        rows = [int(self._columns.rows_of(places[each.part.root], [each.part.id])[0]) for each in found]
        self._like = {row: each for row, each in zip(rows, found) if row >= 0}
        return np.array(list(self._like), dtype=np.int64)

    def _place_of(self, current):
        if current is None or current[0] not in self._indexes:
            return None
        root, info_file, name = current
        index = self._indexes[root]
        ids = index.query(
            "SELECT parts.id FROM parts JOIN files ON files.id = parts.file WHERE path = ? AND name IS ?",
            (os.fsencode(os.path.relpath(info_file, index.root)), name))
        rows = self._columns.rows_of(list(self._indexes).index(root), [number for number, in ids])
        places = np.flatnonzero(np.isin(self._rows, rows))
        return int(places[0]) if len(places) else None

    def _told_rows(self, start, end):
        rows = self._rows[start:end]
        roots = {index.root: root for root, index in self._indexes.items()}
        return [part and self._told(part, roots[part.root], self._like.get(row))
                for part, row in zip(self._columns.parts(rows), rows.tolist())]

    def _told(self, part, root, similar):
        told = {**part._asdict(), "root": root, "place": os.path.relpath(part.file, part.root)}
        if part.sha256 and part.name:
            told["thumbnail"] = os.fspath(thumbnail_path(part.sha256, part.name))
        if similar is not None:
            told.update(score=similar.score, reasons=similar.reasons)
        return told


def _query(content, conditions):
    since = content.pop("changed_since", None)
    content.update({key: tuple(value) for key, value in content.items() if isinstance(value, list)})
    return PartQuery(
        conditions=conditions, failed=None, changed_since=since and datetime.fromisoformat(since), **content)


_ASKED = ("open", "refresh", "stop", "find", "rows", "record", "keep")
_OWN = ("progress", "grown", "refreshed")


def main():
    """Answer until the parent closes its end."""
    lines = JsonLines()
    worker = LibraryWorker(lines.say, lines.incoming.put)
    while True:
        requests = [lines.incoming.get()]
        while True:
            try:
                requests.append(lines.incoming.get_nowait())
            except queue.Empty:
                break
        latest = [each["ask"] if each else None for each in requests]
        for place, request in enumerate(requests):
            if request is None:
                lines.end()  # what a refresh has not finished is done by the next one
            if request["ask"] == "find" and "find" in latest[place + 1:]:
                continue
            ask = request.pop("ask")
            if ask not in _ASKED + _OWN:
                raise KeyError(ask)
            getattr(worker, ask)(**request)


if __name__ == "__main__":
    main()
