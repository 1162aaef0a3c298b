# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD document that is saved without a window: completed, and the same each time."""

import itertools
import re
import uuid
import zipfile

from FreeCAD import Vector

_DATE = r'"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d[^"]*"'
_UNSEEN = ("App::Origin", "App::Line", "App::Plane", "App::Point")


def view_of(document, bounds):
    """What a FreeCAD without windows does not write, as XML text.

    Without it everything is hidden when the document is opened. It says which objects are shown, and
    lets the view start with the whole part, seen from the isometric direction.

    Parameters
    ----------
    document : FreeCAD.Document
    bounds : FreeCAD.BoundBox
        Of all that is shown.
    """
    shown = [each for each in document.Objects if not each.TypeId.startswith(_UNSEEN)]
    lines = [
        "<?xml version='1.0' encoding='utf-8'?>",
        '<Document SchemaVersion="1">',
        f'  <ViewProviderData Count="{len(shown)}">',
    ]
    for each in shown:
        lines += [
            f'    <ViewProvider name="{each.Name}" expanded="0">',
            '      <Properties Count="1" TransientCount="0">',
            '        <Property name="Visibility" type="App::PropertyBool">',
            f'          <Bool value="{"true" if each.Visibility else "false"}"/>',
            "        </Property>",
            "      </Properties>",
            "    </ViewProvider>",
        ]
    lines += [
        "  </ViewProviderData>",
        f'  <Camera settings="{"&#10;".join(_camera(bounds))}"/>',
        "</Document>",
    ]
    return "\n".join(lines) + "\n"


def _camera(bounds):
    size = bounds.DiagonalLength
    eye = bounds.Center + Vector(1, -1, 1).normalize() * (size / 2)
    return [
        "OrthographicCamera {",
        "  viewportMapping ADJUST_CAMERA",
        "  position {:.6g} {:.6g} {:.6g}".format(*eye),
        "  orientation 0.74290609 0.30772209 0.59447283 1.2171158",
        "  nearDistance 0",
        f"  farDistance {size:.6g}",
        "  aspectRatio 1",
        f"  focalDistance {size / 2:.6g}",
        f"  height {size:.6g}",
        "}",
    ]


def finish_document(saved, path, name, view):
    """Write the document `saved` to `path`, completed and made reproducible.

    Dates, random identifiers and the objects' random numbers become fixed ones, and all is compressed
    as far as possible.

    Parameters
    ----------
    saved, path : str
    name : str
        Of the sample.
    view : str
        From `view_of`.
    """
    with zipfile.ZipFile(saved) as archive:
        members = {info.filename: archive.read(info) for info in archive.infolist()}
    text = _without_chance(members["Document.xml"].decode("utf-8"), name)
    members["Document.xml"] = text.encode("utf-8")
    members["GuiDocument.xml"] = view.encode("utf-8")

    with zipfile.ZipFile(path, "w") as archive:
        for filename, content in members.items():
            info = zipfile.ZipInfo(filename)  # dated 1980, for want of a date
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, content, compresslevel=9)


def _without_chance(text, name):
    numbers = itertools.count(1)

    def identifier(_match):
        fixed = uuid.uuid5(uuid.NAMESPACE_OID, f"ThinPart sample {name} {next(numbers)}")
        return f'<Uuid value="{fixed}"'

    text = re.sub(_DATE, '"2000-01-01T00:00:00Z"', text)
    text = re.sub(r'<Uuid value="[^"]*"', identifier, text)
    if "ElementMap" in text:  # in which FreeCAD 1.0 refers to the objects' numbers
        return text
    return re.sub(r'(<Object type="[^"]*" name="[^"]*" id=)"\d+"',
                  lambda match: f'{match.group(1)}"{next(numbers)}"', text)
