# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers of Dask workers: results of analyses, and nothing that only looks like them."""

import json
import os
import pickle

import pytest
from made_library import record_of

from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.cluster.cluster_answer import (
    THREADS,
    VERSIONS,
    checked,
    response_from,
    software_from,
)
from thinpart_workbench.workflow.cluster.plain_pickles import PickleRefused, plain_pickles_only, texts_of_pickle

TASK = FileTask("/here/a.step")

SOFTWARE = {"host": "anvil", "freecad": "1.1.0", "thinpart": "0.1.0", "python": "3.13.1"}
FAILURE = {"part": None, "label": "x", "kind": "no_solid", "message": "It is none."}
OUTCOME = {"file": "/share/a.step", "parts": [record_of("plate")], "failures": [FAILURE], "reused": False,
           "seconds": 0.5, "confinement": {"files": "landlock", "network": "seccomp"}}


def answer(outcome, software=SOFTWARE):
    return json.dumps({"software": software, "outcome": outcome if outcome is None else json.dumps(outcome)})



def test_a_result_comes_through():
    software, outcome = response_from(answer(OUTCOME), TASK)
    assert software == SOFTWARE and outcome == {**OUTCOME, "file": TASK.file}
    assert response_from(answer(None), TASK)[1] is None
    failed = {"file": "x", "error": {"kind": "timeout", "message": "It took long."}, "seconds": 3.0}
    assert response_from(answer(failed), TASK)[1] == {**failed, "file": TASK.file}


@pytest.mark.parametrize("change", [
    {"parts": None}, {"parts": [{}]}, {"parts": ["x"]}, {"failures": 3}, {"failures": [{"kind": 1, "message": ""}]},
    {"failures": [{"kind": "a", "message": "b"}]}, {"error": "x"}, {"error": {"kind": "x"}}, {"seconds": "x"},
    {"seconds": True}, {"confinement": {"files": 3}}])
def test_an_outcome_that_is_none_is_refused(change):
    with pytest.raises(ValueError):
        response_from(answer({**OUTCOME, **change}), TASK)


@pytest.mark.parametrize("change", [
    {"name": None}, {"label": ["x"]}, {"instances": "many"}, {"warnings": [3]},
    {"descriptors": {}}, {"descriptors": {**OUTCOME["parts"][0]["descriptors"], "box_mm": ["a", "b", "c"]}},
    {"margin": "large"}])
def test_a_part_that_is_none_is_refused(change):
    with pytest.raises(ValueError):
        response_from(answer({**OUTCOME, "parts": [{**OUTCOME["parts"][0], **change}]}), TASK)


@pytest.mark.parametrize("text", [None, 7, b"{}", "", "[]", "{", "{}", "[" * 100000, '{"software": {}, "outcome": null}',
                                  {"software": SOFTWARE, "outcome": None}])
def test_what_is_no_answer_is_refused(text):
    for read in (lambda text: response_from(text, TASK), software_from):
        with pytest.raises(ValueError):
            read(text)


def test_what_no_outcome_has_is_left_out():
    failed = {"file": "x", "error": {"kind": "timeout", "message": "It took long."}}
    assert response_from(answer({**failed, "parts": 7, "failures": [7]}), TASK)[1] == {**failed, "file": TASK.file}


def test_versions_and_threads_come_through():
    entry = {"host": {"python": "3.13.1.final.0", "OS": "Linux"}, "packages": {}}
    versions = {"scheduler": entry, "workers": {"tcp://a:1": entry}, "client": entry}
    assert checked(VERSIONS, versions) == versions
    for threads in ({"tcp://a:1": 2, "tcp://b:1": 3}, {}):
        assert checked(THREADS, threads) == threads


@pytest.mark.parametrize("versions", [None, 7, [], {}, {"scheduler": None, "workers": {}},
                                      {"scheduler": {"host": {}}, "workers": {}},
                                      {"scheduler": {"host": {"python": 3}}, "workers": {}}, {"scheduler": 7, "workers": 7},
                                      {"scheduler": {"host": {"python": "3.13"}}, "workers": {"a": None}}])
def test_versions_that_are_none_are_refused(versions):
    with pytest.raises(ValueError):
        checked(VERSIONS, versions)


@pytest.mark.parametrize("threads", [None, 7, [], {"a": "x"}, {"a": -1}, {"a": None}, {7: 1}])
def test_threads_that_are_none_are_refused(threads):
    with pytest.raises(ValueError):
        checked(THREADS, threads)


class Program:
    def __init__(self, *calls):
        self.calls = calls

    def __reduce__(self):
        return self.calls


def test_pickles_of_programs_are_refused_and_read_as_text(tmp_path):
    ran = tmp_path / "ran"
    program = pickle.dumps({"result": Program(os.mkdir, (str(ran),))})
    plain = [1, 2.5, "x", b"y", {"z": (None, True)}, {1, 2}, bytearray(b"q"), frozenset("a")]
    with plain_pickles_only():
        with pytest.raises(PickleRefused, match="mkdir"):
            pickle.loads(program)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            if protocol > 2:  # before, bytes are written as a call of a codec
                assert pickle.loads(pickle.dumps(plain, protocol)) == plain
    assert not ran.exists()
    assert {"mkdir", str(ran)} <= set(texts_of_pickle(program))
    assert texts_of_pickle(b"no pickle") == [] and texts_of_pickle(program[:-20])[:1] == ["result"]
    pickle.loads(program)
    assert ran.exists()
