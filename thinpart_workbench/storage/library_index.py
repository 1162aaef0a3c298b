"""A searchable index of the info files under one folder; it can always be made again from them."""

import hashlib
import os
import sqlite3
import struct
from collections import namedtuple
from contextlib import suppress

from ..core.errors import ThinPartError
from ..core.packed_distribution import least_slanted, wall_share
from .cache_folder import cache_folder
from .folder_lock import folder_lock
from .index_columns import COLUMNS, LARGE_COLUMNS, large_values, small_values
from .info_file import read_open_info
from .info_tree import Stamp, scan, stamp_of
from .regular_file import open_regular

VERSION = 1
"""Of the index; part of its file name, so that programs of two versions do not disturb each other."""

FILES_AT_ONCE = 2000
"""Info files between two commits: what a killed refresh keeps, and how long a reader may wait."""

BUSY_SECONDS = 60.0

_FILES = (
    "path BLOB UNIQUE NOT NULL", "bytes INTEGER", "modified_ns INTEGER", "inode INTEGER",
    "folder BLOB", "document BLOB", "sha256 TEXT", "modified TEXT", "profile TEXT", "words TEXT",
)
_FAILURE_COLUMNS = ("error_kind TEXT", "error_message TEXT")

Refreshed = namedtuple("Refreshed", "files changed removed unreachable warning")
"""Info files there are, how many were read anew, how many went; sentences about folders that could not
be listed, which keep what was known of them; and one where the index could not be kept, or None."""


class LibraryIndex:
    """The index of one folder, the library.

    Parameters
    ----------
    root : str or Path
    folder : str or Path, optional
        Where indexes are kept; in the user's cache when left out.

    Attributes
    ----------
    warning : str or None
        Set where the index cannot be kept on disk and lives in memory instead.

    Notes
    -----
    SQLite with a write-ahead log: others may read while one refreshes, and a refresh that is killed
    keeps the batches that it had finished. A damaged index is removed and made anew.
    """

    def __init__(self, root, folder=None):
        self.root = os.path.realpath(root)
        name = hashlib.sha256(os.fsencode(self.root)).hexdigest()[:20]
        self.path = f"{name}-v{VERSION}.sqlite"
        self.warning = None
        self._connection = None
        try:
            self.path = os.path.join(os.fspath(folder or cache_folder() / "index"), self.path)
        except OSError as error:
            self._move_to_memory(error)

    def close(self):
        """Close the file; the index can be used again after."""
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def refresh(self, report=None):
        """Bring the index up to date with the info files.

        Parameters
        ----------
        report : callable, optional
            Called with the numbers of info files read and to be read, while they are looked for with
            0 and the number found so far; may raise to stop.

        Returns
        -------
        Refreshed

        Raises
        ------
        ThinPartError
            kind ``missing`` where the folder cannot be reached at all and nothing is known of it.
        """
        found, unreachable = scan(self.root, report and (lambda count: report(0, count)))
        if b"" in unreachable and not self.query("SELECT 1 FROM files LIMIT 1"):
            raise ThinPartError(
                f"The folder {self.root} cannot be reached ({unreachable[b''].strerror}).", "missing")
        try:
            changed, removed = self._with_database(lambda: self._bring_up_to_date(found, unreachable, report))
        except sqlite3.OperationalError as error:
            self._move_to_memory(error)
            changed, removed = self._bring_up_to_date(found, unreachable, report)
        return Refreshed(len(found), changed, removed, _sentences(self.root, unreachable), self.warning)

    def query(self, sql, values=()):
        """Rows that a SELECT gives, list of tuple."""
        return self._with_database(lambda: self._open().execute(sql, values).fetchall())

    def _open(self):
        if self._connection is None:
            try:
                os.makedirs(os.path.dirname(self.path), exist_ok=True)
                # SQLite does not wait for others while it turns a new file to its write-ahead log.
                with folder_lock(os.path.dirname(self.path)):
                    self._connection = _connected(self.path)
            except (OSError, sqlite3.OperationalError) as error:
                self._move_to_memory(error)
        return self._connection

    def _move_to_memory(self, error):
        self.close()
        self.warning = (f"The search index {self.path} cannot be kept ({error}): it was built in memory, and "
                        "the next search has to build it again.")
        self._connection = _connected(":memory:")

    def _with_database(self, work):
        """Do it, once more with a new index where the old one turns out to be damaged."""
        try:
            return work()
        except sqlite3.OperationalError:
            raise
        except sqlite3.DatabaseError:
            self.close()
            for ending in ("", "-wal", "-shm"):
                with suppress(FileNotFoundError):
                    os.unlink(self.path + ending)
            return work()

    def _bring_up_to_date(self, found, unreachable, report):
        database = self._open()
        known = {
            bytes(path): (number, Stamp(*stamp)) for number, path, *stamp in
            database.execute("SELECT id, path, bytes, modified_ns, inode FROM files")
        }
        gone = {path: number for path, (number, _) in known.items()
                if path not in found and not _is_below(path, unreachable)}
        changed = [path for path, stamp in found.items()
                   if path not in known or known[path][1] != stamp]
        changed = self._moved(database, changed, found, gone, known)
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
        return len(changed), len(gone)

    @staticmethod
    def _moved(database, changed, found, gone, known):
        """Give moved info files their new paths; the rest of the changed ones."""
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


def _connected(path):
    database = sqlite3.connect(path, timeout=BUSY_SECONDS, check_same_thread=False)
    try:
        database.execute("PRAGMA journal_mode = WAL")
        database.execute("PRAGMA synchronous = NORMAL")
        database.create_function("wall_share", 4, wall_share, deterministic=True)
        database.create_function("least_slanted", 6, least_slanted, deterministic=True)
        tables, = database.execute("SELECT count(*) FROM sqlite_master WHERE type = 'table'").fetchone()
        if tables < 3:
            with database:
                database.execute("BEGIN IMMEDIATE")
                for statement in _schema():
                    database.execute(statement)
    except BaseException:
        database.close()
        raise
    return database


def _schema():
    columns = [f"{each.name} {each.type}" for each in COLUMNS]
    large = [f"{each} BLOB" for each in LARGE_COLUMNS]
    yield f"CREATE TABLE IF NOT EXISTS files (id INTEGER PRIMARY KEY, {', '.join(_FILES)})"
    yield ("CREATE TABLE IF NOT EXISTS parts (id INTEGER PRIMARY KEY, file INTEGER NOT NULL, "
           f"{', '.join((*columns, *_FAILURE_COLUMNS))})")
    yield f"CREATE TABLE IF NOT EXISTS distributions (id INTEGER PRIMARY KEY, {', '.join(large)})"
    yield "CREATE INDEX IF NOT EXISTS parts_by_file ON parts (file)"
    yield "CREATE INDEX IF NOT EXISTS parts_by_category ON parts (category)"


def _read(root, path):
    """What the index keeps of one info file: its row, and its parts' or one failure's."""
    full = os.path.join(root, os.fsdecode(path))
    name, stamp, failure = os.path.basename(full), None, None
    try:
        with open_regular(full) as file:
            status = os.fstat(file.fileno())  # of just what is read
            stamp = stamp_of(status)
            content = read_open_info(file, name)
        rows = [(small_values(part), large_values(part)) for part in content["parts"]]
        failures = [tuple(each.get(key) and str(each[key]) for key in ("part", "label", "kind", "message"))
                    for each in content.get("failures", ())]
        source = content["source"]
        place = (os.fsencode(source.get("folder", "")), os.fsencode(source["file"]),
                 *(str(each) for each in (source["sha256"], source["modified"], content["profile"]["name"])))
    except ThinPartError as error:
        failure = str(error)
    except OSError as error:
        failure = f"The info file {name} cannot be read ({error.strerror})."
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, struct.error) as error:
        failure = (f"The info file {name} is damaged ({type(error).__name__}: {error}): classify its document "
                   "again.")
    if failure is not None:
        rows, failures, place = [], [(None, None, "info_file", failure)], (b"", None, None, None, None)
    return path, stamp, (*place, _words(path)), rows, failures


def _words(path):
    """The path as words are looked for in it."""
    return os.fsdecode(path).encode("utf-8", "replace").decode().casefold()


_INSERT_FILE = f"INSERT OR REPLACE INTO files VALUES (NULL, {', '.join('?' * len(_FILES))})"
_INSERT_PART = f"INSERT INTO parts VALUES (NULL, ?, {', '.join('?' * len(COLUMNS))}, NULL, NULL)"
_INSERT_LARGE = f"INSERT INTO distributions VALUES (?, {', '.join('?' * len(LARGE_COLUMNS))})"
_INSERT_FAILURE = "INSERT INTO parts (file, name, label, error_kind, error_message) VALUES (?, ?, ?, ?, ?)"


def _insert(database, path, stamp, place, rows, failures):
    file = database.execute(_INSERT_FILE, (path, *(stamp or (None, None, None)), *place)).lastrowid
    for small, large in rows:
        number = database.execute(_INSERT_PART, (file, *small)).lastrowid
        database.execute(_INSERT_LARGE, (number, *large))
    database.executemany(_INSERT_FAILURE, [(file, *failure) for failure in failures])


def _is_below(path, folders):
    """Whether a path lies in one of some folders, b"" being all."""
    return any(not folder or path.startswith(folder + b"/") for folder in folders)


def _sentences(root, unreachable):
    return [f"The folder {os.path.join(root, os.fsdecode(folder))} cannot be listed ({error.strerror}): what "
            "is known of it is from earlier." for folder, error in unreachable.items()]
