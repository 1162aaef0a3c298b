# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who is told that something has happened."""

import pytest

from thinpart_workbench.core.hook import Hook


@pytest.fixture
def told():
    return []


def test_all_are_called_in_their_order_with_what_is_told(told):
    hook = Hook()
    assert not hook
    for name in "abc":
        hook.add(lambda *what, name=name: told.append((name, *what)))
    hook("changed", 1)
    assert told == [("a", "changed", 1), ("b", "changed", 1), ("c", "changed", 1)] and len(hook) == 3


def test_who_is_removed_is_told_no_more(told):
    hook = Hook()
    hook.add(told.append)
    hook.remove(told.append)
    hook("changed")
    assert told == []
    with pytest.raises(ValueError):
        hook.remove(told.append)


def test_who_is_removed_or_added_meanwhile_has_its_turn_the_next_time(told):
    hook = Hook()

    def once():
        told.append("once")
        hook.remove(once)
        hook.add(lambda: told.append("added"))

    hook.add(once)
    hook.add(lambda: told.append("after"))
    hook()
    hook()
    assert told == ["once", "after", "after", "added"]


def failing(hook, told):
    def fail(error):
        def call():
            raise error
        return call

    errors = [ValueError("one"), KeyError("two")]
    for each in errors:
        hook.add(fail(each))
        hook.add(lambda: told.append("told"))
    return errors


def test_one_that_fails_keeps_nobody_else_from_being_told_and_each_is_reported(told):
    reported = []
    hook = Hook(reported.append)
    errors = failing(hook, told)
    hook()
    assert told == ["told", "told"] and reported == errors


def test_where_nobody_takes_reports_the_first_failure_is_raised_in_the_end(told):
    hook = Hook()
    failing(hook, told)
    with pytest.raises(ValueError, match="one"):
        hook()
    assert told == ["told", "told"]
