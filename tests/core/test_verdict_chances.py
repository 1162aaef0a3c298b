# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between which categories a verdict leaves a part."""

from thinpart_workbench.core.record.verdict_chances import open_between, verdict_chances


def record(borderline, **chances):
    return {"category": "normal", "margin": 0.1, "borderline": borderline,
            "probabilities": [{"category": name, "probability": chance} for name, chance in chances.items()]}


def test_the_verdict_and_the_likeliest_other_one():
    found = verdict_chances(record(False, thin=0.1, thin_features=0.3, normal=0.6))
    assert found == (0.6, "thin_features", 0.3)


def test_an_unsure_verdict_is_one_of_two_and_the_likelier_is_named_first():
    # As a spring of round wire: the verdict itself is the least probable of the three.
    assert open_between(record(True, thin=0.86, thin_features=0.08, normal=0.06)) == [("thin", 0.86), ("normal", 0.06)]
    assert open_between(record(True, thin=0.1, thin_features=0.4, normal=0.5)) == [("normal", 0.5), ("thin_features", 0.4)]


def test_a_sure_one_and_one_without_probabilities_is_open_between_none():
    assert open_between(record(False, thin=0.1, thin_features=0.3, normal=0.6)) is None
    assert open_between({"category": "normal", "margin": 0.01, "borderline": True}) is None
    assert verdict_chances({"category": "unknown", "margin": None, "borderline": False, "probabilities": []}) is None
