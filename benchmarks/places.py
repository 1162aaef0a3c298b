# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where things are: of this checkout, and what is kept from run to run."""

import os
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks" / "results"
CACHE = Path(os.environ.get("THINPART_CACHE") or "~/.cache/thinpart").expanduser() / "benchmarks"
DEBIAN_PYTHON = "/usr/bin/python3"
