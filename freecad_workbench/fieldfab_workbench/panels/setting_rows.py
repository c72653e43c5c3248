"""Form generated from the settings of a workflow stage. A setting that is not given shows its default in grey. An error
is shown below its setting."""

from ..kernel_messages import translated
from .. import units
from ..shim import QtCore, QtWidgets
from ..words import tr

GREY, RED = "color: gray", "color: #b3261e"


class Row:
    """One setting: its label, its editor, and a line for its error."""

    def __init__(self, obj, setting, changed):
        self.obj, self.setting, self.changed = obj, setting, changed
        self.label = QtWidgets.QLabel(setting.label)
        self.problem = QtWidgets.QLabel()
        self.problem.setStyleSheet(RED)
        self.problem.setWordWrap(True)
        self.problem.hide()
        make = self._choice if setting.choices else self._flag if setting.kind == "flag" else self._line
        self.editor = make()
        for widget in (self.label, self.editor):
            widget.setToolTip(setting.tip)
        self.field = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(self.field)
        column.setContentsMargins(0, 2, 0, 2)
        column.setSpacing(0)
        column.addWidget(self.editor)
        column.addWidget(self.problem)
        self.refresh()

    @property
    def given(self):
        return self.setting.property in self.obj.Given

    @property
    def driven(self):
        return any(path == self.setting.property for path, expression in self.obj.ExpressionEngine)

    def _default(self):
        return self.setting.shown(self.obj.Proxy.default(self.obj, self.setting))

    def refresh(self):
        """Shows the object's value, unless the editor has the focus."""
        matters = self.setting.matters(self.obj.Proxy.effective(self.obj))
        for widget in (self.label, self.field):
            widget.setVisible(matters)
        self.editor.setEnabled(not self.driven)
        self.label.setStyleSheet("" if self.given else GREY)
        value = self.setting.read(self.obj) if self.given else None
        self.editor.blockSignals(True)
        if isinstance(self.editor, QtWidgets.QLineEdit):
            self.editor.setPlaceholderText(self._default())
            if not self.editor.hasFocus():
                self.editor.setText("" if value is None else self.setting.shown(value))
        elif isinstance(self.editor, QtWidgets.QComboBox):
            self.editor.setItemText(0, tr("{default} (default)").format(default=self._default()))
            self.editor.setCurrentIndex(0 if value is None else 1 + self.setting.choices.index(value))
            self.editor.setStyleSheet(GREY if value is None else "")
        else:
            self.editor.setChecked(bool(self.obj.Proxy.effective(self.obj)[self.setting.name]))
            self.editor.setText("" if self.given else tr("default"))
            self.editor.setStyleSheet("" if self.given else GREY)
        self.editor.blockSignals(False)
        self.say(self.setting.problem(value) if value is not None else "")

    def say(self, words):
        self.problem.setText(units.in_words(translated(words)))
        self.problem.setVisible(bool(words))

    def show(self):
        """Scrolls the panel to this row."""
        area = self.field.parent()
        while area is not None and not isinstance(area, QtWidgets.QScrollArea):
            area = area.parent()
        if area is not None:
            QtCore.QTimer.singleShot(0, lambda: area.ensureWidgetVisible(self.field))

    def _give(self, value):
        self.obj.Proxy.give(self.obj, self.setting, value)
        self.changed()

    def _line(self):
        line = QtWidgets.QLineEdit()
        line.setClearButtonEnabled(True)

        def typed(text):
            try:
                value = (None if not text.strip() else text if self.setting.kind == "text"
                         else units.read(text, self.setting.unit))
                words = self.setting.problem(value) if value is not None else ""
            except ValueError as error:
                value, words = None, str(error)
            if not words:
                self._give(value)
            self.say(words)

        line.textChanged.connect(typed)
        line.editingFinished.connect(lambda: self.problem.isHidden() and self.refresh())
        return line

    def _choice(self):
        box = QtWidgets.QComboBox()
        box.addItems(["", *map(self.setting.shown, self.setting.choices)])
        box.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.activated.connect(lambda index: self._give(None if index == 0 else self.setting.choices[index - 1]))
        return box

    def _flag(self):
        box = QtWidgets.QCheckBox()
        box.clicked.connect(lambda checked: self._give(
            None if checked == bool(self.obj.Proxy.default(self.obj, self.setting)) else checked))
        return box


class SettingRows(QtWidgets.QWidget):
    """The settings of a stage of an object. `changed` is called if one is given or reset to its default."""

    def __init__(self, obj, stage, changed=lambda: None):
        super().__init__()
        form = QtWidgets.QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(0)  # hidden rows would leave gaps
        form.setFieldGrowthPolicy(QtWidgets.QFormLayout.ExpandingFieldsGrow)
        form.setLabelAlignment(QtCore.Qt.AlignLeft)
        self._told = changed
        self.rows = {}
        for setting in stage.settings:
            row = Row(obj, setting, self._changed)
            form.addRow(row.label, row.field)
            self.rows[setting.name] = row

    def _changed(self):
        self._told()

    def refresh(self):
        for row in self.rows.values():
            row.refresh()
