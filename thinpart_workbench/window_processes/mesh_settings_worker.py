"""The process that keeps mesh settings that worked, and finds them for a part, in folders that may be slow.

It receives one job, a JSON object with ``document`` (empty for one that was never saved) and ``folder`` of info files.
With ``keep``, the arguments of `keep_mesh_settings`, it keeps them and responds with ``{"kept": bool}``: there may be no
info file. With ``record`` and ``roots`` it responds with ``{"offer": dict}``, the result of `settings_that_worked`. Or with
``failure`` (see `JsonLines`).
"""

import os

from ..api.annotations import keep_mesh_settings, settings_that_worked
from ..storage.info.info_location import info_location
from .json_lines import JsonLines


def main():
    """Process the one job."""
    parent = JsonLines()
    job = parent.incoming.get()
    if job is not None:
        with parent.reporting_failures():
            path = info_location(job["document"], job["folder"]) if job["document"] else None
            if "keep" in job:
                is_there = path is not None and os.path.isfile(path)
                if is_there:
                    keep_mesh_settings(path, **job["keep"])
                parent.send(kept=is_there)
            else:
                parent.send(offer=settings_that_worked(job["record"], [root for root in job["roots"] if os.path.isdir(root)],
                                                       path))
    parent.end()


if __name__ == "__main__":
    main()
