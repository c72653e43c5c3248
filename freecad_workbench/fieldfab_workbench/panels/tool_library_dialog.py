"""Dialog with the user's tool library: its tools as pictures, which are taken into a job."""

from ..kernel_messages import translated
from .. import tool_library, units
from ..objects import cam_tool
from ..shim import QtCore, QtWidgets
from ..words import property_label, tr
from .tool_picture import icon

SIZE = 72  # of a picture, pixels


class ToolLibraryDialog(QtWidgets.QDialog):
    """Calls `take(tools)` with the chosen tools, and stays open."""

    def __init__(self, take, parent=None):
        super().__init__(parent)
        self.take = take
        self.setWindowTitle(tr("Tool library"))
        self.resize(560, 420)
        column = QtWidgets.QVBoxLayout(self)
        self.list = QtWidgets.QListWidget()
        self.list.setViewMode(QtWidgets.QListView.IconMode)
        self.list.setIconSize(QtCore.QSize(SIZE, SIZE))
        self.list.setGridSize(QtCore.QSize(SIZE + 60, SIZE + 52))
        self.list.setResizeMode(QtWidgets.QListView.Adjust)
        self.list.setMovement(QtWidgets.QListView.Static)
        self.list.setWordWrap(True)
        self.list.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.list.itemDoubleClicked.connect(lambda item: self.add())
        column.addWidget(self.list, 1)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        column.addWidget(self.message)
        row = QtWidgets.QHBoxLayout()
        for words, tip, action in (
                (tr("Add to job"), tr("The chosen tools; a double click adds one"), self.add),
                (tr("Import…"), tr("Tools of FreeCAD (.fctb, .fctl) or Fusion (.json)"), self.ask),
                (tr("Remove"), tr("The chosen tools leave the library; jobs keep theirs"), self.remove),
                (tr("Close"), "", self.close)):
            button = QtWidgets.QPushButton(words)
            button.setToolTip(tip)
            button.setAutoDefault(False)
            button.clicked.connect(action)
            row.addWidget(button)
        column.addLayout(row)
        self.fill()

    def fill(self):
        self.list.clear()
        try:
            self.tools = tool_library.tools()
        except (ValueError, OSError) as error:
            self.tools = []
            return self.message.setText(translated(str(error)))
        for tool in self.tools:
            item = QtWidgets.QListWidgetItem(icon(tool, SIZE), tool.get("name") or tool["shape"], self.list)
            item.setToolTip(about(tool))
        if not self.tools:
            self.message.setText(tr("The library is empty: import tools, or keep those of a job"))

    def chosen(self):
        return [self.list.row(item) for item in self.list.selectedItems()]

    def add(self):
        told = [self.tools[place] for place in sorted(self.chosen())]
        if told:
            self.take(told)
            self.message.setText(tr("{count} tools added to the job").format(count=len(told)) if len(told) > 1
                                 else tr("{name} added to the job").format(name=told[0].get("name", "")))

    def remove(self):
        if self.chosen():
            self.message.clear()
            try:
                tool_library.remove(set(self.chosen()))
                self.fill()
            except (ValueError, OSError) as error:
                self.message.setText(translated(str(error)))

    def ask(self):
        paths, kind = QtWidgets.QFileDialog.getOpenFileNames(
            self, tr("Tools"), "", tr("Tools of FreeCAD or Fusion (*.fctb *.fctl *.json)"))
        self.take_files(paths)

    def take_files(self, paths):
        """Keeps the tools of files in the library; says what could not be read."""
        said, count, before = [], 0, len(self.tools)
        for path in paths:
            try:
                tools, notes = tool_library.read(path)
                count += tool_library.keep([each for each in tools if each["shape"] in cam_tool.SHAPES])
                said += notes + [tr("{name}: Fieldfab does not know the tool shape {shape}").format(**each)
                                 for each in tools if each["shape"] not in cam_tool.SHAPES]
            except (ValueError, OSError) as error:
                said.append(translated(str(error)))
        self.fill()
        for place in range(before, self.list.count()):  # to be added to the job by one click
            self.list.item(place).setSelected(True)
        self.message.setText("\n".join([tr("{count} tools imported").format(count=count), *said]))


def about(tool):
    """Returns the tool's sizes in the user's units, a line each."""
    lines = [tool.get("name", "")]
    lines += [f"{property_label(name)}: {units.told(tool[key])}"
              for key, (name, words, standard) in cam_tool.LENGTHS.items() if tool.get(key)]
    if tool.get("angle") and "Angle" in cam_tool.SHAPES.get(tool["shape"], ()):
        lines.append(f"{property_label('Angle')}: {tool['angle']:g}°")
    return "\n".join(lines)
