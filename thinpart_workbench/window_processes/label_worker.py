"""The process that keeps a label of the user in an info file, whose folder may be slow or unreachable.

It receives one job, a JSON object with the arguments of `label_part`, and responds with ``{"labels": list}``, all labels of
that part, or ``failure`` (see `JsonLines`).
"""

from ..api.annotations import label_part
from .json_lines import JsonLines


def main():
    """Process the one job."""
    parent = JsonLines()
    job = parent.incoming.get()
    if job is not None:
        with parent.reporting_failures():
            parent.send(labels=label_part(**job).get("labels", []))
    parent.end()


if __name__ == "__main__":
    main()
