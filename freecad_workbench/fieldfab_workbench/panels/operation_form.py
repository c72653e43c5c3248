"""Form of an operation: its stages as stacked boxes."""

from .. import workflow
from ..objects import cam_setup
from ..shim import QtWidgets
from ..words import PROPERTY, kernel_name, titled, tr
from .collapsible import Box
from .setting_rows import SettingRows

OPENED = (workflow.JOINING,)  # stages open at first, in addition to the operation's own


class OperationForm(QtWidgets.QWidget):
    """Name, type and tool of an operation, and a box for each stage that leads to its moves. `boxes` and `rows`: by the
    stages' names."""

    def __init__(self, obj, changed=lambda: None):
        super().__init__()
        self.obj, self.changed = obj, changed
        self.column = QtWidgets.QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        head = QtWidgets.QFormLayout()
        self.name = QtWidgets.QLineEdit(obj.Label)
        self.name.editingFinished.connect(self._rename)
        self.type = QtWidgets.QComboBox()
        for kind in obj.getEnumerationsOfProperty("Type"):
            self.type.addItem(kernel_name(kind), kind)
        self.type.setCurrentIndex(self.type.findData(obj.Type))
        self.type.activated.connect(lambda index: self._choose(self.type.itemData(index)))
        self.tool = QtWidgets.QComboBox()
        self.tool.activated.connect(lambda index: self._take_tool(self.tool.itemData(index)))
        self.active = QtWidgets.QCheckBox(tr("active"))
        self.active.setToolTip(tr(obj.getDocumentationOfProperty("Active"), PROPERTY))
        self.active.setChecked(obj.Active)
        self.active.clicked.connect(self._activate)
        for words, widget in ((tr("Name"), self.name), (tr("Operation"), self.type), (tr("Tool"), self.tool),
                              ("", self.active)):
            head.addRow(words, widget)
        self.column.addLayout(head)
        self.boxes, self.rows = {}, {}
        self.fill()

    def fill(self):
        for box in self.boxes.values():
            self.column.removeWidget(box)
            box.deleteLater()
        self.boxes, self.rows = {}, {}
        for stage in workflow.stages_of(self.obj.Type):
            box = Box(stage.label, tip=stage.tip, opened=stage.name in (self.obj.Type, *OPENED))
            rows = SettingRows(self.obj, stage, self._changed)
            box.body.addWidget(rows)
            self.column.addWidget(box)
            self.boxes[stage.name], self.rows[stage.name] = box, rows
        self.refresh()

    def refresh(self):
        setup = cam_setup.setup_of(self.obj)
        self.tool.clear()
        for tool in setup.Tools if setup else []:
            self.tool.addItem(f"{tool.Number}: {tool.Label}", tool.Name)
        self.tool.setCurrentIndex(self.tool.findData(self.obj.Tool.Name) if self.obj.Tool else -1)
        for name, rows in self.rows.items():
            rows.refresh()
            given = sum(row.given for row in rows.rows.values())
            self.boxes[name].hint.setText(tr("{given} given").format(given=given) if given else tr("defaults"))

    def say(self, setting, words):
        """Shows an error at a setting. Returns False if there is no such setting."""
        for name, rows in self.rows.items():
            if setting in rows.rows:
                self.boxes[name].open()
                rows.rows[setting].say(words)
                rows.rows[setting].show()
                return True
        return False

    def _changed(self):
        self.refresh()
        self.changed()

    def _rename(self):
        if self.name.text().strip() and self.name.text() != self.obj.Label:
            self.obj.Label = self.name.text()
            self.changed()

    def _choose(self, kind):
        if kind != self.obj.Type:
            named_after_type = self.obj.Label.startswith((kernel_name(self.obj.Type), titled(self.obj.Type)))
            self.obj.Type = kind
            if named_after_type:
                self.obj.Label = kernel_name(kind)
                self.name.setText(self.obj.Label)
            self.fill()
            self.changed()

    def _take_tool(self, name):
        self.obj.Tool = self.obj.Document.getObject(name)
        self._changed()

    def _activate(self, active):
        self.obj.Active = active
        self.changed()
