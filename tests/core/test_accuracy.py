# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracies, the precision of a measurement, and the errors that follow from it."""

from dataclasses import replace

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import ACCURACIES, STANDARD, AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import STATED_FLOOR, quantity_named
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import profile_from
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measured_precision import precision_of
from thinpart_workbench.core.thickness.measurement import measure


def test_the_defaults_are_those_of_the_standard_accuracy():
    assert AnalysisSettings() == AnalysisSettings.at(STANDARD)
    assert AnalysisSettings.at("fine", linear_deflection=0.003).linear_deflection == 0.003


def test_each_accuracy_is_finer_than_the_one_before_and_the_last_one_ends():
    settings, seen = AnalysisSettings.at("verdict"), []
    while settings is not None:
        seen.append(settings)
        settings = settings.finer
    assert [each.accuracy for each in seen] == list(ACCURACIES)
    for coarse, fine in zip(seen, seen[1:]):
        assert fine.linear_deflection < coarse.linear_deflection and fine.minimum_samples > coarse.minimum_samples
        assert fine.angular_deflection <= coarse.angular_deflection
    # What the user asked for is never made coarser.
    assert AnalysisSettings(angular_deflection=2.0, minimum_samples=10**6).finer.angular_deflection == 2.0
    assert AnalysisSettings(minimum_samples=10**6).finer.minimum_samples == 10**6


@pytest.mark.parametrize("accuracy", ["", "Fine", "exact", "0.1"])
def test_an_absurd_accuracy_is_refused_with_what_there_is(accuracy):
    with pytest.raises(ThinPartError, match="use verdict, standard, fine") as refused:
        AnalysisSettings.at(accuracy)
    assert refused.value.kind == "usage"


def with_precision(shape, samples=AnalysisSettings.minimum_samples, chord=0.01):
    mesh = surface_mesh(*shape)
    measurement = measure(mesh, AnalysisSettings(minimum_samples=samples))
    precision = precision_of(measurement, np.array([chord]), STANDARD)
    return replace(measurement.descriptors, precision=precision)


RIBBED = made_meshes.ribbed_block()


def error(symbol, descriptors):
    return quantity_named(symbol).error(descriptors, STATED_FLOOR)


def test_more_samples_make_errors_of_shares_smaller_and_they_hold():
    truth = with_precision(RIBBED, 400_000)
    few, many = with_precision(RIBBED, 3000), with_precision(RIBBED, 48_000)
    for symbol in ("F[0;0.05]", "F[0.05;0.29]", "K[0;0.12]", "parallel"):
        assert error(symbol, many) < error(symbol, few)
        for measured in (few, many):
            assert abs(measured.value(symbol) - truth.value(symbol)) <= error(symbol, measured)


def test_walls_as_thick_as_a_bound_count_as_uncertain():
    # Nothing is known about where within its bin, 0.05 to 0.06 D2, the wall of the plate is.
    plate = made_meshes.box(200, 100, 5.5)
    near, far = with_precision(plate, chord=1.0), with_precision(plate, chord=0.001)
    assert error("K[0;0.05]", near) > 0.3 and error("K[0;0.05]", far) < 0.05
    assert error("K[0;0.1]", near) < 0.05


def test_an_unmeasured_quantity_and_one_of_an_earlier_version_have_no_error():
    assert error("min_nonparallel[10;55]", with_precision(made_meshes.box(30, 20, 10))) is None
    assert error("V/VBB", measure(surface_mesh(*RIBBED), AnalysisSettings()).descriptors) is None
    assert error("regions", with_precision(RIBBED)) is None


def test_what_the_search_for_slanted_walls_leaves_open_is_in_their_error():
    known = with_precision(made_meshes.prism([(0, 0), (100, 0), (100, 10), (0, 60)], 50))
    known, open_ended = (replace(known, precision=replace(known.precision, slanted=slanted)) for slanted in (0.0, 0.02))
    assert error("min_nonparallel[10;55]", known) < 0.005
    assert 0.02 <= error("min_nonparallel[10;55]", open_ended) < 0.025
    # Other angles are read off the samples, which no search changes.
    assert error("min_nonparallel[10;30]", open_ended) == error("min_nonparallel[10;30]", known) is not None
    more = open_ended.precision.at(36_000)
    assert more.slanted == pytest.approx(0.02 * (36_000 / open_ended.precision.samples) ** -0.6)


def judged_at(threshold, descriptors):
    return classify(descriptors, profile_from({
        "format": "thinpart-profile", "version": 1, "name": "one", "categories": [
            {"name": "thin", "criteria": [{"id": 1, "conditions": [
                {"quantity": "F[0;0.05]", "comparison": ">", "value": threshold}]}]}]}))


def test_a_verdict_is_certain_where_no_error_can_turn_it():
    known = with_precision(RIBBED, 3000)
    value, off = known.value("F[0;0.05]"), error("F[0;0.05]", known)
    assert 0.0 < off < 0.05 < value
    assert judged_at(value - 2.0 * off, known).is_certain and judged_at(value + 2.0 * off, known).is_certain
    assert not judged_at(value - 0.5 * off, known).is_certain and not judged_at(value + 0.5 * off, known).is_certain
