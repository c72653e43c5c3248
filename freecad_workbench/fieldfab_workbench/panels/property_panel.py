"""Task panel generated from an object's properties, for solids with a few numbers and choices."""

import FreeCAD

from .. import kernel
from ..shim import QtCore, QtWidgets
from ..views.preview import Preview
from ..words import PROPERTY, marked, property_label, tr
from .choices import offer
from .edit_panel import EditPanel
from .measures import place_boxes, quantity_box
from .property_handles import handles_of

SHARED = ("Mesh", "Region", "Result", "Base", "")  # groups shown only in FreeCAD's property editor
HIDDEN = "Hidden"
PURE = ("Direction", "Factors")  # vectors without a unit; the others are positions and displacements
TITLES = {"Combine": marked("Combine"), "Modify": marked("Modify"), "SolidFromObject": marked("Solid from object"),
          "PartShape": marked("Part shape"),
          "FilePart": marked("Part of a model"),
          "PathOfProgram": marked("Path of program"), "OpenScadNode": marked("OpenSCAD shape"),
          "OpenScadText": marked("OpenSCAD text"),
          "CamTool": marked("Tool"), "MachineProgram": marked("Machine program")}  # the last two only without a set-up


class PropertyPanel(EditPanel):
    """A row for each property that applies now, according to the object's editor modes."""

    def __init__(self, obj):
        super().__init__(obj, tr(TITLES[obj.Proxy.NAME]))
        self.rows, self.writers, self.widgets, self.handles = QtWidgets.QFormLayout(), {}, {}, None
        self.layout.addLayout(self.rows)
        self.layout.addWidget(self.message)
        self.layout.addStretch()
        self.form.destroyed.connect(self.remove_handles)
        self.fill()
        self.preview = (
            Preview(obj, self.say, self.form) if hasattr(obj, "Mesh") and hasattr(obj.Proxy, "mesh_settings") else None)

    def changed(self, *_):
        """Writes the values to the object and updates the preview of a solid. Shows errors, such as missing inputs."""
        try:
            self.take_over()
            if self.handles:
                self.handles.refresh()
            if self.preview:
                self.preview.show(self.obj.Proxy.source(self.obj), self.obj.Proxy.mesh_settings(self.obj))
        except (ValueError, kernel.load().Error) as error:
            self.say(str(error))

    def close(self):
        if self.preview:
            self.preview.close()
        self.remove_handles()
        super().close()

    def remove_handles(self):
        if self.handles:
            self.handles.close()
        self.handles = None

    def names(self):
        return [name for name in self.obj.PropertiesList
                if self.obj.getGroupOfProperty(name) not in SHARED and HIDDEN not in self.obj.getEditorMode(name)
                and self.obj.getTypeIdOfProperty(name) in MAKERS]

    def fill(self):
        while self.rows.rowCount():
            self.rows.removeRow(0)
        self.writers.clear()

        def comes_later(name):
            return self.obj.getTypeIdOfProperty(name) != "App::PropertyEnumeration" or name != "Operation"

        for name in sorted(self.names(), key=comes_later):
            self.widgets[name], self.writers[name] = MAKERS[self.obj.getTypeIdOfProperty(name)](self, name)
            widget = self.widgets[name]
            widget.setToolTip(tr(self.obj.getDocumentationOfProperty(name), PROPERTY))
            self.rows.addRow(property_label(name), widget)
        self.remove_handles()
        self.handles = handles_of(self)

    def set_number(self, name, value):
        """Changes a length as if it was typed."""
        self.widgets[name].setProperty("rawValue", value)

    def set_coordinate(self, name, axis, value):
        """Changes a coordinate of a vector as if it was typed."""
        self.widgets[name].findChildren(QtWidgets.QDoubleSpinBox)[axis].setValue(value)

    def take_over(self):
        for write in self.writers.values():
            write()

    # Widgets: each maker returns a widget, and a function that writes its value into the object.
    def _choice(self, name):
        box = QtWidgets.QComboBox()
        offer(box, self.obj.getEnumerationsOfProperty(name), getattr(self.obj, name))

        def chosen():
            self.changed()
            if name == "Operation":
                QtCore.QTimer.singleShot(0, self.fill)  # later: the box is deleted and still in its signal

        box.activated.connect(lambda index: chosen())
        return box, lambda: setattr(self.obj, name, box.currentData())

    def _quantity(self, name):
        box = quantity_box(self.obj, name)
        box.valueChanged.connect(self.changed)
        return box, lambda: self._write_quantity(name, box)

    def _write_quantity(self, name, box):
        if not any(path == name for path, expression in self.obj.ExpressionEngine):
            setattr(self.obj, name, box.property("value"))

    def _number(self, name):
        box = QtWidgets.QDoubleSpinBox()
        box.setDecimals(3)
        box.setRange(0, 1)
        box.setSingleStep(0.05)
        box.setValue(getattr(self.obj, name))
        box.valueChanged.connect(self.changed)
        return box, lambda: setattr(self.obj, name, box.value())

    def _free_number(self, name):
        box = self._free_box(getattr(self.obj, name))
        box.valueChanged.connect(self.changed)
        return box, lambda: setattr(self.obj, name, box.value())

    @staticmethod
    def _free_box(value):
        box = QtWidgets.QDoubleSpinBox()
        box.setDecimals(4)
        box.setRange(-1e6, 1e6)
        box.setValue(value)
        return box

    def _words(self, name):
        if name == "Text":  # many lines
            box = QtWidgets.QPlainTextEdit(getattr(self.obj, name))
            box.textChanged.connect(self.changed)
            return box, lambda: setattr(self.obj, name, box.toPlainText())
        box = QtWidgets.QLineEdit(getattr(self.obj, name))
        box.editingFinished.connect(self.changed)
        return box, lambda: setattr(self.obj, name, box.text())

    def _count(self, name):
        box = QtWidgets.QSpinBox()
        box.setRange(1, 1_000_000)  # the property has its own limits
        box.setValue(getattr(self.obj, name))
        box.valueChanged.connect(self.changed)
        return box, lambda: setattr(self.obj, name, box.value())

    def _yes(self, name):
        box = QtWidgets.QCheckBox()
        box.setChecked(getattr(self.obj, name))
        box.toggled.connect(self.changed)
        return box, lambda: setattr(self.obj, name, box.isChecked())

    def _vector(self, name):
        row = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        boxes = (place_boxes(getattr(self.obj, name)) if name not in PURE
                 else [self._free_box(value) for value in getattr(self.obj, name)])
        for box in boxes:
            box.valueChanged.connect(self.changed)
            layout.addWidget(box)
        return row, lambda: setattr(self.obj, name, FreeCAD.Vector(*(box.value() for box in boxes)))

    def _link(self, name):
        box = QtWidgets.QComboBox()
        for candidate in candidates(self.obj):
            box.addItem(candidate.Label, candidate.Name)
        current = getattr(self.obj, name)
        box.setCurrentIndex(box.findData(current.Name) if current else -1)
        box.activated.connect(self.changed)
        return box, lambda: setattr(self.obj, name,
                                    self.document.getObject(box.currentData()) if box.currentIndex() >= 0 else None)

    def _links(self, name):
        """Returns a list of all candidates, with the chosen ones on top. Checked items are taken in the list's order,
        which the user can change by dragging."""
        box = QtWidgets.QListWidget()
        box.setDragDropMode(QtWidgets.QAbstractItemView.InternalMove)
        box.setMaximumHeight(140)
        box.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)  # takes the available width
        chosen = list(getattr(self.obj, name))
        for candidate in chosen + [c for c in candidates(self.obj) if c not in chosen]:
            item = QtWidgets.QListWidgetItem(candidate.Label, box)
            item.setData(QtCore.Qt.UserRole, candidate.Name)
            item.setCheckState(QtCore.Qt.Checked if candidate in chosen else QtCore.Qt.Unchecked)

        def write():
            items = [box.item(i) for i in range(box.count())]
            wanted = [self.document.getObject(i.data(QtCore.Qt.UserRole))
                      for i in items if i.checkState() == QtCore.Qt.Checked]
            if wanted != list(getattr(self.obj, name)):
                setattr(self.obj, name, wanted)

        box.itemChanged.connect(self.changed)
        box.model().rowsMoved.connect(self.changed)
        return box, write


MAKERS = {
    "App::PropertyEnumeration": PropertyPanel._choice,
    "App::PropertyLength": PropertyPanel._quantity,
    "App::PropertyDistance": PropertyPanel._quantity,
    "App::PropertyAngle": PropertyPanel._quantity,
    "App::PropertyFloatConstraint": PropertyPanel._number,
    "App::PropertyIntegerConstraint": PropertyPanel._count,
    "App::PropertyFloat": PropertyPanel._free_number,
    "App::PropertyString": PropertyPanel._words,
    "App::PropertyBool": PropertyPanel._yes,
    "App::PropertyVector": PropertyPanel._vector,
    "App::PropertyLink": PropertyPanel._link,
    "App::PropertyLinkList": PropertyPanel._links,
}


def candidates(obj):
    """Returns the possible sources of a solid: objects that bound a solid and do not depend on this one."""
    return [other for other in obj.Document.Objects
            if other != obj and obj not in other.OutListRecursive
            and (hasattr(other, "Mesh") or getattr(getattr(other, "Shape", None), "Solids", None))]
