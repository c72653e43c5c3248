"""Table of the tools of a CAM set-up, and all numbers of the selected tool below it."""

from ..kernel_messages import translated
from .. import tool_library, units
from ..objects import cam_setup, cam_tool
from ..shim import QtCore, QtWidgets
from ..words import PROPERTY, marked, property_label, tr
from .choices import offer
from .measures import MeasureBox
from .tool_library_dialog import ToolLibraryDialog
from .tool_picture import icon

MORE = ("CornerRadius", "Angle", "TipDiameter", "Flute", "StickOut", "Shank", "HolderDiameter", "HolderLength",
        "Flutes", "Feed", "Plunge", "Spindle")
COLUMNS = marked(("No.", "Name", "Shape", "\u2300 {unit}"))


class ToolTable(QtWidgets.QWidget):
    """Calls `changed` after each change."""

    def __init__(self, setup, changed=lambda: None):
        super().__init__()
        self.setup, self.changed = setup, changed
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.table = QtWidgets.QTableWidget(0, len(COLUMNS))
        self.table.setHorizontalHeaderLabels([tr(words).format(unit=units.shown_unit("mm")) for words in COLUMNS])
        self.table.verticalHeader().hide()
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        head = self.table.horizontalHeader()
        for place, width in ((0, 36), (2, 84), (3, 56)):
            self.table.setColumnWidth(place, width)
        head.setSectionResizeMode(1, QtWidgets.QHeaderView.Stretch)
        self.table.setFixedHeight(128)
        self.table.itemChanged.connect(self._edited)
        self.table.itemSelectionChanged.connect(self._show_more)
        column.addWidget(self.table)
        buttons = QtWidgets.QHBoxLayout()
        for words, tip, action in ((tr("Add"), tr("A new end mill"), self.add),
                                   (tr("Library…"), tr("Your tools, for all documents"), self.open_library),
                                   (tr("Keep"), tr("Puts the chosen tool into your library"), self.keep),
                                   (tr("Remove"), tr("The chosen tool"), self.remove)):
            button = QtWidgets.QPushButton(words)
            button.setToolTip(tip)
            button.clicked.connect(action)
            buttons.addWidget(button)
        column.addLayout(buttons)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        self.message.setStyleSheet("color: #b3261e")
        self.message.hide()
        column.addWidget(self.message)
        self.more = QtWidgets.QFormLayout()
        column.addLayout(self.more)
        self.fill()

    def chosen(self):
        row = self.table.currentRow()
        return self.setup.Tools[row] if 0 <= row < len(self.setup.Tools) else None

    def fill(self, row=0):
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.setup.Tools))
        for line, tool in enumerate(self.setup.Tools):
            for place, value in enumerate((tool.Number, tool.Label, None, units.shown(tool.Diameter.Value))):
                if place == 2:
                    shape = QtWidgets.QComboBox()
                    offer(shape, cam_tool.SHAPES, tool.Shape)
                    shape.activated.connect(lambda index, tool=tool, shape=shape, line=line: self._reshape(
                        tool, shape.itemData(index), line))
                    self.table.setCellWidget(line, place, shape)
                else:
                    item = QtWidgets.QTableWidgetItem(value if place == 1 else f"{value:.6g}")
                    if place == 1 and tool.Diameter.Value > 0:
                        item.setIcon(icon(cam_tool.values_of(tool)))
                    self.table.setItem(line, place, item)
        self.table.blockSignals(False)
        if self.setup.Tools:
            self.table.setCurrentCell(min(row, len(self.setup.Tools) - 1), 1)
        self._show_more()

    def say(self, words):
        self.message.setText(translated(words))
        self.message.setVisible(bool(words))

    def _edited(self, item):
        self.say(self._problem(self.setup.Tools[item.row()], item.column(), item.text().strip()))
        self.fill(item.row())
        self.changed()

    def _problem(self, tool, column, text):
        """Writes the text of a cell to the tool. Returns an error message, "" for success."""
        if column == 1:
            tool.Label = text or cam_tool.name_of(tool)
            return ""
        try:
            number = int(text) if column == 0 else units.read(text)
        except ValueError:
            return tr("{text!r} is no number").format(text=text)
        if column == 0 and number in {other.Number for other in self.setup.Tools if other != tool}:
            return tr("tool number {number} is already in use").format(number=number)
        if column != 0 and not number > 0:
            return tr("a diameter must be above 0")
        setattr(tool, "Number" if column == 0 else "Diameter", number)
        return ""

    def _reshape(self, tool, shape, line):
        """Changes the shape. Keeps the combo box that emitted the signal and only rebuilds the rows below the table."""
        tool.Shape = shape
        self.table.blockSignals(True)
        self.table.item(line, 1).setText(tool.Label)
        self.table.blockSignals(False)
        self.table.setCurrentCell(line, 1)
        self._show_more()
        self.changed()

    def _show_more(self):
        while self.more.rowCount():
            self.more.removeRow(0)
        tool = self.chosen()
        if tool is None:
            return
        for name in MORE:
            if "Hidden" not in tool.getEditorMode(name):
                self.more.addRow(property_label(name), self._number(tool, name))

    def _number(self, tool, name):
        kind, value = tool.getTypeIdOfProperty(name), getattr(tool, name)
        factor = 60 if kind == "App::PropertySpeed" else 1
        unit = {"App::PropertyLength": "mm", "App::PropertySpeed": "mm/min"}.get(kind)
        box = (MeasureBox(unit=unit) if unit else QtWidgets.QSpinBox() if kind == "App::PropertyIntegerConstraint"
               else QtWidgets.QDoubleSpinBox())
        box.setRange(1 if name == "Flutes" else 0, 1000000)
        box.setValue(getattr(value, "Value", value) * factor)
        box.setToolTip(tr(tool.getDocumentationOfProperty(name), PROPERTY))
        if suffix := {"App::PropertyAngle": " \u00b0", "App::PropertyFloatConstraint": " " + tr("rpm")}.get(kind):
            box.setSuffix(suffix)
            box.setDecimals(1)
        if name not in ("Angle", "TipDiameter", "Flutes"):
            box.setSpecialValueText(tr("not known") if unit == "mm" else tr("as the operation says"))

        def write(number):
            setattr(tool, name, number / factor if kind != "App::PropertyIntegerConstraint" else int(number))
            self.changed()

        box.valueChanged.connect(write)
        return box

    def add(self):
        cam_tool.add(self.setup, {"diameter": 3})
        self.fill(len(self.setup.Tools) - 1)
        self.changed()

    def remove(self):
        tool = self.chosen()
        if tool is not None:
            cam_setup.remove(self.setup, tool)
            self.fill()
            self.changed()

    def open_library(self):
        self.library = ToolLibraryDialog(self.take, self)
        self.library.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.library.show()

    def keep(self):
        tool = self.chosen()
        if tool is None:
            return
        try:
            new = tool_library.keep([cam_tool.values_of(tool)])
        except (ValueError, OSError) as error:
            return self.say(str(error))
        self.say("" if new else tr("The library has this tool already"))

    def take(self, tools):
        """Adds tools, given with the names of job files."""
        for tool in tools:
            cam_tool.add(self.setup, tool)
        self.fill(len(self.setup.Tools) - 1)
        self.changed()
