# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles from labels, on made parts whose best thresholds are known."""

import csv
import json
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest
from made_descriptors import part
from made_library import record_of, store

import thinpart_workbench as thinpart
from thinpart_workbench.cli import main
from thinpart_workbench.core.errors import ProfileError, ThinPartError
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile, profile_from, usable_profile
from thinpart_workbench.core.judging.probability import ProbabilityModel, Step, WeightedQuantity
from thinpart_workbench.core.judging.threshold_search import ThresholdSearch
from thinpart_workbench.storage.labels_file import read_labels
from thinpart_workbench.workflow.learning.fit_probabilities import ProbabilityFit
from thinpart_workbench.workflow.learning.validation import calibration_error, folds, share_of

pytest.importorskip("sklearn")

SPARSE = [*np.linspace(0.10, 0.50, 16)]
DENSE = [*np.linspace(0.53, 0.95, 16)]
"""Fills of the box: those below 0.52 are labelled thin. It is a candidate three steps from 0.3."""


def condition(quantity, comparison, value):
    return {"quantity": quantity, "comparison": comparison, "value": value}


def start(*conditions, more=(), **entries):
    """A profile of the category thin, with one criterion, and others of a condition each."""
    criteria = [{"id": number, "conditions": list(each)} for number, each in enumerate([conditions, *more], start=1)]
    return {"format": "thinpart-profile", "version": 1, "name": "first",
            "categories": [{"name": "thin", "criteria": criteria}], **entries}


FIRST = start(condition("V/VBB", "<", 0.3))


def filled(fill):
    record = record_of("cube", label="part")
    record["descriptors"]["volume_mm3"] = None if fill is None else 1000.0 * fill
    return record


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Parts in four folders, by their fill."""
    folder = tmp_path_factory.mktemp("library")
    for number, fill in enumerate(SPARSE + DENSE):
        store(folder / f"group {number % 4}", f"p{number:02d}.step", [filled(fill)])
    store(folder, "two.step", [dict(filled(0.1), name="Solid1"), dict(filled(0.9), name="Solid2", label="lid")])
    store(folder / "group 0", "same.step", [filled(0.1)])
    store(folder / "group 1", "same.step", [filled(0.1)])
    return folder


def rows(categories=None, **columns):
    """Rows of all parts of the folders, labelled rightly."""
    return [{"file": f"group {number % 4}/p{number:02d}.step",
             "category": (categories or {}).get(number, "thin" if number < len(SPARSE) else "normal"), **columns}
            for number in range(len(SPARSE + DENSE))]


def written(path, table):
    columns = list(dict.fromkeys(name for row in table for name in row))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(table)
    return path


@pytest.fixture
def labels(tmp_path):
    return written(tmp_path / "anna.csv", rows())


def conditions_of(content):
    return [(each["quantity"], each["comparison"], each["value"]) for category in content["categories"]
            for criterion in category["criteria"] for each in criterion["conditions"]]


# The file of labels

BAD_FILES = {
    "": "line 1: the column file, category is missing",
    "file,kind\na,thin\n": "line 1: the column category is missing",
    "file,category,File\na,thin,b\n": "line 1: the column file is there twice",
    "file,category\n": "holds no labels",
    "file,category\na,thin\nb,slim\n": "line 3: 'slim' is no category: there are thin, normal",
    "file,category\na,\n": "line 2: '' is no category",
    "file,category,second\na,thin,fat\n": "line 2: 'fat' is no category",
    "file,category,second\na,thin,thin\n": "line 2: its second answer is the first one",
    "file,category,sure\na,thin,perhaps\n": "line 2: 'perhaps' in the column sure is neither yes nor no",
    "file,category\n,thin\n": "line 2: it names no file",
    "file,category\na,b,thin\n": "line 2: it has 3 cells, and the header has 2",
    'file,category\na,"thin\n': "it is not a CSV table",
    "file,category\na\0,thin\n": "line 2: it is not text in UTF-8",
    b"file,category\na,thin\n\xff,thin\n": "line 3: it is not text in UTF-8",
    b"\x89PNG\r\n\x1a\n\0\0": "line 1: it is not text in UTF-8",
}


@pytest.mark.parametrize("content", BAD_FILES)
def test_what_is_wrong_with_a_file_of_labels_is_said_with_its_line(content, tmp_path):
    path = tmp_path / "bad.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(ThinPartError) as error:
        read_labels(path, ["thin", "normal"])
    assert str(error.value).startswith("bad.csv") and BAD_FILES[content] in str(error.value)


def test_a_file_of_labels_has_to_be_a_file(tmp_path):
    for path in (tmp_path / "none.csv", tmp_path):
        with pytest.raises(ThinPartError, match="labels"):
            read_labels(path, ["thin"])


def test_labels_are_read_as_spreadsheets_write_them(tmp_path):
    path = tmp_path / "jo.csv"
    path.write_bytes('\ufeffFile;Category;Sure;User;note\r\n"a;b.step";thin;NO;;x\r\n;;;;\r\nc.step;normal;;Eva;\r\n'.encode())
    first, other = read_labels(path, ["thin", "normal"])
    assert (first.file, first.category, first.is_sure, first.person) == ("a;b.step", "thin", False, "jo")
    assert (other.place, other.is_sure, other.person, other.group) == ("jo.csv, line 4", True, "Eva", None)


def test_the_example_of_the_documentation_is_one(tmp_path):
    text = (Path(__file__).resolve().parents[2] / "docs" / "learning.md").read_text(encoding="utf-8")
    block = text[text.index("    file,part"):].partition("\n\n")[0]
    (tmp_path / "labels.csv").write_text(textwrap.dedent(block), encoding="utf-8")
    first, other = read_labels(tmp_path / "labels.csv", ["thin", "thin_features", "normal"])
    assert (first.file, first.part, first.person, first.is_sure) == ("brackets/left.step", "", "Anna", True)
    assert (other.part, other.second, other.is_sure, other.group) == ("Body001", "normal", False, "pumps of 2019")


BAD_ROWS = {
    "is about no part": ([{"file": "nothing.step"}], "labels.csv, line 2: there is no info file of 'nothing.step'"),
    "is about several": ([{"file": "same.step"}], "line 2: 2 documents of the library are called 'same.step'"),
    "names no part": ([{"file": "two.step"}], "line 2: two.step holds 2 parts: name one in the column part: Solid1, Solid2"),
    "names another": ([{"file": "two.step", "part": "lid of it"}], "line 2: two.step has no part 'lid of it'"),
    "is there twice": ([{"file": "group 0/p00.step"}, {"file": "p00.step"}],
                       "line 3: eva has labelled this part already (labels.csv, line 2)"),
    "contradicts": ([{"file": "p00.step"}, {"file": "p01.step"}, {"file": "p00.step", "category": "normal"}],
                    "line 4: eva calls this part normal here and thin before (labels.csv, line 2)"),
}


@pytest.mark.parametrize("case", BAD_ROWS)
def test_a_row_that_cannot_be_used_is_named(case, library, tmp_path):
    table, sentence = BAD_ROWS[case]
    path = written(tmp_path / "labels.csv", [{"category": "thin", "person": "eva", **row} for row in table])
    with pytest.raises(ThinPartError) as error:
        thinpart.learn(library, path, FIRST)
    assert sentence in str(error.value)


def test_contradictions_are_found_across_files(library, tmp_path):
    one = written(tmp_path / "one.csv", [{"file": "p00.step", "category": "thin", "person": "eva"}])
    other = written(tmp_path / "other.csv", [{"file": "p00.step", "category": "normal", "person": "eva"}])
    with pytest.raises(ThinPartError, match=r"other.csv, line 2: eva calls this part normal here and thin before \(one.csv"):
        thinpart.learn(library, [one, other], FIRST)


def test_labels_are_refused_that_are_too_few(library, tmp_path):
    few = written(tmp_path / "few.csv", rows()[:20])
    with pytest.raises(ThinPartError, match="too few labels: normal 4. At least 10 parts of every .* only 72 % right"):
        thinpart.learn(library, few, FIRST)
    none = written(tmp_path / "none.csv", rows()[:16])
    with pytest.raises(ThinPartError, match="No part is labelled normal: label at least 10"):
        thinpart.learn(library, none, FIRST)


def test_a_folder_without_info_files_is_refused(labels, tmp_path):
    (tmp_path / "empty").mkdir()
    for folder, sentence in ((tmp_path / "empty", "There are no info files"), (tmp_path / "none", "There is no folder")):
        with pytest.raises(ThinPartError, match=sentence):
            thinpart.learn(folder, labels, FIRST)


# Learning

def test_the_best_threshold_is_found(library, labels):
    learned = thinpart.learn(library, labels, FIRST)
    assert conditions_of(learned.content) == [("V/VBB", "<", 0.52)]
    assert [(each.before, each.after) for each in learned.changes] == [("V/VBB < 0.3", "V/VBB < 0.52")]
    assert learned.is_better and learned.after.either.count > learned.before.either.count == 16 + 8
    assert learned.before.confusion["thin"] == {"thin": 8, "normal": 8, "unknown": 0}
    assert (learned.left_out, learned.folds, learned.counts) == ("folders", 4, {"thin": 16, "normal": 16})


def test_where_labels_do_not_speak_the_start_is_kept(library, labels):
    content = start(condition("V/VBB", "<", 0.515), more=[[condition("D2/D3", ">", 12.3)]])
    learned = thinpart.learn(library, labels, content)
    assert conditions_of(learned.content) == conditions_of(content)
    assert not learned.is_better


def test_one_label_that_does_not_fit_moves_no_threshold_far(library, tmp_path):
    path = written(tmp_path / "odd.csv", rows({31: "thin"}))
    content = start(condition("V/VBB", "<", 0.515))
    assert conditions_of(thinpart.learn(library, path, content).content) == conditions_of(content)


def test_a_condition_or_a_criterion_that_only_harms_is_left_out(library, labels):
    content = start(condition("V/VBB", "<", 0.515), condition("D2/D3", ">", 12), more=[[condition("V/VBB", ">", 0.05)]])
    learned = thinpart.learn(library, labels, content)
    assert conditions_of(learned.content) == [("V/VBB", "<", 0.515)]
    assert [each.after for each in learned.changes] == ["V/VBB < 0.515", None, None]


def made_parts(count=60):
    chance = np.random.default_rng(1)
    return [part(box=(1.0, 0.8, chance.uniform(0.05, 0.8)), fill=None if number % 15 == 0 else chance.uniform(0.05, 0.95),
                 walls=[(0.01, chance.choice([0.0, 0.1])), (0.06, chance.uniform(0.0, 0.8)), (0.4, 0.05)],
                 slanted=[(chance.uniform(0.02, 0.2), 30, 0.05)],
                 unmet=0.6 if number % 7 == 0 else 0.0, plates=chance.uniform())
            for number in range(count)]


@pytest.mark.parametrize("name", ["paper", "calibrated"])
def test_the_search_judges_as_classify_does(name):
    profile, parts = load_profile(name), made_parts()
    columns = [*(category.name for category in profile.categories), "normal"]
    verdicts = [classify(each, profile).category for each in parts]
    assert set(verdicts) == {*columns, "unknown"} or name == "paper"
    right = np.array([[verdict == column for column in columns] for verdict in verdicts], float)
    found = ThresholdSearch(profile, parts).best(right)
    assert found.profile.content == profile.content
    assert all(before == after for _, before, after in found.conditions)


def test_thresholds_stay_within_their_range():
    profile = profile_from(start(condition("plate_share", ">", 0.7), condition("F[0;0.05]", ">", 0)))
    parts = [part(plates=share, walls=[(0.01, thin)])
             for share, thin in [(0.92, 0.02)] * 20 + [(0.87, 0.02), (0.92, 0.004)] * 10]
    thin = np.arange(len(parts)) < 20
    found = ThresholdSearch(profile, parts).best(np.column_stack([thin, ~thin]).astype(float)).profile
    plates, walls = found.criteria[0].conditions
    assert 0.87 <= plates.value < 0.92 and 0.004 <= walls.value < 0.02
    assert [classify(each, found).category == "thin" for each in parts] == thin.tolist()


def test_thresholds_that_passed_each_other_are_not_kept():
    # Between them are only normal parts, so the search moves them together until nothing is left between.
    band = [condition("V/VBB", ">", 0.4), condition("V/VBB", "<", 0.5)]
    content = start(*band, more=[[condition("plate_share", ">", 0.8)]])
    parts = [part(fill=fill, plates=plates)
             for fill, plates in [(0.42, 0.1), (0.45, 0.1), (0.499, 0.1)] * 10 + [(0.9, 0.9)] * 10]
    thin = np.arange(len(parts)) >= 30
    found = ThresholdSearch(profile_from(content), parts).best(np.column_stack([thin, ~thin]).astype(float)).profile
    usable_profile(found.content)
    assert [classify(each, found).category == "thin" for each in parts] == thin.tolist()


def test_upper_bounds_of_walls_are_learned_too():
    profile = profile_from(start(condition("K[0;0.1]", ">", 0.5)))
    walls = [0.06] * 20 + [0.085] * 20 + [0.2] * 40  # of a box whose middle side is its diagonal by 0.71
    parts = [part(box=(1.0, 1.0, 1e-6), walls=[(x, 0.9)]) for x in walls]
    thin = np.arange(len(parts)) < 40
    found = ThresholdSearch(profile, parts).best(np.column_stack([thin, ~thin]).astype(float)).profile
    assert found.criteria[0].conditions[0].quantity.symbol == "K[0;0.14]"
    assert [classify(each, found).category == "thin" for each in parts] == thin.tolist()


def test_a_profile_with_an_unknown_quantity_is_refused(library, labels):
    with pytest.raises(ProfileError, match="wobble"):
        thinpart.learn(library, labels, start(condition("wobble", "<", 0.3)))


def test_parts_without_a_measured_quantity_are_unknown_and_do_not_stop_learning(tmp_path, labels):
    for number, fill in enumerate(SPARSE + DENSE):
        store(tmp_path / f"group {number % 4}", f"p{number:02d}.step", [filled(None if number == 3 else fill)])
    learned = thinpart.learn(tmp_path, labels, FIRST)
    assert conditions_of(learned.content) == [("V/VBB", "<", 0.52)]
    assert learned.after.confusion["thin"]["unknown"] == 1


def test_a_part_among_others_is_named_by_its_label(library, tmp_path):
    path = written(tmp_path / "more.csv", [*rows(), {"file": "two.step", "category": "normal", "part": "lid"}])
    learned = thinpart.learn(library, path, FIRST)
    assert learned.counts == {"thin": 16, "normal": 17} and learned.folds == 5


# Several people

def test_labels_of_several_people_are_merged_and_their_disagreement_is_shown(library, tmp_path):
    files = [written(tmp_path / f"{name}.csv", rows(odd)) for name, odd in
             (("anna", {}), ("bert", {0: "normal"}), ("cara", {0: "normal", 1: "normal"}))]
    learned = thinpart.learn(library, files, FIRST)
    assert learned.people == ("anna", "bert", "cara")
    assert learned.counts == {"thin": 15, "normal": 17}, "two of three call the first one normal, one of three the second"
    pairs = learned.disagreement.pairs
    assert (pairs.count, pairs.total) == (4, 3 * 32) and pairs.low < 4 / 96 < pairs.high
    assert learned.disagreement.parts[0] == {
        "file": "group 0/p00.step", "part": "Solid1", "answers": {"anna": "thin", "bert": "normal", "cara": "normal"}}
    assert learned.after.sure.total == 30, "what people disagree about is not sure"


def test_where_as_many_say_the_one_as_the_other_both_are_right(library, tmp_path):
    files = [written(tmp_path / "anna.csv", rows()), written(tmp_path / "bert.csv", rows({20: "thin"})[20:21])]
    learned = thinpart.learn(library, files, FIRST)
    assert learned.counts == {"thin": 17, "normal": 15}
    assert (learned.before.sure.count, learned.before.either.count) == (23, 24), "the verdict normal is right too"


# Validation

def test_what_is_left_out_can_be_said_in_the_table(library, tmp_path):
    path = written(tmp_path / "groups.csv", [{**row, "group": number % 2} for number, row in enumerate(rows())])
    assert thinpart.learn(library, path, FIRST).folds == 2


def test_parts_of_one_folder_are_left_out_by_tenths(tmp_path, labels):
    for number, fill in enumerate(SPARSE + DENSE):
        store(tmp_path / "parts", f"p{number:02d}.step", [filled(fill)])
    table = [{**row, "file": row["file"].partition("/")[2]} for row in rows()]
    learned = thinpart.learn(tmp_path / "parts", written(tmp_path / "flat.csv", table), FIRST)
    assert (learned.left_out, learned.folds) == ("parts", 10)


def test_groups_stay_together_and_each_part_is_left_out_once():
    groups = [f"g{number * number % 37}" for number in range(500)]
    outs = folds(groups)
    assert len(outs) == 10 and np.sum(outs, axis=0).tolist() == [1] * 500
    for out in outs:
        inside = {group for group, is_out in zip(groups, out) if is_out}
        assert not inside & {group for group, is_out in zip(groups, out) if not is_out}


def test_intervals_are_those_of_wilson():
    # Newcombe (1998), Two-sided confidence intervals for the single proportion, doi:10.1002/(SICI)1097-0258(19980430)17:8,
    # table I, method 3
    for count, total, low, high in ((81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611),
                                    (1, 29, 0.0061, 0.1718)):
        share = share_of([True] * count + [False] * (total - count))
        assert (share.low, share.high) == pytest.approx((low, high), abs=5e-5)
    assert (share_of([]).low, share_of([]).high) == (0.0, 1.0)


def test_the_calibration_error_is_that_of_bins():
    stated = np.array([0.95, 0.95, 0.55, 0.55])
    assert calibration_error(stated, np.array([1.0, 1.0, 1.0, 0.0])) == pytest.approx(0.05)
    assert calibration_error(stated, np.zeros(4)) == pytest.approx(0.75)


# Probabilities

def test_fitted_probabilities_are_right_on_average():
    chance = np.random.default_rng(2)
    fills = chance.uniform(0.05, 0.95, 400)
    parts = [part(fill=fill) for fill in fills]
    thin = chance.uniform(size=400) < 1.0 / (1.0 + np.exp(12.0 * (fills - 0.5)))
    fill = load_profile("paper").criteria[0].conditions[0].quantity
    model = ProbabilityModel(0.6, (Step("thin", 0.0, (WeightedQuantity(fill, 1.0),)),))
    content = ProbabilityFit(model, parts, np.column_stack([thin, ~thin]).astype(float), 1e-4).content(np.ones(400, bool))
    weight = content["steps"][0]["terms"][0]["weight"]
    assert content["unsure_under"] == 0.6 and -16.0 < weight < -9.0
    fitted = profile_from(start(condition("V/VBB", "<", 0.3), probability=content))
    stated = [fitted.probability.probabilities(each, 1e-4)["thin"] for each in parts]
    # Without a penalty on the intercept, the sum of what a logistic regression states is that of what it was fitted to.
    assert np.mean(stated) == pytest.approx(thin.mean(), abs=0.01)


def test_a_step_without_examples_keeps_its_weights():
    model = load_profile("calibrated").probability
    parts = made_parts(30)
    truth = np.tile([0.0, 0.0, 1.0], (30, 1))
    content = ProbabilityFit(model, parts, truth, 1e-4).content(np.ones(30, bool))
    assert content == load_profile("calibrated").content["probability"]


def test_the_profile_states_probabilities_where_the_start_does(library, labels):
    assert "probability" not in thinpart.learn(library, labels, FIRST).content, "the default's are of other categories"
    probability = {"unsure_under": 0.7, "steps": [
        {"category": "thin", "intercept": 0.0, "terms": [{"quantity": "V/VBB", "weight": 1.0}]}]}
    learned = thinpart.learn(library, labels, {**FIRST, "probability": probability})
    found = learned.content["probability"]
    assert found["unsure_under"] == 0.7 and found["steps"][0]["terms"][0]["weight"] < -3.0
    assert learned.after.calibration_error < learned.before.calibration_error


def test_a_start_without_probabilities_gets_those_of_the_default_of_like_categories(library, tmp_path):
    table = rows({number: "thin_features" for number in range(10, 20)})
    table += [{"file": f"extra/e{number}.step", "category": category} for number, category in
              enumerate(["thin"] * 4 + ["normal"] * 2)]
    for number in range(6):
        store(library / "extra", f"e{number}.step", [filled(0.2)])
    learned = thinpart.learn(library, written(tmp_path / "three.csv", table), "paper")
    assert [step["category"] for step in learned.content["probability"]["steps"]] == ["thin", "thin_features"]


# What is written

def test_the_profile_is_written_under_its_own_name(library, labels, tmp_path):
    output = tmp_path / "house.json"
    learned = thinpart.learn(library, labels, FIRST, output=output)
    profile = load_profile(output)
    assert profile.content == learned.content and profile.name == "house"
    assert "labels of 32 parts by anna, starting at the profile first" in profile.source
    thinpart.learn(library, labels, FIRST, output=output)  # a profile may be learned anew


def test_nothing_else_is_overwritten(library, labels, tmp_path):
    first = tmp_path / "first.json"
    first.write_text(json.dumps(FIRST))
    other = tmp_path / "other.json"
    other.write_text("{}")
    for output, sentence in ((first, "is an input of this run"), (labels, "is an input of this run"),
                             (other, "is no profile"), (tmp_path / "paper.json", "comes with ThinPart")):
        before = output.read_bytes() if output.exists() else None
        with pytest.raises(ThinPartError, match=sentence):
            thinpart.learn(library, labels, first, output=output)
        assert (output.read_bytes() if output.exists() else None) == before
    with pytest.raises(ThinPartError, match="could not be written"):
        thinpart.learn(library, labels, first, output=tmp_path / "missing" / "new.json")


# The command

def test_the_command_says_what_was_learned(library, labels, tmp_path, capsys):
    first = tmp_path / "first.json"
    first.write_text(json.dumps(FIRST))
    arguments = ["learn", str(library), "--labels", str(labels), "--profile", str(first)]
    other = written(tmp_path / "bert.csv", rows({0: "normal"})[:3])
    assert main([*arguments, "--labels", str(other), "-o", str(tmp_path / "new.json")]) == 0
    out = capsys.readouterr().out
    assert "32 labelled parts: 16 thin, 16 normal; by anna, bert." in out
    assert "Two answers to the same part differ in 1 of 3, 33 % (6 to 79)." in out
    assert "anna: thin, bert: normal" in out and "V/VBB < 0.52" in out
    assert "23 of 31, 74 % (57 to 86)" in out
    assert load_profile(tmp_path / "new.json").name == "new"
    assert main([*arguments, "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["changes"] == [{"category": "thin", "criterion": "1", "before": "V/VBB < 0.3", "after": "V/VBB < 0.52"}]
    assert content["after"]["sure"]["total"] == 32


def test_the_command_refuses_in_one_sentence(library, tmp_path, capsys):
    few = written(tmp_path / "few.csv", rows()[:20])
    assert main(["learn", str(library), "--labels", str(few)]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_without_scikit_learn_the_package_is_named(library, labels, monkeypatch):
    monkeypatch.setitem(sys.modules, "sklearn.linear_model", None)
    with pytest.raises(ThinPartError, match="apt-get install python3-sklearn"):
        thinpart.learn(library, labels, FIRST)
