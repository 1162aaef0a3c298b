"""What the page of a part says about its faces."""

from thinpart_workbench.workflow.part_page import _faces


def test_a_face_without_triangles_shifts_no_feature():
    record = {"faces": [{"face": "Face1", "min": 3.0}, {"face": "Face3", "min": 2.0}, {"face": "Face4", "min": None}]}
    found = [(face["face"], face["feature"]) for face in _faces(record, ["Pad", "Sliver", "Pocket"])]
    assert found == [("Face3", "Pocket"), ("Face1", "Pad"), ("Face4", "")]
