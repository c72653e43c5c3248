"""Runs inside FreeCAD's window: lines along sharp edges, and light by which the faces of a box differ."""

import FreeCAD
import FreeCADGui
import numpy as np
import window
from panels import document, frep
from window import live

from fieldfab_workbench import meshes
from fieldfab_workbench.views import look
from fieldfab_workbench.views.part_view import PartView


def seen(document, name):
    """Returns the pixels of the 3D view, seen isometrically."""
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(0.5)
    return window.view_pixels(name, PartView(document))


def dark(pixels):
    return int((pixels.max(axis=-1) < 60).sum())


def test_a_box_is_no_hexagon(document):
    frep(document, "box(30, 30, 30)")
    pixels = seen(document, "look_box").reshape(-1, 3)
    colours, count = np.unique(pixels, axis=0, return_counts=True)
    blues = [tuple(colour) for colour, n in zip(colours, count) if n > 10000 and colour[1] > colour[0] + 15]
    assert len(blues) == 3 and all(
        max(abs(a - b) for a, b in zip(one, other)) >= 15 for one in blues for other in blues if one != other), blues


def test_lines_follow_the_switch_the_solid_and_what_is_shown(document):
    solid = frep(document, "difference(box(40, 30, 20), cylinder(r = 8, h = 40))")
    view = solid.ViewObject
    with_lines = dark(seen(document, "look_edges"))
    view.SharpEdges = False
    without = dark(seen(document, "look_no_edges"))
    assert with_lines > without + 800
    view.SharpEdges = True
    assert abs(dark(seen(document, "look_edges_again")) - with_lines) < 20
    view.Visibility = False
    assert dark(seen(document, "look_hidden")) <= without
    view.Visibility = True
    solid.Expression = "sphere(r = 15)"
    document.recompute()
    ball = dark(seen(document, "look_sphere"))
    view.SharpEdges = False
    assert abs(dark(seen(document, "look_sphere_again")) - ball) < 30, "a ball has no edges"


def test_lines_move_with_the_solid_and_stay_after_reopening(document, tmp_path):
    solid = frep(document, "box(30, 30, 30)")
    before = dark(seen(document, "look_here"))
    solid.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation())
    document.recompute()
    assert abs(dark(seen(document, "look_there")) - before) < 0.1 * before
    document.saveAs(str(tmp_path / "box.FCStd"))
    other = FreeCAD.openDocument(str(tmp_path / "box.FCStd")) if FreeCAD.closeDocument(document.Name) is None else None
    assert abs(dark(seen(other, "look_reopened")) - before) < 0.1 * before
    FreeCAD.closeDocument(other.Name)


def test_the_edges_of_a_mesh_are_those_of_a_slow_search(document):
    mesh = frep(document, "difference(box(40, 30, 20), cylinder(r = 8, h = 40))").Mesh
    points, pairs = look.sharp_edges(meshes.bms_of(mesh))
    facets, edges = mesh.Facets, {}

    def is_thin(facet):
        longest = max((FreeCAD.Vector(*a) - FreeCAD.Vector(*b)).Length for a in facet.Points for b in facet.Points)
        return 2 * facet.Area < look.THIN * longest**2

    def sum_around(facet, rounds):
        if not rounds or not is_thin(facet):
            return facet.Normal * facet.Area
        total = sum_around(facet, rounds - 1)
        for other in facet.NeighbourIndices:
            total += sum_around(facets[other], rounds - 1)
        return total

    def normal(facet):
        return sum_around(facet, 2).normalize()

    for facet in facets:
        corners = facet.PointIndices
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edges.setdefault(frozenset((a, b)), []).append(facet)
    slow = {edge for edge, (one, other) in edges.items() if normal(one).dot(normal(other)) < look.inventor.CREASE}
    assert {frozenset(pair) for pair in pairs.tolist()} == slow and len(slow) > 50
    inner = points[[i for i in pairs.ravel() if np.hypot(*points[i][:2]) < 8.1]]
    assert len(inner) > 50 and (np.abs(np.abs(inner[:, 2]) - 10) > 1e-3).mean() < 0.02, "hardly a line on the wall"


def test_lines_that_hardly_hang_together_are_left_out():
    rng = np.random.default_rng(1)
    pairs = np.unique(np.sort(rng.integers(0, 400, (300, 2)), axis=1), axis=0)
    group = {vertex: {vertex} for vertex in pairs.ravel().tolist()}
    for a, b in pairs.tolist():
        whole = group[a] | group[b]
        for vertex in whole:
            group[vertex] = whole
    slow = [pair for pair in pairs.tolist() if sum(a in group[pair[0]] for a, b in pairs.tolist()) >= look.FEWEST]
    assert look.without_specks(pairs).tolist() == slow and 0 < len(slow) < len(pairs)
