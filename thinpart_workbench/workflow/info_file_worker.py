"""The process that writes the info file of an open document: its folder may be slow or unreachable.

It is told one job, a JSON object with the keywords of `write_job` and ``patience``, and answers with
``{"written": path, "before": verdicts or null, "now": verdicts}`` or ``{"failure": sentence}``.
"""

import os

from ..core.errors import ThinPartError
from ..freecad_adapter.linked_files import linked_files
from ..storage.info_file import info_content, new_source, stored_info, write_info
from .document_verdicts import document_verdicts
from .info_location import PATIENCE, info_location, reach
from .json_lines import JsonLines


def write_job(document, folder, stamp, settings, profile, records, failures, patience=PATIENCE):
    """Write an info file.

    Parameters
    ----------
    document : str
    folder : str
        See `info_location`.
    stamp : list of int
        `file_stamp` of the document when it was seen to be what was measured.
    settings, profile : dict
    records, failures : list of dict
    patience : float
        Seconds to wait for the folder.

    Returns
    -------
    dict
        The answer.

    Raises
    ------
    ThinPartError
    """
    path = info_location(document, folder)
    before = reach(folder, lambda: stored_info(path), patience)
    source = new_source(document, linked_files(document), path)
    if file_stamp(document) != stamp:
        raise ThinPartError(
            f"{os.path.basename(document)} was written again meanwhile: classify it again.", "unreadable")
    content = info_content(source, settings, profile, records, failures)
    reach(folder, lambda: write_info(path, content), patience)
    return {"written": os.fspath(path),
            "before": before and document_verdicts(before["parts"], before["profile"]),
            "now": document_verdicts(records, profile)}


def file_stamp(path):
    """Size and time of a file, by which it is seen whether it was written again: list of int."""
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns]


def main():
    """Do the one job."""
    lines = JsonLines()
    job = lines.incoming.get()
    if job is not None:
        try:
            lines.say(**write_job(**job))
        except ThinPartError as error:
            lines.say(failure=str(error))
    lines.end()


if __name__ == "__main__":
    main()
