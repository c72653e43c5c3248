"""A CAM set-up: a part, a machine, its stock, tools and operations. They fully determine the machine's program."""

import FreeCAD

from .. import workflow
from ..words import marked, tr
from .document_object import WithSettings, create_object

NO_MATERIAL = marked("any")
marked(("acrylic", "aluminium", "cardboard", "copper", "epoxy", "fabric", "foam", "foil", "hard plastic", "hardwood",
        "mdf", "pcb", "plywood", "soft plastic", "vinyl", "wax"))  # of machines, and with known chip loads
ZEROS = marked(("model", "corner", "centre", "point"))
STOCKS = marked({"Margins": ("Margin", "Top", "Thickness"), "Box": ("StockLower", "StockUpper"),
                 "Object": ("StockObject",)})


class CamSetup(WithSettings):
    """A set-up. Its tools and operations are separate objects in order. The machine's settings are properties of the
    set-up."""

    NAME = "CamSetup"

    def add_properties(self, obj):
        self.add(obj, "Link", "Part", "Part", "Solid to be machined")
        self.add_choice(obj, "Zero", "Part",
                        "Zero of the program: that of the model, the corner or centre of the part's top, or a point",
                        ZEROS)
        if "point" not in obj.getEnumerationsOfProperty("Zero"):  # of an earlier version
            before, obj.Zero = obj.Zero, list(ZEROS)
            obj.Zero = before
        self.add(obj, "Vector", "ZeroPoint", "Part", "Zero of the program where that is a point, in the document's "
                 "coordinates")
        self.add_choice(obj, "Machine", "Machine", "Machine that the program is written for", workflow.machines())
        if "Material" not in obj.PropertiesList:
            obj.Machine = "linuxcnc"
            self.add_choice(obj, "Material", "Machine",
                            "Workpiece material, from which feeds, spindle speed and the machine's settings follow",
                            (NO_MATERIAL,))
        self._offer_materials(obj)  # also in a document of an earlier version, which knew fewer
        self.add_choice(obj, "StockFrom", "Stock",
                        "Size of the stock: margins around the part, a box, or the bounding box of an object", STOCKS)
        self.add(obj, "Length", "Margin", "Stock", "Margin at the sides of the part", 2)
        self.add(obj, "Length", "Top", "Stock", "Margin above the part", 1)
        self.add(obj, "Length", "Thickness", "Stock",
                 "Thickness of the stock from its top; 0: down to the lowest point of the part", 0)
        self.add(obj, "Vector", "StockLower", "Stock", "Lower corner of the stock, in the document's coordinates",
                 FreeCAD.Vector(-20, -20, -20))
        self.add(obj, "Vector", "StockUpper", "Stock", "Upper corner of the stock, in the document's coordinates",
                 FreeCAD.Vector(20, 20, 0))
        self.add(obj, "Link", "StockObject", "Stock", "Object whose bounding box is the stock")
        self.add(obj, "LinkList", "Tools", "CAM", "Tools of the CAM job")
        self.add(obj, "LinkList", "Operations", "CAM", "Operations in the order of the program")
        self.add(obj, "Bool", "AdjustFeeds", "CAM",
                 "Adjust feeds to the material that each move removes: slower in corners, faster in air", False)
        self.settle(obj)
        self._show_what_applies(obj)

    def stages(self, obj):
        return [workflow.machine_stage(obj.Machine)]

    def default(self, obj, setting):
        if "Material" not in obj.PropertiesList:
            return setting.default
        return workflow.machine(obj.Machine)["materials"].get(obj.Material, {}).get(setting.name, setting.default)

    def onChanged(self, obj, name):
        if ("Given" in obj.PropertiesList and not self._settling and not obj.Document.Restoring
                and not obj.Document.Transacting):
            if name == "Machine" and "Material" in obj.PropertiesList:
                self._offer_materials(obj)
            if name in ("Machine", "Material"):
                self.settle(obj)
                for operation in getattr(obj, "Operations", []):
                    operation.Proxy.settle(operation)
        if name in ("StockFrom", "Zero"):
            self._show_what_applies(obj)
        super().onChanged(obj, name)

    def _offer_materials(self, obj):
        """Offers the machine's materials. Keeps the current choice if it is among them."""
        offered = [NO_MATERIAL, *sorted(workflow.machine(obj.Machine)["materials"])]
        if obj.getEnumerationsOfProperty("Material") == offered:
            return
        self._settling, before = True, obj.Material
        obj.Material = offered
        obj.Material = before if before in obj.getEnumerationsOfProperty("Material") else NO_MATERIAL
        self._settling = False

    @staticmethod
    def _show_what_applies(obj):
        for kind, names in STOCKS.items():
            for name in names:
                if name in obj.PropertiesList:
                    obj.setEditorMode(name, 0 if obj.StockFrom == kind else 2)
        if "ZeroPoint" in obj.PropertiesList:
            obj.setEditorMode("ZeroPoint", 0 if obj.Zero == "point" else 2)

    def execute(self, obj):
        if getattr(obj.ViewObject, "Proxy", None):
            obj.ViewObject.Proxy.show_stock()  # the part's size may have changed
        self.check(obj)


def is_setup(obj):
    return isinstance(getattr(obj, "Proxy", None), CamSetup)


def setup_of(operation):
    """Returns the set-up that contains an operation or a tool, or None."""
    return next((obj for obj in operation.InList if is_setup(obj)), None)


def programs_of(setup):
    """Returns the machine programs made from a set-up."""
    return [obj for obj in setup.InList if getattr(getattr(obj, "Proxy", None), "NAME", "") == "MachineProgram"]


def box_of(obj):
    """Returns the bounding box of an object in document coordinates. Raises ValueError."""
    if hasattr(obj, "Mesh") and obj.Mesh.CountFacets:
        return obj.Mesh.BoundBox
    if hasattr(obj, "Shape") and not obj.Shape.isNull():
        return obj.Shape.BoundBox
    raise ValueError(tr("{label} has no size").format(label=obj.Label))


def stock_box(setup):
    """Returns the stock's lower and upper corner in document coordinates. Raises ValueError."""
    if setup.StockFrom == "Box":
        return FreeCAD.Vector(setup.StockLower), FreeCAD.Vector(setup.StockUpper)
    if setup.StockFrom == "Object":
        if setup.StockObject is None:
            raise ValueError(tr("{label}: choose a StockObject").format(label=setup.Label))
        box = box_of(setup.StockObject)
        return FreeCAD.Vector(box.XMin, box.YMin, box.ZMin), FreeCAD.Vector(box.XMax, box.YMax, box.ZMax)
    if setup.Part is None:
        raise ValueError(tr("{label}: choose a Part").format(label=setup.Label))
    box, margin = box_of(setup.Part), setup.Margin.Value
    upper = FreeCAD.Vector(box.XMax + margin, box.YMax + margin, box.ZMax + setup.Top.Value)
    bottom = upper.z - setup.Thickness.Value if setup.Thickness.Value else box.ZMin
    return FreeCAD.Vector(box.XMin - margin, box.YMin - margin, bottom), upper


def zero_of(setup):
    """Returns the program's zero in document coordinates. Raises ValueError."""
    if setup.Zero == "point":
        return FreeCAD.Vector(setup.ZeroPoint)
    if setup.Zero == "model":
        return FreeCAD.Vector()
    box = box_of(setup.Part)
    x, y = (box.XMin, box.YMin) if setup.Zero == "corner" else (box.Center.x, box.Center.y)
    return FreeCAD.Vector(x, y, box.ZMax)


def create(document, part=None, label=""):
    """Adds a set-up to the document; computes nothing yet."""
    setup = create_object(CamSetup, document, label or tr("CAM job"))
    setup.Part = part
    return setup


def remove(setup, child):
    """Removes a tool or an operation from a set-up and from the document."""
    setup.Tools = [tool for tool in setup.Tools if tool != child]
    setup.Operations = [operation for operation in setup.Operations if operation != child]
    setup.Document.removeObject(child.Name)
