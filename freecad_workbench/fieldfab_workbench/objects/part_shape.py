"""A Part shape that follows a solid, for use in Part, Part Design and TechDraw."""

import hashlib
from collections import Counter

import FreeCAD
import Part

from .. import kernel, meshes, registry, work
from ..words import tr
from .document_object import DocumentObject
from .solid import is_solid, source_of

SEWING = 1e-4  # mm


class PartShape(DocumentObject):
    """Proxy of a Part::FeaturePython object: the boundary of its Source, with the Source's placement. Flat,
    cylindrical, conical, spherical, toroidal and smooth free-form parts of the mesh become one face each. Where that
    gives no valid shape, the shape has flat faces only: the mesh is reduced to MostTriangles, since the conversion
    takes about 1 ms a triangle and grows faster than linearly beyond some thousands; then coplanar triangles are merged
    into one face."""

    NAME = "PartShape"

    def add_properties(self, obj):
        add = self.add
        add(obj, "Link", "Source", "Shape", "A solid or a mesh")
        add(obj, "IntegerConstraint", "MostTriangles", "Shape",
            "If all faces are flat, the mesh is reduced to about as many triangles; FreeCAD is slow with more than "
            "some thousands",
            (2000, 12, 50000, 500))
        add(obj, "Bool", "MergeFaces", "Shape", "Merge coplanar triangles into one face", True)
        add(obj, "Bool", "Curved", "Shape",
            "Make cylindrical, conical, spherical, toroidal and free-form faces, as far as the shape stays valid", True)
        add(obj, "String", "Kinds", "Result", "Number of faces of each kind", mode=1)
        add(obj, "Integer", "Faces", "Result", "Number of faces of the shape", mode=1)
        add(obj, "Float", "VolumeChange", "Result", "Volume of the shape above that of the solid, in percent", mode=1)
        add(obj, "String", "MadeFrom", "Result", "Digest of the input; the shape is made again when it changes",
            mode=4)

    def execute(self, obj):
        """Makes the shape. Raises errors: FreeCAD then marks the object, which keeps its previous shape."""
        if obj.Source is None or not hasattr(obj.Source, "Mesh"):
            raise ValueError(tr("{label}: choose a solid or a mesh as its Source").format(label=obj.Label))
        if not obj.Source.isValid():
            raise ValueError(tr("{label}: {source} has failed; the shape is unchanged").format(
                label=obj.Label, source=obj.Source.Label))
        settings = _content(obj.Source), obj.MostTriangles, obj.MergeFaces, obj.Curved
        made_from = hashlib.sha1(repr(settings).encode()).hexdigest()
        if obj.MadeFrom != made_from:
            try:
                shape = shape_of_object(obj.Source, obj.Label, obj.MostTriangles, obj.MergeFaces, obj.Curved)
            except work.Cancelled:
                raise ValueError(tr("{label}: cancelled; it is unchanged").format(label=obj.Label)) from None
            obj.Shape = shape
            obj.Faces, obj.Kinds = len(shape.Faces), kinds_of(shape)
            obj.VolumeChange, obj.MadeFrom = 100 * (shape.Volume / obj.Source.Mesh.Volume - 1), made_from
        obj.Placement = obj.Source.getGlobalPlacement()


def _content(source):
    return getattr(source, "MadeFrom", "") or hashlib.sha1(meshes.bms_of(source.Mesh)).hexdigest()


def shape_of_object(source, label, most_triangles=2000, merge_faces=True, curved=True):
    """Returns the Part shape of an object with a mesh, in its own coordinates. Raises ValueError and
    work.Cancelled."""
    mesh = source.Mesh.copy()
    mesh.Placement = FreeCAD.Placement()
    if curved and mesh.CountFacets:
        shape = _with_curved_faces(source, mesh, label)
        if shape is not None:
            return shape
    return shape_of(mesh, most_triangles, merge_faces, label)


def _with_curved_faces(source, mesh, label):
    """Returns the shape with faces on the surfaces that are found in the mesh, or None."""
    from ..brep import solid  # needs numpy

    vertices, triangles, _ = meshes.arrays_of(meshes.bms_of(mesh))
    made_by = source_of(source, placed=False) if is_solid(source) else None

    def make(progress):
        def step(fraction):
            if not progress(fraction, tr("recognising faces")):
                raise work.Cancelled()

        field = made_by and made_by.field(progress)
        if field is not None and field.sampled:
            return None  # a scan has no such faces
        exact = field if field is not None and field.kind == "f-rep" else None
        return solid.shape_of(vertices, triangles, exact, step)

    try:
        return work.run(make, label)
    except kernel.load().Error as error:
        raise ValueError(f"{label}: {error}") from None


def kinds_of(shape):
    """Returns the number of faces of each kind, in words."""
    words = {"Plane": tr("planar"), "Cylinder": tr("cylindrical"), "Cone": tr("conical"), "Sphere": tr("spherical"),
             "Toroid": tr("toroidal")}
    counts = Counter(words.get(type(face.Surface).__name__, tr("free-form")) for face in shape.Faces)
    return ", ".join(f"{count} {word}" for word, count in counts.most_common())


def shape_of(mesh, most_triangles, merge_faces, label):
    """Returns the Part solids of a Mesh.Mesh, which is reduced in place if it is too large. Raises ValueError if the
    conversion fails."""
    if mesh.CountFacets == 0:
        raise ValueError(tr("{label}: the mesh is empty").format(label=label))
    if mesh.CountFacets > most_triangles:
        mesh.decimate(mesh.BoundBox.DiagonalLength / 1000, 1 - most_triangles / mesh.CountFacets)
        if mesh.CountFacets > 1.5 * most_triangles:
            raise ValueError(tr("{label}: {count} triangles remain where MostTriangles allows {most}; "
                                "allow more, or make the solid coarser").format(
                                    label=label, count=mesh.CountFacets, most=most_triangles))
    pieces, cavities = [], []
    for piece in mesh.getSeparateComponents():
        shape = Part.Shape()
        shape.makeShapeFromMesh(piece.Topology, SEWING)
        (pieces if _signed_volume(piece) > 0 else cavities).extend(Part.Solid(shell) for shell in shape.Shells)
    made = _hollowed(pieces, cavities)
    if made is None or not made.isValid():
        raise ValueError(tr("{label}: the {count} triangles bound no valid Part solid; "
                            "allow more triangles, or make the solid coarser").format(
                                label=label, count=mesh.CountFacets))
    if merge_faces:
        merged = made.removeSplitter()
        made = merged if merged.isValid() and merged.Solids else made
    return made


def _signed_volume(mesh):
    """Returns the signed volume, negative if the triangles face inwards, as around a cavity."""
    import numpy as np  # imported late: the workbench must load quickly

    points, facets = mesh.Topology
    corners = np.array([tuple(p) for p in points])[np.array(facets)]
    return np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6


def _hollowed(pieces, cavities):
    """Returns the solids as one shape, with each cavity cut from the piece that surrounds it."""
    for cavity in cavities:
        for i, piece in enumerate(pieces):
            if piece.BoundBox.isInside(cavity.BoundBox) and piece.isInside(cavity.Vertexes[0].Point, SEWING, False):
                pieces[i] = piece.cut(cavity)
                break
    return Part.makeCompound(pieces) if len(pieces) > 1 else pieces[0] if pieces else None


def create(document, source):
    """Adds the shape of a source to the document; computes nothing yet."""
    obj = document.addObject("Part::FeaturePython", PartShape.NAME)
    PartShape(obj)
    obj.Label, obj.Source = f"{source.Label} shape", source
    registry.add_view(obj)
    return obj
