import os
import signal
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]

# What runs in the background, or under nohup, is deaf to these, and programs that tests start would be deaf as well.
for number, handler in ((signal.SIGINT, signal.default_int_handler), (signal.SIGHUP, lambda *_: None)):
    if signal.getsignal(number) == signal.SIG_IGN:
        signal.signal(number, handler)


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory):
    """What is kept in the user's cache goes elsewhere, also from processes that tests start."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("THINPART_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture
def rng():
    """Random numbers that are the same in every run."""
    return np.random.default_rng(20120507)


@pytest.fixture(scope="session")
def real_samples():
    """Folder of labelled third-party parts, which are not part of the repository."""
    folder = Path(os.environ.get("THINPART_SAMPLES", ROOT.parent / "shared" / "samples"))
    if not (folder / "manifest.csv").is_file():
        pytest.skip("the labelled sample parts are not on this machine")
    return folder


@pytest.fixture(scope="session")
def training_parts():
    """Folder of third-party parts to learn from, which are not part of the repository."""
    folder = Path(os.environ.get("THINPART_TRAINING", ROOT.parent / "shared" / "training"))
    if not folder.is_dir():
        pytest.skip("the parts to learn from are not on this machine")
    return folder
