# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in threads beside the window's."""

import gc
import threading

import window_actions as window

from thinpart_workbench.gui.application.thread_work import work_in_thread


def test_results_and_errors_come_in_the_thread_of_the_window_and_nothing_is_collected_meanwhile():
    found, seen, go_on = [], [], threading.Event()

    def work():
        go_on.wait(30)
        seen.append(gc.isenabled())
        return threading.get_ident()

    def fail():
        raise ValueError("no")

    work_in_thread(work, lambda result: found.append((result, threading.get_ident())))
    work_in_thread(fail, lambda result: found.append((result, threading.get_ident())))
    window.wait_until(lambda: len(found) == 1)
    assert isinstance(found[0][0], ValueError) and found[0][1] == threading.get_ident()
    assert not gc.isenabled()  # the other one still runs
    go_on.set()
    window.wait_until(lambda: len(found) == 2)
    assert seen == [False] and gc.isenabled()
    assert found[1][0] != found[1][1] == threading.get_ident()
