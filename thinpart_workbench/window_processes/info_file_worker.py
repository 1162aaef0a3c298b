"""The process that writes the info file of an open document: its folder may be slow or unreachable.

It receives one job, a JSON object with the arguments of `write_document_info`, and responds with
``{"written": path, "before": verdicts or null, "now": verdicts, "labels": labels by part}`` or ``failure`` (see
`JsonLines`).
"""

from ..api.document_info import write_document_info
from ..core.analysis_settings import AnalysisSettings
from .json_lines import JsonLines


def main():
    """Process the one job."""
    parent = JsonLines()
    job = parent.incoming.get()
    if job is not None:
        with parent.reporting_failures():
            written = write_document_info(**{**job, "settings": AnalysisSettings(**job["settings"])})
            parent.send(written=written.path, before=written.before, now=written.now, labels=written.labels)
    parent.end()


if __name__ == "__main__":
    main()
