# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections of a part's page."""

from ... import __version__
from ...core.foreign_text import head_text
from ...core.record.thinnest_sentence import thinnest_kind, thinnest_sentence
from .html_elements import element
from .page_words import TIMES
from .part_figures import colour_scale, distribution, view_figure
from .table_elements import cell, heading, number_cell, number_heading, row, table

SHOWN_FACES = 12
"""Faces that are visible at first; the others are collapsed."""

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
"""A page of a part loads nothing and runs nothing."""


def part_document(words, page):
    """The whole page of a part: Element.

    Parameters
    ----------
    words : PageWords
    page : SimpleNamespace
        What `part_page` has gathered.
    """
    _ = words.text
    part = page.part
    head = words.head(_("{part} - wall thickness", part=head_text(part["label"])),
                      element("meta", http_equiv="Content-Security-Policy", content=_POLICY))
    where = [page.file]
    if part["name"] != part["label"]:
        where.append(f", {part['name']}")
    if part["instances"] > 1:
        where.append(_(", {count} times in the document", count=part["instances"]))
    header = element(
        "header", element("div", element("h1", part["label"]), element("p", where, class_="faint path")),
        element("p", element("a", _("All parts of this report"), href=page.overview), class_="noprint small"))
    sections = (_verdict, _key_figures, _warnings, _checks, _pictures, _evidence, _walls, _faces, _notes, _measurement)
    return element("html", head, element("body", header, element("main", *(make(words, page) for make in sections))),
                   lang=words.language.code)


def _verdict(words, page):
    part = page.part
    return element(
        "div", element("p", words.headline(part["category"], page.between), class_="headline"),
        element("p", words.why(page.reason, page.deciding), " ", words.how_sure(part, page.other, page.chances)),
        element("p", words.sentence(page.paper)) if page.paper else None,
        element("p", words.sentence(thinnest_sentence(part))),
        element("p", words.sentence(page.risk)),
        element("p", words.sentence(page.meaning), class_="faint") if page.meaning else None,
        class_=f"verdict {part['category']}")


def _key_figures(words, page):
    _, length = words.text, words.length
    part, measured = page.part, page.part["descriptors"]
    thickness, large = measured["thickness_mm"], words.language.large

    def figure(name, value, unit=None):
        return element("div", element("dt", name),
                       element("dd", value, [" ", element("small", unit)] if unit else None))

    return element(
        "dl",
        figure(_("Thinnest wall"), length.number(thickness["min"]),
               f"{length.symbol} {words.place(thinnest_kind(part))}".rstrip()),
        figure(_("Median wall"), length.number(thickness["median"]), length.symbol),
        figure(_("Error of a wall at most"), length.bound_number(thickness["error_bound"]), length.symbol),
        figure(_("Bounding box"), words.box(measured["box_mm"]), length.symbol),
        figure(_("Volume"), large(length.value(measured["volume_mm3"], 3)), f"{length.symbol}\u00b3"),
        figure(_("Surface"), large(length.value(measured["area_mm2"], 2)), f"{length.symbol}\u00b2"),
        figure(_("Share of its box, V/VBB"), words.number(measured["volume_ratio"])),
        class_="key")


def _warnings(words, page):
    _ = words.text
    warnings = page.part["warnings"]
    if not warnings:
        return None
    return _section(_("Warnings"), element("ul", [element("li", words.sentence(each)) for each in warnings],
                                           class_="warnings"))


def _checks(words, page):
    _, length = words.text, words.length
    if not page.checks:
        return None
    headings = [heading(_("Process")), number_heading(_("At least, {unit}", unit=length.symbol)),
                number_heading(_("At most, {unit}", unit=length.symbol)), heading(_("Passes")), heading(_("Result"))]
    rows = [row(heading(words.sentence(check["title"]), scope="row"), number_cell(length.number(check["min"])),
                number_cell(length.number(check["max"])), cell(words.holds(check["holds"]), class_="w"),
                cell(words.sentence(check["sentence"]), _faces_of_check(words, check["faces"]), element("br"),
                     element("span", words.sentence(check["note"]), " ", check["source"], class_="faint small path")))
            for check in page.checks]
    return _section(_("Limits of the wall"), table(_("Whether its walls lie within what processes allow"), headings, rows))


def _faces_of_check(words, faces):
    _ = words.text
    if not faces:
        return None
    named = ", ".join(faces[:12])
    said = _("Faces: {faces}.", faces=named) if len(faces) <= 12 else _(
        "Faces: {faces} and {count} more.", faces=named, count=len(faces) - 12)
    return [" ", element("span", said, class_="faint small")]


def _pictures(words, page):
    _, percent = words.text, words.percent
    limit, shares = page.part["thin_limit_mm"], page.part["descriptors"]["shares"]
    colours = {
        "local": _("Colours stand for the local thickness, the diameter of the largest ball inside that reaches the surface "
                   "there. Verdict, tables and the thinnest wall are measured straight across."),
        "sphere": _("Colours stand for the diameter of the largest ball inside that touches the surface there, which goes "
                    "down to nothing at sharp edges. Verdict, tables and the thinnest wall are measured straight "
                    "across.")}.get(page.shown)
    chart = element("figure", distribution(words, page.chart, limit), element("figcaption", _(
        "Share of the surface over walls of each thickness ({unit}). {unmeasured} of the surface has no wall opposite; "
        "{tapered} lies over tapered walls, which are not in the chart.", unit=words.length.symbol,
        unmeasured=percent(shares["unmeasured"]), tapered=percent(shares["nonparallel"]))), class_="chart")
    views = [view_figure(words, view, page.part["label"], page.thinnest, page.shown) for view in page.views]
    return element(
        "section", element("h2", _("Where it is thin")), element("div", views, chart, class_="figures"),
        element("p", colours) if colours else None,
        element("div", colour_scale(words, page.scale, limit), class_="scale") if page.scale else None)


def _evidence(words, page):
    _ = words.text
    headings = [heading(_("Quantity")), heading(_("Meaning")), number_heading(_("Measured")),
                number_heading(_("Threshold")), heading(_("Holds")), number_heading(_("Margin"))]
    caption = _("Every criterion of the profile “{profile}” with what was measured; the category is the first of which one "
                "criterion holds", profile=words.profile_title(page.profile))
    bodies = [element("tbody", _criterion(words, each), [_condition(words, one) for one in each["conditions"]])
              for each in page.evidence]
    return element("section", element("h2", _("Why it is in this category")), element(
        "details", element("summary", _("{count} criteria", count=len(page.evidence))), table(caption, headings, bodies)),
        class_="why")


def _criterion(words, each):
    name = heading(words.criterion(each), " ", element("span", f"({words.category_word(each['category'])})",
                                                       class_="faint small"), scope="rowgroup", colspan=4)
    return row(name, cell(words.holds(each["holds"]), class_="w"), number_cell(words.percent(each["margin"])),
               class_="criterion")


def _condition(words, each):
    _, number = words.text, words.number
    meaning = words.sentence(each["meaning"])
    if each["bounds"]:
        meaning += f" (a = {number(each['bounds'][0])}, b = {number(each['bounds'][1])})"
    if each["unit"]:
        meaning += f", {each['unit']}"
    return row(heading(each["symbol"], scope="row"), cell(meaning, class_="small"),
               number_cell(_("none") if each["is_absent"] else number(each["value"])),
               number_cell(f"{each['comparison']} {number(each['threshold'])}"),
               cell(words.holds(each["holds"]), class_="w"), number_cell(words.percent(each["margin"])))


def _walls(words, page):
    _, unit = words.text, words.length.symbol
    if not page.regions:
        return None
    headings = [
        heading(_("Wall")), number_heading(_("Least, {unit}", unit=unit)), number_heading(_("Median, {unit}", unit=unit)),
        number_heading(_("Length, {unit}", unit=unit)), number_heading(_("Developed width, {unit}", unit=unit)),
        number_heading(_("Share of the surface")), number_heading(_("Share of the volume")), heading(_("Faces"))]
    others = page.other_regions
    return _section(
        _("Its walls"),
        table(_("Connected walls of like thickness, equal ones in one row; the thinnest first"), headings,
              [_wall(words, group) for group in page.regions]),
        element("p", _("and {count} smaller walls, {share} of the surface", count=others["others"],
                       share=words.percent(others["others_share"])), class_="faint") if others["others"] else None)


def _wall(words, group):
    _, length = words.text, words.length
    name = [f"{group.count} {TIMES} " if group.count > 1 else None]
    if group.excluded:
        name += [element("s", words.wall(group.word)), " ",
                 element("span", _("excluded: {reason}", reason=group.excluded), class_="small")]
    else:
        name.append(words.wall(group.word))
    if group.mesh_size:
        name += [" ", element("span", _("element size {size}", size=length.text(group.mesh_size)), class_="small")]
    faces = ", ".join(f"Face{face + 1}" for face in group.faces[:8])
    if len(group.faces) > 8:
        faces += f" {_('and {count} more', count=len(group.faces) - 8)}"
    sizes = (group.least, group.median, group.length, group.width)
    return row(heading(name, scope="row"), *(number_cell(length.number(each)) for each in sizes),
               number_cell(words.percent(group.area_share)), number_cell(words.percent(group.volume_share)),
               cell(faces, class_="small"))


def _faces(words, page):
    _ = words.text
    first, further = page.faces[:SHOWN_FACES], page.faces[SHOWN_FACES:]
    limit, width = page.part["thin_limit_mm"], page.part["descriptors"]["box_mm"][1]
    caption = _("The thinnest first; thin is what lies over less than {limit}, {part} of the width, as the verdict has it, "
                "beside edges of up to 60 degrees too, which are no walls", limit=words.length.text(limit),
                part=words.percent(limit / width))
    return element(
        "section", element("h2", _("Its faces")), _face_table(words, page.features, first, caption, "first"),
        element("details", element("summary", _("{count} more faces", count=len(further))),
                _face_table(words, page.features, further, _("Further faces; all of them are in faces.csv as well"),
                            "further")) if further else None)


def _face_table(words, features, faces, caption, kind):
    _, length, percent = words.text, words.length, words.percent
    unit = length.symbol
    headings = [
        heading(_("Face")), heading(_("Made by")) if features else None,
        number_heading(_("Area, {unit}", unit=f"{unit}\u00b2")), number_heading(_("Thinnest, {unit}", unit=unit)),
        number_heading(_("Median, {unit}", unit=unit)), number_heading(_("Thin share")), number_heading(_("Unmeasured")),
        heading(_("Thinnest towards"))]
    rows = [row(
        heading(face["face"], scope="row"), cell(face["feature"]) if features else None,
        number_cell(words.number(length.value(face["area_mm2"], 2))), number_cell(length.number(face["min"])),
        number_cell(length.number(face["median"])),
        cell(percent(face["thin_share"]), class_="n share", style=f"--share: {100 * face['thin_share']:.1f}%"),
        number_cell(percent(face["unmeasured_share"])),
        cell(face["witness"]["opposite_face"] if face["witness"] else "")) for face in faces]
    return table(caption, headings, rows, class_=kind)


def _notes(words, page):
    _, kept = words.text, page.kept
    if not (kept["notes"] or kept["mesh"] or kept["link"] or kept["labels"]):
        return None
    labels = "; ".join(f"{words.category(each['category'])} - {each['person']}"
                       f"{'' if each['sure'] else _(', not sure')} ({each['when'][:10]})" for each in kept["labels"])
    return _section(
        _("Notes"),
        element("p", kept["notes"], style="white-space: pre-line") if kept["notes"] else None,
        element("p", _("Labels:"), " ", labels) if labels else None,
        element("p", _("See"), " ", element("span", kept["link"], class_="path")) if kept["link"] else None,
        [element("p", _("Mesh settings"), class_="faint"), element("pre", kept["mesh"])] if kept["mesh"] else None)


def _measurement(words, page):
    _, length, number = words.text, words.length, words.number
    part, source, settings, profile = page.part, page.source, page.settings, page.profile
    is_saved = bool(source.get("sha256"))
    diagonal = length.text(part["descriptors"]["diagonal_mm"])
    changed = _("{bytes} bytes, changed {time} UTC", bytes=source["bytes"], time=source["modified"][:19].replace(
        "T", " ")) if is_saved else _("as it was open in FreeCAD, not saved")
    mesh = _("{triangles} triangles, chord error {error}, {samples} samples", triangles=part["triangles"],
             error=length.bound_text(part["deflection_mm"]), samples=part["samples"])
    if not part["descriptors"]["watertight"]:
        mesh += _(", not watertight")
    title = [words.profile_title(profile)]
    if profile.get("source"):
        title += [element("br"), element("span", words.sentence(profile["source"]), class_="faint small")]
    by_paper = part["paper"]["category"]
    facts = [
        (_("Document"), f"{source['file']}, {changed}", "path"),
        ("SHA-256", source["sha256"], "path small") if is_saved else None,
        *((_("Takes shapes from"), link["file"], "path") for link in source.get("links", ())),
        (_("Thickness by"), _("the first wall along the inward normal") if settings["measure"] == "rays" else
         _("the paper's pair rule"), None),
        (_("Bounding box"), _("of least volume; diagonal {diagonal}", diagonal=diagonal) if settings["box"] == "minimal"
         else _("along the principal axes; diagonal {diagonal}", diagonal=diagonal), None),
        (_("Surface mesh"), mesh, None),
        (_("Settings"), _(
            "linear deflection {linear}, angular deflection {angular} degrees, at walls {wall}, at least {samples} samples, "
            "accuracy {accuracy}", linear=number(settings["linear_deflection"]),
            angular=number(settings["angular_deflection"]), wall=number(settings["wall_deflection"]),
            samples=settings["minimum_samples"], accuracy=words.accuracy(settings["accuracy"])), None),
        (_("Profile"), title, None),
        (_("By the paper’s thresholds"), words.category(by_paper), None) if by_paper != part["category"] else None,
        (_("Software"), f"ThinPart {__version__}", None)]
    rows = [row(heading(name, scope="row"), cell(value, class_=kind)) for name, value, kind in filter(None, facts)]
    return _section(_("How it was measured"), element("table", element("tbody", rows), class_="facts"))


def _section(title, *content):
    return element("section", element("h2", title), *content, class_="whole")
