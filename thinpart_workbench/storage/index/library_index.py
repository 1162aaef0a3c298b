# SPDX-License-Identifier: LGPL-2.1-or-later
"""A searchable index of the info files under one folder; it can always be rebuilt from them."""

import hashlib
import json
import os
import sqlite3
from collections import namedtuple
from contextlib import suppress
from functools import cache

from ...core.descriptors.packed_distribution import least_slanted, local_share, middle_share, wall_share
from ...core.errors import ThinPartError
from ...core.foreign_text import sql_text
from ...core.judging.criteria import profile_version
from ...core.judging.packed_check import packed_walls_pass
from ...core.message import Message, message, to_data
from ...core.problem import problem_of
from ...core.regular_file import open_regular
from ..atomic_file import OWNER_ONLY
from ..cache_folder import cache_folder
from ..folder_lock import folder_lock
from ..info.info_reading import read_open_info
from ..info.info_tree import Stamp, scan, stamp_of
from ..record_columns import INDEXED
from .index_columns import LARGE_COLUMNS, large_values, small_values
from .index_version import index_version

FILES_AT_ONCE = 2000
"""Info files per transaction: bounds what a killed refresh loses, and how long a reader waits."""

BUSY_SECONDS = 60.0

_ENDINGS = ("", "-wal", "-shm")
"""Of the files of an index."""

_FILES = {
    "path": "BLOB UNIQUE NOT NULL", "bytes": "INTEGER", "modified_ns": "INTEGER", "inode": "INTEGER",
    "folder": "BLOB", "document": "BLOB", "sha256": "TEXT", "modified": "TEXT", "profile": "TEXT", "profile_version": "TEXT",
    "words": "TEXT",
}
_PARTS = {"file": "INTEGER NOT NULL", **{column.name: column.type for column in INDEXED},
          "error_kind": "TEXT", "error_message": "TEXT", "error_data": "TEXT", "verdict": "INTEGER"}
_DISTRIBUTIONS = {name: "BLOB" for name in LARGE_COLUMNS}
_VERDICTS = {"category": "TEXT NOT NULL", "criteria": "TEXT NOT NULL, UNIQUE (category, criteria)"}
"""Columns of the four tables and their types, besides ``id``. Parts are counted by verdicts, which many of them share."""

Refreshed = namedtuple("Refreshed", "files changed removed unreachable warning")
"""Numbers of info files found, reread and removed; messages about folders that could not be listed, whose
entries stay in the index; and a warning if the index could not be saved, or None."""


class LibraryIndex:
    """The index of one folder, the library.

    It has what is known of parts in many folders, some of which only this user may read: so nobody else may read it.

    SQLite with a write-ahead log: others may read during a refresh, and a killed refresh keeps the batches
    that it has finished. A damaged index is deleted and rebuilt. Programs that would build the index
    differently (`index_version`) use a file of their own, so that they do not disturb each other.

    Parameters
    ----------
    root : str or Path
    folder : str or Path, optional
        Folder of the index files; in the user's cache folder by default.

    Attributes
    ----------
    warning : str or None
        Set if the index cannot be saved on disk and is held in memory instead.
    """

    def __init__(self, root, folder=None):
        self.root = os.path.realpath(root)
        name = hashlib.sha256(os.fsencode(self.root)).hexdigest()[:20]
        self.path = f"{name}-{_version()}.sqlite"
        self.warning = None
        self._connection = None
        try:
            self.path = os.path.join(os.fspath(folder or cache_folder() / "index"), self.path)
        except OSError as error:
            self._move_to_memory(error)

    def close(self):
        """Close the file; the next use opens it again."""
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def refresh(self, report=None):
        """Bring the index up to date with the info files: Refreshed.

        Raises ThinPartError, kind ``missing`` if the folder cannot be reached at all and the index has no entries for it.

        Parameters
        ----------
        report : callable, optional
            Called with the numbers of info files read and to be read, during the search for them with 0 and
            the number found so far; may raise to stop.
        """
        found, unreachable = scan(self.root, report and (lambda count: report(0, count)))
        if b"" in unreachable and not self.query("SELECT 1 FROM files LIMIT 1"):
            raise ThinPartError(
                message("The folder {folder} cannot be reached ({problem}).",
                        folder=self.root, problem=unreachable[b""].strerror), "missing")
        try:
            changed, removed = self._with_database(lambda: self._update(found, unreachable, report))
        except sqlite3.OperationalError as error:
            self._move_to_memory(error)
            changed, removed = self._update(found, unreachable, report)
        return Refreshed(len(found), changed, removed, _unreachable_messages(self.root, unreachable), self.warning)

    def query(self, sql, values=()):
        """The rows of a SELECT, list of tuple."""
        return self._with_database(lambda: self._open().execute(sql, values).fetchall())

    def keep_ids(self, sql, values=()):
        """Keep the ids that a SELECT finds, in the table ``kept_ids``, until it is closed or others are kept."""
        def keep():
            with self._open() as database:
                database.execute("CREATE TEMP TABLE IF NOT EXISTS kept_ids (id INTEGER PRIMARY KEY)")
                database.execute("DELETE FROM kept_ids")
                database.execute(f"INSERT INTO kept_ids {sql}", values)

        self._with_database(keep)

    def relative_to(self, outer):
        """Path of its folder below that of another index, bytes."""
        return os.fsencode(os.path.relpath(self.root, outer.root))

    def _open(self):
        if self._connection is None:
            try:
                os.makedirs(os.path.dirname(self.path), exist_ok=True)
                # SQLite does not wait for other processes while it switches a new file to write-ahead logging.
                with folder_lock(os.path.dirname(self.path)):
                    _make_private(self.path)
                    self._connection = _connect(self.path)
            except (OSError, sqlite3.OperationalError) as error:
                self._move_to_memory(error)
        return self._connection

    def _move_to_memory(self, error):
        self.close()
        self.warning = message("The search index {file} cannot be saved ({problem}): it was built in memory, and the "
                               "next search has to build it again.", file=self.path, problem=problem_of(error, str(error)))
        self._connection = _connect(":memory:")

    def _with_database(self, operation):
        """Run an operation; if the index turns out to be damaged, delete it and run the operation again."""
        try:
            return operation()
        except sqlite3.OperationalError:
            raise
        except sqlite3.DatabaseError:
            self.close()
            for ending in _ENDINGS:
                with suppress(FileNotFoundError):
                    os.unlink(self.path + ending)
            return operation()

    def _update(self, found, unreachable, report):
        database = self._open()
        known = {
            bytes(path): (number, Stamp(*stamp)) for number, path, *stamp in
            database.execute("SELECT id, path, bytes, modified_ns, inode FROM files")
        }
        gone = {path: number for path, (number, _) in known.items()
                if path not in found and not _is_below(path, unreachable)}
        changed = [path for path, stamp in found.items()
                   if path not in known or known[path][1] != stamp]
        changed = self._apply_moves(database, changed, found, gone, known)
        with database:
            self._remove(database, gone.values())
        for start in range(0, len(changed), FILES_AT_ONCE):
            batch = changed[start:start + FILES_AT_ONCE]
            rows = [_read(self.root, path) for path in batch]
            with database:
                self._remove(database, [known[path][0] for path in batch if path in known])
                for row in rows:
                    _insert(database, *row)
            if report is not None:
                report(start + len(batch), len(changed))
        with database:
            database.execute(
                "DELETE FROM verdicts WHERE NOT EXISTS (SELECT 1 FROM parts WHERE parts.verdict = verdicts.id)")
        return len(changed), len(gone)

    @staticmethod
    def _apply_moves(database, changed, found, gone, known):
        """Update the paths of moved info files; returns the other changed ones."""
        by_stamp = {known[path][1]: path for path in gone}
        rest, moves = [], []
        for path in changed:
            old = None if path in known else by_stamp.pop(found[path], None)
            if old is None:
                rest.append(path)
            else:
                moves.append((path, _words(path), gone.pop(old)))
        with database:
            database.executemany("UPDATE files SET path = ?, words = ? WHERE id = ?", moves)
        return rest

    @staticmethod
    def _remove(database, numbers):
        numbers = [(number,) for number in numbers]
        database.executemany(
            "DELETE FROM distributions WHERE id IN (SELECT id FROM parts WHERE file = ?)", numbers)
        database.executemany("DELETE FROM parts WHERE file = ?", numbers)
        database.executemany("DELETE FROM files WHERE id = ?", numbers)


def _make_private(path):
    """See to it that this user alone may read an index; SQLite gives its further files the mode of the first."""
    os.close(os.open(path, os.O_RDWR | os.O_CREAT, OWNER_ONLY.mode))
    for ending in _ENDINGS:
        with suppress(OSError):  # there is none; or it is another user's, who decides about it
            os.chmod(path + ending, OWNER_ONLY.mode)


def _connect(path):
    database = sqlite3.connect(path, timeout=BUSY_SECONDS, check_same_thread=False)
    try:
        database.execute("PRAGMA journal_mode = WAL")
        database.execute("PRAGMA synchronous = NORMAL")
        database.execute("PRAGMA temp_store = MEMORY")
        database.create_function("wall_share", 4, wall_share, deterministic=True)
        database.create_function("middle_share", 12, middle_share, deterministic=True)
        database.create_function("local_share", 4, local_share, deterministic=True)
        database.create_function("least_slanted", 6, least_slanted, deterministic=True)
        database.create_function("walls_pass", 16, packed_walls_pass, deterministic=True)
        tables, = database.execute("SELECT count(*) FROM sqlite_master WHERE type = 'table'").fetchone()
        if tables < 4:
            with database:
                database.execute("BEGIN IMMEDIATE")
                for statement in _schema():
                    database.execute(statement)
    except BaseException:
        database.close()
        raise
    return database


def _schema():
    for table, columns in (
            ("files", _FILES), ("parts", _PARTS), ("distributions", _DISTRIBUTIONS), ("verdicts", _VERDICTS)):
        listed = ", ".join(f"{name} {kind}" for name, kind in columns.items())
        yield f"CREATE TABLE IF NOT EXISTS {table} (id INTEGER PRIMARY KEY, {listed})"
    yield "CREATE INDEX IF NOT EXISTS parts_by_file ON parts (file)"
    yield "CREATE INDEX IF NOT EXISTS parts_by_verdict ON parts (verdict)"


@cache
def _version():
    return index_version(_schema())


def _read(root, path):
    """The index rows of one info file: its own, and those of its parts and failures or of the failure to read it."""
    full = os.path.join(root, os.fsdecode(path))
    name, stamp, failure = os.path.basename(full), None, None
    source_values: tuple
    try:
        with open_regular(full) as file:
            status = os.fstat(file.fileno())  # of the opened file
            stamp = stamp_of(status)
            content = read_open_info(file, name)
        rows = [(small_values(part), large_values(part)) for part in content["parts"]]
        failures = [tuple(entry.get(key) for key in ("part", "label", "kind", "message"))
                    for entry in content.get("failures", ())]
        source = content["source"]
        source_values = (os.fsencode(source.get("folder", "")), os.fsencode(source["file"]),
                 source["sha256"], source["modified"], sql_text(content["profile"]["name"]),
                 profile_version(content["profile"]))
    except ThinPartError as error:
        failure = str(error)
    except OSError as error:
        failure = message("The info file {info_file} cannot be read ({problem}).",
                          info_file=name, problem=error.strerror)
    if failure is not None:
        rows, failures, source_values = [], [(None, None, "info_file", failure)], (b"", None, None, None, None, None)
    return path, stamp, (*source_values, _words(path)), rows, failures


def _words(path):
    """The path in the form in which words are searched in it."""
    return sql_text(os.fsdecode(path)).casefold()


def _insert_statement(table, columns):
    return f"INSERT OR REPLACE INTO {table} ({', '.join(columns)}) VALUES ({', '.join('?' * len(columns))})"


_INSERT_FILE = _insert_statement("files", (
    "path", "bytes", "modified_ns", "inode", "folder", "document", "sha256", "modified", "profile", "profile_version",
    "words"))
_INSERT_PART = _insert_statement("parts", ("file", *(column.name for column in INDEXED)))
_VERDICT_PLACES = [[column.name for column in INDEXED].index(name) for name in _VERDICTS]
_INSERT_LARGE = _insert_statement("distributions", ("id", *LARGE_COLUMNS))
_INSERT_FAILURE = _insert_statement("parts", ("file", "name", "label", "error_kind", "error_message", "error_data"))


def _insert(database, path, stamp, source_values, rows, failures):
    file = database.execute(_INSERT_FILE, (path, *(stamp or (None, None, None)), *source_values)).lastrowid
    for small, large in rows:
        number = database.execute(_INSERT_PART, (file, *small)).lastrowid
        verdict = [small[place] for place in _VERDICT_PLACES]
        database.execute("INSERT OR IGNORE INTO verdicts (category, criteria) VALUES (?, ?)", verdict)
        database.execute("UPDATE parts SET verdict = (SELECT id FROM verdicts WHERE category = ? AND criteria = ?) "
                         "WHERE id = ?", (*verdict, number))
        database.execute(_INSERT_LARGE, (number, *large))
    database.executemany(_INSERT_FAILURE, [
        (file, *(value and sql_text(value) for value in (*failure, _message_json(failure[-1]))))
        for failure in failures])


def _message_json(sentence):
    """JSON of the template and fields of a failure's message; None if they are unknown or cannot be stored as text."""
    is_storable = isinstance(sentence, Message) and sql_text(sentence) == sentence
    return json.dumps(to_data(sentence)) if is_storable else None


def _is_below(path, folders):
    """Whether a path lies below one of the folders; b"" is the root."""
    return any(not folder or path.startswith(folder + b"/") for folder in folders)


def _unreachable_messages(root, unreachable):
    return [message("The folder {folder} cannot be listed ({problem}): its parts are shown as they were last read.",
                    folder=os.path.join(root, os.fsdecode(folder)), problem=error.strerror)
            for folder, error in unreachable.items()]
