"""Runs inside freecadcmd: solids as Part shapes, and FreeCAD's generic operations on objects."""

import math

import FreeCAD
import Part
import pytest

from fieldfab_workbench.objects import frep_solid, part_shape
from fieldfab_workbench.objects import solid as solids


def shaped(document, text, voxel=0.5, at=(0, 0, 0), turn=0, most=2000, curved=True):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    solid.Placement = FreeCAD.Placement(FreeCAD.Vector(*at), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), turn))
    shape = part_shape.create(document, solid)
    shape.MostTriangles, shape.Curved = most, curved
    document.recompute()
    assert shape.isValid(), shape.getStatusString()
    assert shape.Shape.isValid() and shape.Shape.Solids
    return solid, shape


def test_flat_faces_are_merged_and_measures_are_exact(document):
    solid, shape = shaped(document, "box(20, 10, 5)", at=(7, 0, 0), turn=30)
    assert (len(shape.Shape.Faces) == shape.Faces == 6 and shape.Shape.Volume == pytest.approx(1000)
            and shape.Shape.Area == pytest.approx(700))
    assert shape.Shape.CenterOfMass.distanceToPoint(FreeCAD.Vector(7, 0, 0)) < 1e-6 and len(shape.Shape.Edges) == 12
    assert max(edge.Length for edge in shape.Shape.Edges) == pytest.approx(20)
    assert shape.Shape.distToShape(Part.Vertex(7, 0, 20))[0] == pytest.approx(17.5)


def test_curved_solids_keep_their_volume_as_flat_faces(document):
    solid, shape = shaped(document, "sphere(r = 10)", most=1500, curved=False)
    assert solid.Triangles > 3000 and shape.Faces < 2250
    assert shape.Shape.Volume == pytest.approx(4 / 3 * math.pi * 1000, rel=0.01)
    assert shape.VolumeChange == pytest.approx(100 * (shape.Shape.Volume / solid.Volume.Value - 1), abs=0.01)


def test_it_follows_the_solid(document):
    solid, shape = shaped(document, "size = 10\nbox(size, size, size)")
    made = shape.MadeFrom
    solid.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    assert shape.MadeFrom == made and shape.Shape.CenterOfMass.x == pytest.approx(100)
    solid.size = 12
    document.recompute()
    assert shape.MadeFrom != made and shape.Shape.Volume == pytest.approx(1728)
    solid.Expression = "nonsense("
    document.recompute()
    assert not solid.isValid() and shape.Shape.Volume == pytest.approx(1728), "it keeps its shape"
    document.openTransaction("smaller")
    solid.Expression = "box(2, 2, 2)"
    document.recompute()
    document.commitTransaction()
    assert shape.Shape.Volume == pytest.approx(8)
    document.undo()
    assert shape.Shape.Volume == pytest.approx(1728) and solid.Mesh.Volume == pytest.approx(1728)


def test_part_cuts_and_sections_it(document):
    _, shape = shaped(document, "box(20, 20, 20)")
    box = document.addObject("Part::Box", "Box")
    box.Length = box.Width = box.Height = 10
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = shape, box
    section = document.addObject("Part::Section", "Section")
    section.Base, section.Tool = shape, document.addObject("Part::Plane", "Plane")
    section.Tool.Length = section.Tool.Width = 100
    section.Tool.Placement.Base = FreeCAD.Vector(-50, -50, 3)
    document.recompute()
    assert cut.Shape.Volume == pytest.approx(7000) and cut.Shape.isValid()
    assert sum(edge.Length for edge in section.Shape.Edges) == pytest.approx(80)
    assert sum(wire.Length for wire in shape.Shape.slice(FreeCAD.Vector(0, 0, 1), 1)) == pytest.approx(80)


def test_pieces_and_cavities(document):
    _, shape = shaped(document, "union(box(4, 4, 4), move(box(4, 4, 4), 20, 0, 0))")
    assert len(shape.Shape.Solids) == 2 and shape.Shape.Volume == pytest.approx(128)
    _, shape = shaped(document, "difference(box(10, 10, 10), box(4, 4, 4))")
    assert len(shape.Shape.Solids) == 1 and shape.Shape.Volume == pytest.approx(936)


def test_limits_are_told(document):
    solid, shape = shaped(document, "sphere(r = 10)")
    kept = shape.Shape.Volume
    shape.Source = None
    document.recompute()
    assert (not shape.isValid() and "choose a solid" in shape.getStatusString()
            and shape.Shape.Volume == pytest.approx(kept))
    with pytest.raises(ValueError, match="MostTriangles"):
        part_shape.shape_of(_Stubborn(solid.Mesh.copy()), 100, True, "Ball")


class _Stubborn:
    """A mesh that cannot be reduced."""

    def __init__(self, mesh):
        self.mesh = mesh

    def __getattr__(self, name):
        return getattr(self.mesh, name)

    def decimate(self, *_):
        pass


def test_a_document_with_shapes_opens_as_it_was(document, tmp_path):
    _, shape = shaped(document, "box(3, 3, 3)")
    document.saveCopy(str(tmp_path / "shape.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "shape.FCStd"))
    other = again.getObject(shape.Name)
    assert other.Shape.Volume == pytest.approx(27) and other.isValid() and other.MadeFrom == shape.MadeFrom
    again.getObject(other.Source.Name).Expression = "box(1, 1, 1)"
    again.recompute()
    assert other.Shape.Volume == pytest.approx(1)
