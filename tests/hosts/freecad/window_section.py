"""Runs inside FreeCAD's window: the section plane, its cut faces and its handle."""

import math
import pathlib

import FreeCAD
import FreeCADGui
import numpy as np
import pointer
import pytest
import window
from panels import Button, document, edit, frep, panels, shown
from simulating import opened, simulated
from window import live, press, wait

from fieldfab_workbench import files, registry
from fieldfab_workbench.commands.exchange import COMMANDS
from fieldfab_workbench.objects import scan
from fieldfab_workbench.shim import QtCore
from fieldfab_workbench.views import section
from fieldfab_workbench.views.part_view import PartView

HOLLOW = "difference(box(20, 20, 20), sphere(r = 6))"
CT = pathlib.Path(__file__).resolve().parents[2] / "data" / "ct"


@pytest.fixture(autouse=True)
def whole_again(document):
    yield
    if section.section_of(document):
        section.toggle(document)


def cut(document):
    """Adds a section plane by the command."""
    assert COMMANDS["Fieldfab_Section"].IsActive()
    FreeCADGui.runCommand("Fieldfab_Section")
    live(0.3)
    return section.section_of(document)


def in_the_colour(pixels):
    return (np.abs(pixels - 255 * np.array(section.CAP_COLOUR)) < 12).all(axis=-1)


def cap(document, name, is_cut=in_the_colour):
    """Returns a mask of the view's pixels in the colour of cut faces."""
    return is_cut(window.view_pixels(name, PartView(document)))


def background_of(picture):
    """Returns the colour beside the solid."""
    return picture.pixelColor(picture.width() - 250, 300).getRgb()


def share(pixels):
    """Returns the fraction of their bounding box that the pixels fill."""
    rows, columns = np.nonzero(pixels)
    return len(rows) / ((np.ptp(rows) + 1) * (np.ptp(columns) + 1))


def drag_handle(document, by):
    """Drags the handle with the mouse by `by` mm along the normal."""
    plane, view = section.section_of(document), PartView(document)
    places = (plane.middle + plane.normal * (plane.offset + way) for way in (0, by))
    pointer.drag(view.widget(), *(pointer.point_of(view, place) for place in places))
    live(0.3)


def test_a_cut_face_has_the_size_of_the_solid_there(document):
    solid = frep(document, HOLLOW, 0.5)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    own = solid.ViewObject.RootNode.getNumChildren()
    children = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren()
    assert cap(document, "section_before").sum() == 0
    plane = cut(document)
    assert tuple(plane.normal) == (0, -1, 0)
    seen = cap(document, "section_front")
    frame_and_handle = 0.03
    assert share(seen) == pytest.approx(1 - math.pi * 36 / 400, abs=frame_and_handle)
    cut(document)
    assert cap(document, "section_after").sum() == 0 and section.section_of(document) is None
    assert FreeCADGui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren() == children
    assert solid.ViewObject.RootNode.getNumChildren() == own


def test_the_handle_moves_the_plane(document):
    frep(document, HOLLOW, 0.5)
    background = background_of(window.shot("section_uncut"))
    plane = cut(document)
    first = cap(document, "section_middle").sum()
    drag_handle(document, -5)
    assert plane.offset == pytest.approx(-5, abs=1)
    moved = cap(document, "section_moved").sum()
    assert moved > 1.1 * first, "less of the ball is cut"
    assert background_of(window.shot("section_background")) == background, "the plane cuts the solids alone"


def test_what_a_panel_shows_is_cut(document, panels):
    solid = frep(document, "box(20, 20, 20)", 0.5)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    cut(document)
    edit(solid)
    full = cap(document, "section_box").sum()
    panels[-1].text.setPlainText(HOLLOW)
    shown(panels[-1].preview, "final", "detail", "divided")
    assert cap(document, "section_preview").sum() == pytest.approx(full * (1 - math.pi * 36 / 400), rel=0.05)
    press(Button.Cancel)


def test_a_scan_is_cut_while_its_panel_is_open(document, panels):
    files.insert(str(CT / "engine.nii.gz"), document.Name)
    panel = panels[-1]
    wait(lambda: panel.overview is not None and panel.work.idle(), what="the overview")
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    cut(document)
    # Orange; the axes at FreeCAD's cube are red.
    seen = cap(document, "section_scan", lambda c: (c[..., 0] > c[..., 2] + 50) & (c[..., 1] > c[..., 2] + 20))
    assert seen.sum() > 2000 and 0.05 < share(seen) < 0.9, "walls, not the whole block"
    press(Button.Cancel)


def test_the_stock_of_a_simulation_is_cut(document, opened, tmp_path):
    simulated(document, opened, tmp_path)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    assert cap(document, "section_stock_before").sum() == 0
    plane = cut(document)
    seen = cap(document, "section_stock")
    assert seen.sum() > 2000 and share(seen) < 0.95, "a pocket is in it"
    assert plane._wanted() == list(plane._solids.getChildren())
    press(Button.Cancel)


def test_a_closed_document_takes_its_section_along(document):
    other = FreeCAD.newDocument("Other")
    frep(other, HOLLOW, 1)
    first = cut(other)
    FreeCAD.closeDocument(other.Name)
    live(0.5)
    assert not first._timer.isActive()
    again = FreeCAD.newDocument("Other")
    solid = frep(again, HOLLOW, 1)
    own = solid.ViewObject.RootNode.getNumChildren()
    live(0.5)
    assert section.section_of(again) is None and solid.ViewObject.RootNode.getNumChildren() == own
    FreeCAD.closeDocument(again.Name)
    FreeCAD.setActiveDocument(document.Name)


def test_nothing_to_cut_is_told(document):
    with pytest.raises(ValueError, match="no solid to cut"):
        section.toggle(document)
    assert section.section_of(document) is None and FreeCAD.ActiveDocument == document


def click_at(document, place):
    """Clicks on a place in the 3D view. Returns what the status bar says then."""
    view = PartView(document)
    pointer.click(view.widget(), pointer.point_of(view, place))
    live(0.3)
    return FreeCADGui.getMainWindow().statusBar().currentMessage()


def test_thickness_and_distance_are_measured(document):
    """A box of 20 mm with a ball of 6 mm radius within: walls of 4 mm, a gap of 12 mm."""
    frep(document, HOLLOW, 0.25)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.runCommand("Fieldfab_MeasureSection")
    live(0.3)
    plane = section.section_of(document)
    assert plane is not None and plane.measure is not None
    said = click_at(document, (8, 0, 0.4))
    assert float(said.split()[0].replace(",", ".")) == pytest.approx(4, abs=0.02) and "thick" in said
    said = click_at(document, (-1, 0, 1))
    assert float(said.split()[0].replace(",", ".")) == pytest.approx(12, abs=0.05) and "wide" in said
    assert "from the last point" in said
    window.shot("section_measure")
    click_at(document, (-10, 0, 0))
    said = click_at(document, (10, 0, 0))
    assert "20" in said.split("; ")[1].split()[0], "both clicks are on the outline"
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    live(0.3)
    drag_handle(document, -7)
    assert plane.offset == pytest.approx(-7, abs=1)
    said = click_at(document, (8, plane.at.y, 0.4))
    assert float(said.split()[0].replace(",", ".")) == pytest.approx(20, abs=0.1), "the ball is not cut there"
    FreeCADGui.runCommand("Fieldfab_MeasureSection")
    assert plane.measure is None and section.section_of(document) is plane
    cut(document)


def test_the_densities_of_a_scan_are_on_the_plane(document, tmp_path):
    """A ball of 8 mm: orange within, grey outside, in its place also after the scan was moved."""
    import fieldfab as ff

    at = np.indices((24, 28, 32)).transpose(1, 2, 3, 0) - (11.5, 13.5, 15.5)
    ff.Volume(np.clip(100 + 40 * (8 - np.sqrt((at**2).sum(axis=-1))), 0, 200).astype(np.float32),
              origin=(-15.5, -13.5, -11.5)).save(tmp_path / "ball.nii")
    ball = document.addObject("Mesh::FeaturePython", "Ball")
    scan.Scan(ball)
    registry.add_view(ball)
    ball.File = str(tmp_path / "ball.nii")
    ball.Placement.Base = FreeCAD.Vector(3, 0, 0)
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    plane = cut(document)
    wait(lambda: plane._slices.root.getChild(2).getNumChildren() == 1, "the picture of densities")
    live(0.3)
    picture, view = window.shot("section_densities"), PartView(document)
    corner = view.widget().mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0))
    scale = view.view.getSize()[0] / view.widget().width()

    def colour(x, z):
        u, v = view.pixel_of((x, 0, z))
        c = picture.pixelColor(round(corner.x() * scale + u), round((corner.y() + view.widget().height()) * scale - v))
        return c.red(), c.green(), c.blue()

    for x, z, solid in ((3 + 5, 3, True), (3 - 5, -3, True), (3 + 11, 6, False), (3 - 12, -8, False)):
        red, green, blue = colour(x, z)
        assert (red > blue + 60) if solid else (abs(red - blue) < 12), (x, z, red, green, blue)
    ball.AutoThreshold, ball.Threshold = False, 180
    wait(lambda: plane._slices.shown[2][0][2] == 180, "the new threshold's picture")
    live(0.3)
    picture = window.shot("section_densities_180")
    red, green, blue = colour(3 + 7, 3)
    assert abs(red - blue) < 12, "at 7 mm the density is 140"
