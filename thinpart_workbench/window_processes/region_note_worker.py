"""The process that reads and keeps what the user says of wall regions, in an info file whose folder may be slow.

It receives one job, a JSON object with ``document`` and ``folder`` (see `region_notes`), and for what is to be kept also the
other arguments of `note_regions`. It responds with ``{"notes": dict}``, the result of `region_notes`, or ``failure`` (see
`JsonLines`).
"""

from ..api.annotations import note_regions, region_notes
from ..storage.info.info_location import info_location
from .json_lines import JsonLines


def main():
    """Process the one job."""
    parent = JsonLines()
    job = parent.incoming.get()
    if job is not None:
        with parent.reporting_failures():
            path = info_location(job.pop("document"), job.pop("folder"))
            if job:
                note_regions(path, **job)
            parent.send(notes=region_notes(path))
    parent.end()


if __name__ == "__main__":
    main()
