# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that has loaded everything before a part is to be measured."""

import os
import signal

import window_actions as window

from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets


def waiting():
    """Number of the process that waits, once there is one."""
    window.wait_until(lambda: lifelong.standby_worker.process_id)
    return lifelong.standby_worker.process_id


def test_the_next_part_is_measured_by_the_process_that_waits(document):
    window.add_ribbed_block(document)
    window.classify()
    number = waiting()
    assert window.workers() == []
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)
    assert window.workers() == [number] and lifelong.standby_worker.process_id is None
    window.wait_until_measured()
    assert window.text("ThinPart_Headline") == "Part with thin features"
    assert waiting() != number


def test_one_that_has_died_meanwhile_is_not_waited_for(document):
    window.add_ribbed_block(document)
    window.classify()
    os.kill(waiting(), signal.SIGKILL)
    window.wait_until(lambda: lifelong.standby_worker.process_id is None)
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"


def test_one_that_was_made_in_other_surroundings_is_not_taken(document, monkeypatch):
    window.add_ribbed_block(document)
    window.classify()
    number = waiting()
    monkeypatch.setenv("THINPART_EXAMPLE", "1")
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)
    assert number not in window.workers()
    window.wait_until_measured()


def test_it_ends_when_its_input_does():
    lifelong.standby_worker.prepare_next()
    number = waiting()
    window.settle(1500)  # it has loaded, and waits
    process, = [each for each in QtWidgets.QApplication.instance().findChildren(QtCore.QProcess)
                if each.processId() == number]
    process.closeWriteChannel()
    window.wait_until(lambda: lifelong.standby_worker.process_id is None)
    assert not os.path.exists(f"/proc/{number}/exe")
