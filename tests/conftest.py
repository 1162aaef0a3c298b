# SPDX-License-Identifier: LGPL-2.1-or-later
import os
import signal
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import time_limit

ROOT = Path(__file__).resolve().parents[1]
LONG_TESTS = Path(__file__).with_name("long_tests.txt")

# What runs in the background, or under nohup, is deaf to these, and programs that tests start would be deaf as well.
for number, handler in ((signal.SIGINT, signal.default_int_handler), (signal.SIGHUP, lambda *_: None)):
    if signal.getsignal(number) == signal.SIG_IGN:
        signal.signal(number, handler)


def pytest_addoption(parser):
    parser.addoption("--quick", action="store_true", help="leave out the tests that tests/long_tests.txt names")


def pytest_collection_modifyitems(config, items):
    """Of --quick: a test that is asked for by its own name runs anyway."""
    if not config.getoption("quick"):
        return
    named = {each.partition("[")[0] for each in config.args if "::" in each}
    long = {line for line in LONG_TESTS.read_text(encoding="utf-8").splitlines() if not line.startswith("#")} - named
    left_out = [item for item in items if item.nodeid.partition("[")[0] in long]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if item not in left_out]


def pytest_configure(config):
    """Where the stacks go of a test that nothing but the end of the run can end: past pytest's capturing."""
    with config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        time_limit.stacks_to(os.dup(sys.stderr.fileno()))


@pytest.hookimpl(optionalhook=True, hookwrapper=True)
def pytest_xdist_newgateway(gateway):
    """Let a process of pytest-xdist finish answering before it is given the tests.

    With --verbose it is asked for its version first. execnet runs what comes while the main thread still answers in
    another thread, where no test can set a signal handler (pytest-dev/execnet issue 96).
    """
    yield
    while gateway.remote_status().numexecuting:
        time.sleep(0.01)
    time.sleep(0.1)  # it counts itself as free a moment before its main thread is


@pytest.hookimpl(tryfirst=True)
def pytest_timeout_set_timer(item, settings):
    """pytest-timeout reads pytest.ini and the markers; what happens then is said by time_limit."""
    time_limit.begin(item.nodeid, settings.timeout)
    return True


@pytest.hookimpl(tryfirst=True)
def pytest_timeout_cancel_timer():
    """The test has ended, or failed and is taken down, which may not take for ever either."""
    time_limit.end()
    return True


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_teardown(item):
    """What a failed test leaves to be taken down has a time of its own."""
    if not time_limit.runs():
        time_limit.begin(f"{item.nodeid} (what comes after it)", time_limit.TEARDOWN_SECONDS)
    yield


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """A test that took too long has failed, also where nobody heard so: Qt keeps what its slots raise."""
    outcome = yield
    report, told = outcome.get_result(), time_limit.untold()
    if told and report.passed:
        report.outcome, report.longrepr = "failed", told


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
    return _labelled_parts("THINPART_SAMPLES", "samples")


@pytest.fixture(scope="session")
def training_parts():
    """Folder of labelled third-party parts to learn from, which are not part of the repository."""
    return _labelled_parts("THINPART_TRAINING", "training")


def _labelled_parts(variable, name):
    folder = Path(os.environ.get(variable, ROOT.parent / "shared" / name))
    if not (folder / "manifest.csv").is_file():
        pytest.skip(f"the labelled parts of shared/{name} are not on this machine")
    return folder
