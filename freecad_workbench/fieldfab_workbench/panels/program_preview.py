"""Preview of a machine program with line numbers, before it is saved."""

from ..shim import QtWidgets
from ..words import tr
from .program_view import ProgramView
from .wheel import WheelGuard


class ProgramPreview(QtWidgets.QDialog):
    """`text`: the program. `accepted` is emitted if the user chooses to save it."""

    def __init__(self, title, text, about, parent=None):
        super().__init__(parent)
        self.setWindowTitle(title)
        self.resize(640, 620)
        column = QtWidgets.QVBoxLayout(self)
        lines = text.splitlines()
        words = QtWidgets.QLabel(tr("{count} lines. {about}").format(count=len(lines), about=about))
        words.setWordWrap(True)
        self.program = ProgramView()
        self.program.setToolTip("")
        self.program.set_lines(lines)
        self.wheel = WheelGuard(self)
        buttons = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.Save | QtWidgets.QDialogButtonBox.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        for widget in (words, self.program, buttons):
            column.addWidget(widget)
