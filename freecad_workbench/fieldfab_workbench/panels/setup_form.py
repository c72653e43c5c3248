"""Form for a simulation's program, stock, tools and target."""

import FreeCAD

from .. import units
from ..objects import programs, set_ups
from ..objects.simulation import DIALECTS, bounds_of
from ..shim import QtCore, QtWidgets
from ..words import PROPERTY, marked, tr
from .choices import offer
from .measures import MeasureBox, place_boxes
from .property_panel import candidates

TOOL_COLUMNS = tuple(zip(
    ("number", "shape", "diameter", "corner_radius", "angle", "flute", "length", "shank", "holder_diameter",
     "holder_length"),
    marked(("No.", "Shape", "Diameter", "Corner", "Angle", "Flute", "Length", "Shank", "Holder \N{DIAMETER SIGN}",
            "Holder length"))))
SHAPES = marked(("flat", "ball", "bull", "v", "tapered", "drill", "form"))
UNITS = {"number": "", "angle": ""}  # columns other than lengths
MARGIN = 5.0  # mm of stock around a program's extent, for the initial guess


class FileBox(QtWidgets.QWidget):
    """A line for a file name, with a button that opens a file dialog."""

    def __init__(self, path, words, kinds):
        super().__init__()
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.line = QtWidgets.QLineEdit(path)
        self.line.setPlaceholderText(words)
        button = QtWidgets.QToolButton()
        button.setText("\N{HORIZONTAL ELLIPSIS}")
        button.clicked.connect(lambda: self._ask(kinds))
        row.addWidget(self.line)
        row.addWidget(button)

    def _ask(self, kinds):
        path = QtWidgets.QFileDialog.getOpenFileName(self, "Fieldfab", self.line.text(), kinds)[0]
        if path:
            self.line.setText(path)
            self.line.editingFinished.emit()


def _cell(tool, key):
    """Returns the text of a tool's cell in a column."""
    return units.told(tool[key], UNITS.get(key, "mm"), 6) if tool.get(key) else ""


class SetupForm(QtWidgets.QWidget):
    """Edits the inputs of a Simulation object; `write()` stores them in the object."""

    def __init__(self, obj):
        super().__init__()
        self.obj = obj
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        rows = QtWidgets.QFormLayout()
        self.of_object = self._objects(obj.Program, [o for o in obj.Document.Objects
                                                     if o != obj and programs.offers_program(o)], tr("a file"))
        self.program = FileBox(obj.ProgramFile, tr("the machine's program"),
                               tr("Programs (*.nc *.ngc *.tap *.gcode *.cnc *.sbp *.rml *.plt *.hpgl);;All files (*)"))
        self.of_setup = self._objects(obj.SetupProgram, [o for o in obj.Document.Objects if programs.is_planned(o)],
                                      tr("none: a file, or the settings below"))
        self.of_setup.activated.connect(lambda index: self._follow())
        self.dialect = QtWidgets.QComboBox()
        offer(self.dialect, DIALECTS, obj.Dialect)
        self.dialect.setToolTip(tr(obj.getDocumentationOfProperty("Dialect"), PROPERTY))
        self.setup = FileBox(obj.SetupFile, tr("none: the settings below"), tr("Set-ups and jobs (*.toml)"))
        self.cell = MeasureBox(obj.Cell.Value, zero=tr("automatic"), step=0.01)
        self.target = self._objects(obj.Target, candidates(obj), tr("none, or that of the set-up"))
        rows.addRow(tr("Program of"), self.of_object)
        rows.addRow(tr("Program"), self.program)
        rows.addRow(tr("Dialect"), self.dialect)
        rows.addRow(tr("Set-up of"), self.of_setup)
        rows.addRow(tr("Set-up file"), self.setup)
        rows.addRow(tr("Target"), self.target)
        rows.addRow(tr("Cell"), self.cell)
        layout.addLayout(rows)
        self.by_hand = QtWidgets.QGroupBox(tr("Set-up"))
        layout.addWidget(self.by_hand)
        self._add_by_hand(QtWidgets.QVBoxLayout(self.by_hand))
        layout.addStretch()
        self._before = self.of_object.currentData()
        self.of_object.activated.connect(lambda index: self._chosen())
        self.program.line.editingFinished.connect(self._guess_where_nothing_is)
        self.setup.line.textChanged.connect(lambda text: self._follow())
        self.stock.activated.connect(lambda index: self._follow())
        self._follow()
        if obj.Program is not None and not obj.MadeFrom:
            self.take_from(obj.Program)

    @staticmethod
    def _objects(current, offered, none):
        box = QtWidgets.QComboBox()
        box.addItem(none, "")
        for each in offered:
            box.addItem(each.Label, each.Name)
        box.setCurrentIndex(max(0, box.findData(current.Name)) if current is not None else 0)
        return box

    def _add_by_hand(self, layout):
        obj, rows = self.obj, QtWidgets.QFormLayout()
        self.machine = QtWidgets.QComboBox()
        offer(self.machine, obj.getEnumerationsOfProperty("Machine"), obj.Machine)
        self.stock = self._objects(obj.Stock, candidates(obj), tr("a box"))
        self.lower, self.upper = place_boxes(obj.StockLower), place_boxes(obj.StockUpper)
        self.gouge, self.excess, self.touch = (MeasureBox(value.Value, zero=zero, step=0.01) for value, zero in (
            (obj.Gouge, ""), (obj.Excess, tr("any")), (obj.Touch, "")))
        rows.addRow(tr("Machine"), self.machine)
        rows.addRow(tr("Stock"), self.stock)
        self.corners = QtWidgets.QWidget()
        grid = QtWidgets.QGridLayout(self.corners)
        grid.setContentsMargins(0, 0, 0, 0)
        for row, (words, boxes) in enumerate(((tr("from"), self.lower), (tr("to"), self.upper))):
            grid.addWidget(QtWidgets.QLabel(words), row, 0)
            for column, box in enumerate(boxes):
                grid.addWidget(box, row, column + 1)
        guess = QtWidgets.QPushButton(tr("Around the program"))
        guess.setToolTip(tr("A box around all positions of the program"))
        guess.clicked.connect(self.guess_stock)
        grid.addWidget(guess, 2, 1, 1, 3)
        rows.addRow("", self.corners)
        rows.addRow(tr("Gouge tolerance"), self.gouge)
        rows.addRow(tr("Excess tolerance"), self.excess)
        rows.addRow(tr("Contact tolerance"), self.touch)
        layout.addLayout(rows)
        self.tools = QtWidgets.QTableWidget(0, len(TOOL_COLUMNS))
        self.tools.setHorizontalHeaderLabels([tr(words) for _, words in TOOL_COLUMNS])
        self.tools.verticalHeader().hide()
        self.tools.setMinimumHeight(110)
        for line in obj.Tools:
            self._add_tool(set_ups.tool_from_line(line))
        layout.addWidget(self.tools)
        row = QtWidgets.QHBoxLayout()
        for words, function in ((tr("Add tool"), self._new_tool),
                                (tr("Remove"), lambda: self.tools.removeRow(self.tools.currentRow()))):
            button = QtWidgets.QPushButton(words)
            button.clicked.connect(function)
            row.addWidget(button)
        row.addStretch()
        layout.addLayout(row)

    def _new_tool(self):
        numbers = [self._tool(row).get("number", 0) for row in range(self.tools.rowCount())]
        self._add_tool({**set_ups.DEFAULT_TOOL, "number": max(numbers, default=0) + 1})

    def _add_tool(self, tool):
        row = self.tools.rowCount()
        self.tools.insertRow(row)
        for column, (key, _) in enumerate(TOOL_COLUMNS):
            if key == "shape":
                box = QtWidgets.QComboBox()
                offer(box, SHAPES, tool.get("shape", "flat"))
                self.tools.setCellWidget(row, column, box)
            else:
                self.tools.setItem(row, column, QtWidgets.QTableWidgetItem(_cell(tool, key)))
        self.tools.item(row, 0).setData(QtCore.Qt.UserRole, set_ups.tool_to_line(tool))  # also keys without a column
        self.tools.resizeColumnsToContents()

    def _tool(self, row):
        """Returns the tool in a row. Raises ValueError with a line for the user."""
        tool = set_ups.tool_from_line(self.tools.item(row, 0).data(QtCore.Qt.UserRole) or "{}")
        for column, (key, words) in enumerate(TOOL_COLUMNS):
            if key == "shape":
                tool[key] = self.tools.cellWidget(row, column).currentData()
                continue
            text = self.tools.item(row, column).text().strip()
            if text == _cell(tool, key):
                continue
            tool.pop(key, None)
            if text:
                try:
                    tool[key] = int(text) if key == "number" else units.read(text, UNITS.get(key, "mm"))
                except ValueError:
                    raise ValueError(tr("tool {row}: {words} is a number, not {text!r}").format(
                        row=row + 1, words=tr(words), text=text)) from None
        return tool

    def _follow(self):
        """Shows only the inputs that apply."""
        planned = programs.is_planned(self._program_object())
        self.by_hand.setVisible(not self.setup.line.text() and not planned and not self.of_setup.currentData())
        self.of_setup.setEnabled(not planned)
        self.program.setEnabled(not self.of_object.currentData())
        self.corners.setVisible(not self.stock.currentData())

    def _program_object(self):
        """Returns the object that provides the program, or None for a file."""
        return self.obj.Document.getObject(self.of_object.currentData()) if self.of_object.currentData() else None

    def _chosen(self):
        """Takes tools, stock and target from a Path Job. When the program changes from a machine program to a file,
        such as an edited copy of it, the program's set-up is kept."""
        source, before = self._program_object(), self.obj.Document.getObject(self._before) if self._before else None
        self._before = self.of_object.currentData()
        if source is None and programs.is_planned(before):
            self.of_setup.setCurrentIndex(self.of_setup.findData(before.Name))
        self._follow()
        if source is not None:
            self.take_from(source)

    def take_from(self, source):
        if programs.is_planned(source):
            return  # its job is a complete set-up
        tools = programs.tools_of(source) if programs.is_job(source) or hasattr(source, "Path") else []
        if tools:
            self.tools.setRowCount(0)
            for tool in tools:
                self._add_tool(tool)
        if programs.is_job(source) and source.Stock is not None:
            box = bounds_of(source.Stock)
            self._set_corners((box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax))
            parts = source.Model.Group
            if len(parts) == 1:
                self.target.setCurrentIndex(max(0, self.target.findData(parts[0].Name)))
        else:
            self._guess_where_nothing_is()

    def _guess_where_nothing_is(self):
        if (not self.setup.line.text() and not self.of_setup.currentData()
                and all(box.value() == 0 for box in self.lower + self.upper)):
            self.guess_stock()

    def guess_stock(self):
        try:
            name = self.of_object.currentData()
            program = (programs.program_of(self.obj.Document.getObject(name)) if name
                       else programs.program_from_file(self.program.line.text()))
        except ValueError:
            return
        if (found := programs.extent(program)) is not None:
            (x0, y0, z0), (x1, y1, z1) = found
            highest = programs.highest_cut(program)
            # In most programs z = 0 is the top of the stock.
            top = z1 if highest is None else max(highest, 0.0) if z0 < 0 else highest
            self._set_corners((x0 - MARGIN, y0 - MARGIN, min(z0, top) - MARGIN), (x1 + MARGIN, y1 + MARGIN, top))

    def _set_corners(self, lower, upper):
        for boxes, values in ((self.lower, lower), (self.upper, upper)):
            for box, value in zip(boxes, values):
                box.setValue(value)

    def write(self):
        """Writes the values to the object. Raises ValueError with a line for the user."""
        obj, tools = self.obj, [set_ups.tool_to_line(self._tool(row)) for row in range(self.tools.rowCount())]
        find = lambda box: obj.Document.getObject(box.currentData()) if box.currentData() else None
        values = {
            "Program": find(self.of_object), "ProgramFile": self.program.line.text(),
            "Dialect": self.dialect.currentData(), "SetupFile": self.setup.line.text(),
            "SetupProgram": find(self.of_setup), "Target": find(self.target),
            "Cell": self.cell.value(), "Machine": self.machine.currentData(), "Stock": find(self.stock), "Tools": tools,
            "StockLower": FreeCAD.Vector(*(b.value() for b in self.lower)),
            "StockUpper": FreeCAD.Vector(*(b.value() for b in self.upper)),
            "Gouge": self.gouge.value(), "Excess": self.excess.value(), "Touch": self.touch.value(),
        }
        for name, value in values.items():
            held = getattr(obj, name)
            if getattr(held, "Value", held) != value:
                setattr(obj, name, value)
