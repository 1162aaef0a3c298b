# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that do harm when FreeCAD opens them, made from one that does none."""

import zipfile

PROPERTY = '<Property name="{}" type="{}">{}</Property>'


def harmless(freecad, path):
    """Save a document with a block, an empty VRML object and a Python object."""
    document = freecad.newDocument("Harmless")
    try:
        document.addObject("Part::Box", "Block")
        document.addObject("App::VRMLObject", "Picture")
        document.addObject("App::FeaturePython", "Helper")
        document.recompute()
        document.saveAs(str(path))
    finally:
        freecad.closeDocument(document.Name)
    return path


def changed(path, into, replace=None, entries=(), files=None):
    """Write a document anew with other XML and more entries.

    Parameters
    ----------
    path, into : Path
    replace : callable, optional
        From the text of Document.xml to another one.
    entries : list of (str, bytes)
        Added at the end, whatever they are called.
    files : callable, optional
        From a name to the one that an entry gets.
    """
    with zipfile.ZipFile(path) as archive:
        content = [(name, archive.read(name)) for name in archive.namelist()]
    with zipfile.ZipFile(into, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in content:
            if name == "Document.xml" and replace is not None:
                data = replace(data.decode()).encode()
            archive.writestr(name, data)
        for name, data in entries:
            archive.writestr(zipfile.ZipInfo(name), data)
    return into


def with_resource(stored):
    """XML in which the VRML object has a resource of that name."""
    def replace(text):
        start = text.index('<Property name="Resources"')
        end = text.index("</Property>", start)
        return (text[:start] + '<Property name="Resources" type="App::PropertyStringList"><StringList count="1">'
                f'<String value="{stored}"/></StringList>' + text[end:])

    return replace


def with_module(module, of="C"):
    """XML in which the Python object's proxy is of a module."""
    def replace(text):
        place = text.index('<Object name="Helper">', text.index("<ObjectData"))
        start = text.index('<Property name="Proxy"', place)
        end = text.index("</Property>", start)
        return (text[:start] + '<Property name="Proxy" type="App::PropertyPythonObject">'
                f'<Python value="e30=" encoded="yes" module="{module}" class="{of}"/>' + text[end:])

    return replace
