"""Base class of all solids: a mesh in the document that approximates a Field."""

import hashlib

import FreeCAD

from .. import certainty, kernel, meshes, preferences, registry, work
from ..geometry import source_of_geometry
from ..openscad import matrix_of
from ..words import tr
from .document_object import DocumentObject


class Solid(DocumentObject):
    """Proxy of a Mesh::FeaturePython object. Subclasses define the solid (`source`); this class manages the mesh, its
    resolution and its figures. Lengths are mm. The document stores the mesh, which is made again only after its inputs
    have changed."""

    NAME = "Solid"  # name of new objects and of the icon

    # Defined by each kind of solid.
    def add_own_properties(self, obj):
        """Adds the properties that define this kind of solid, with `add`."""

    def source(self, obj):
        """Returns a sources.Source of the solid in its own coordinates. Raises ValueError with a line for the user."""
        raise NotImplementedError

    def csg(self, obj):
        """Returns the solid in its own coordinates as an openscad.Text, or None if OpenSCAD cannot express it. Raises
        ValueError."""
        return None

    def icon_name(self, obj):
        return getattr(obj, "Operation", self.NAME)

    # Common to all kinds.
    def add_properties(self, obj):
        self.add_own_properties(obj)
        add = self.add
        add(obj, "Length", "VoxelSize", "Mesh",
            "Edge of the smallest cell. 0: automatic, from a scan's spacing or from the number of cells in the "
            "preferences. Flat faces of OpenSCAD need no cells", 0)
        add(obj, "Length", "MaxError", "Mesh",
            "Greatest distance of the mesh from the solid; 0: a tenth of the smallest cell", 0)
        add(obj, "Bool", "OnlyWhenShown", "Mesh",
            "Make no mesh while the solid is hidden and only used by other solids", False)
        add(obj, "Bool", "AutoBounds", "Region", "Find the solid's bounds by interval search", True)
        add(obj, "Vector", "Lower", "Region", "Lower corner of the region, if AutoBounds is off",
            FreeCAD.Vector(-50, -50, -50))
        add(obj, "Vector", "Upper", "Region", "Upper corner of the region, if AutoBounds is off",
            FreeCAD.Vector(50, 50, 50))
        self.add_results(obj)
        add(obj, "String", "Certainty", "Result",
            "Whether the mesh is proved to show the whole solid, or the reason; empty for a mesh of an earlier "
            "version", mode=1)
        # Hidden.
        add(obj, "VectorList", "UncertainPlaces", "Result",
            "Lower and upper corners of boxes in which parts may be missing, the largest first", mode=4)

    def add_results(self, obj):
        add = self.add
        add(obj, "Volume", "Volume", "Result", "Volume of the mesh", mode=1)
        add(obj, "Area", "Area", "Result", "Surface area of the mesh", mode=1)
        add(obj, "Integer", "Triangles", "Result", "Number of triangles of the mesh", mode=1)
        # Hidden.
        add(obj, "String", "MadeFrom", "Result", "Digest of the input; the mesh is made again when it changes",
            mode=4)

    def mesh_settings(self, obj):
        """Returns the settings of sources.Source.mesh()."""
        settings = {"voxel": obj.VoxelSize.Value or None, "max_error": obj.MaxError.Value or None}
        if settings["voxel"] is None and preferences.cells() not in (0, kernel.load().default_cells):
            settings["cells"] = preferences.cells()
        if not obj.AutoBounds:
            settings["bounds"] = (*obj.Lower, *obj.Upper)
        return {name: value for name, value in settings.items() if value is not None}

    def execute(self, obj):
        """Makes the mesh, unless it is postponed until the solid is shown. Raises errors: FreeCAD then marks the
        object, which keeps its last mesh."""
        if self.waits(obj):
            return
        try:
            self.make_mesh(obj)
        except work.Cancelled:
            raise ValueError(tr("{label}: cancelled; it is unchanged").format(label=obj.Label)) from None

    # Future value of MadeFrom, and a function that returns the mesh made in advance, or raises its error.
    _ready = (None, None)

    def ahead(self, obj):
        """Returns a `function(progress)` that makes the mesh for the next recompute, on any thread. Returns None if the
        mesh is up to date or postponed, or if the recompute has to report an error."""
        try:
            source, settings = self.source(obj), self.mesh_settings(obj)
        except ValueError:
            return None
        made_from = key_of(source, settings)
        if obj.MadeFrom == made_from or self.waits(obj):
            return None

        def make(progress):
            task = work.Task(lambda progress: source.mesh(progress, **settings))
            task.progress = progress
            task.run()
            if getattr(task.error, "kind", "") != "cancelled":
                self._ready = made_from, task.outcome

        return make

    @staticmethod
    def waits(obj):
        """Returns whether the mesh is postponed until the solid is shown. Other solids need only its Field, not its
        mesh."""
        return obj.OnlyWhenShown and not obj.Visibility and all(is_solid(user) for user in obj.InList)

    def make_mesh(self, obj):
        """Makes the mesh if it is out of date. Raises ValueError, and work.Cancelled."""
        fieldfab, (ready_for, ready), self._ready = kernel.load(), self._ready, (None, None)
        try:
            source, settings = self.source(obj), self.mesh_settings(obj)
            made_from = key_of(source, settings)
            if obj.MadeFrom == made_from:
                return
            if ready_for != made_from:
                ready = lambda: work.run(lambda progress: source.mesh(progress, **settings), obj.Label)
            mesh = ready()
        except fieldfab.Error as error:
            raise ValueError(f"{obj.Label}: {error}") from None
        self.put_mesh(obj, mesh)
        certainty.put(obj, mesh)
        obj.MadeFrom = made_from

    def has_its_mesh(self, obj):
        """Returns whether the mesh is up to date. Raises ValueError."""
        return obj.MadeFrom == key_of(self.source(obj), self.mesh_settings(obj))

    @staticmethod
    def put_mesh(obj, mesh, made=None):
        """Stores a fieldfab.Mesh, in the object's own coordinates, in the object. `made`: the same mesh as a Mesh.Mesh,
        if available. The object keeps its placement."""
        placement = obj.Placement
        obj.Mesh = meshes.to_freecad(mesh) if made is None else made
        obj.Placement = placement
        obj.Volume, obj.Area, obj.Triangles = mesh.volume, mesh.area, len(mesh.triangles)


def key_of(source, settings):
    """Returns a digest that identifies the mesh of a source with settings of sources.Source.mesh()."""
    return hashlib.sha1(repr((source.digest, sorted(settings.items()))).encode()).hexdigest()


def is_solid(obj):
    return isinstance(getattr(obj, "Proxy", None), Solid)


def source_of(obj, placed=True):
    """Returns the Source of any object that bounds a solid: a Fieldfab solid, a mesh, a Part shape or body. `placed`:
    in document coordinates, otherwise in its own. Raises ValueError for other objects."""
    source = obj.Proxy.source(obj) if is_solid(obj) else source_of_geometry(obj)
    if not placed:
        return source
    return source.moved(obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement)


def csg_of(obj):
    """Returns a solid as an openscad.Text in document coordinates, or None if OpenSCAD cannot express it. Raises
    ValueError."""
    text = obj.Proxy.csg(obj) if is_solid(obj) else None
    placement = obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement
    return text if text is None or placement.isIdentity() else text.placed(matrix_of(placement), obj.Label)


def create(kind, document, name=None):
    """Adds a solid of a class to the document; computes nothing yet."""
    obj = document.addObject("Mesh::FeaturePython", name or kind.NAME)
    kind(obj)
    registry.add_view(obj)
    return obj
