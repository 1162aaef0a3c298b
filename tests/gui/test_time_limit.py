# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs in the window is ended, and what it waited for is told."""

import pytest
import time_limit
import window_actions as window

from thinpart_workbench.gui.application.qt import QtWidgets, execute


def test_a_wait_says_what_for_and_what_the_window_shows(document):
    window.add_ribbed_block(document)
    window.classify()
    with pytest.raises(AssertionError) as raised:
        window.wait_until(lambda: window.is_shown("ThinPart_Nothing"), seconds=0.1)
    said = str(raised.value)
    assert said.startswith("waited 0.1 s for ") and 'lambda: window.is_shown("ThinPart_Nothing")' in said
    assert f"ThinPart_Headline: '{window.text('ThinPart_Headline')}'" in said
    with pytest.raises(AssertionError, match="^waited 0.1 s for Godot\n"):
        window.wait_until(lambda: False, "Godot", 0.1)


def test_a_dialog_that_nobody_answers_is_closed_and_told(request):
    box = QtWidgets.QMessageBox()
    box.setText("Really?")
    time_limit.end()
    time_limit.begin("this test", 0.3)
    execute(box)
    said = time_limit.untold()
    time_limit.end()
    time_limit.begin(request.node.nodeid, 60)
    assert said.startswith("this test has not ended after 0.3 s.") and "'Really?'" in said
