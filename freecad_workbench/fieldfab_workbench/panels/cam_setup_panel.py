"""Task panel of a CAM set-up: a stack of boxes, one for each stage from the part to the machine (Keeter, Fig. 6-2), and
the plan."""

from ..kernel_messages import translated
from .. import kernel, units, work, workflow
from ..objects import cam_job, cam_operation, cam_setup, machine_program
from ..shim import QtCore, QtWidgets
from ..views.part_view import PartView
from ..words import PROPERTY, kernel_text, property_label, tr
from .collapsible import Box
from .edit_panel import EditPanel
from .job_handles import handles_of
from .operation_form import OperationForm
from .choices import offer
from .property_panel import MAKERS, PropertyPanel, candidates
from .setting_rows import SettingRows
from .tool_table import ToolTable
from .zero_places import place_at


class SetupPanel(EditPanel):
    def __init__(self, obj):
        super().__init__(obj, tr("CAM job"))
        self.task, self.operation_form, self.machine_rows = None, None, None
        self.widgets, self.handles, self.view = {}, None, PartView(self.document)
        self.layout.setSpacing(3)
        self._plan_row()
        for make in (self._part, self._stock, self._tools, self._operations, self._machine):
            self.layout.addWidget(make())
        self.layout.addStretch()
        self.timer = QtCore.QTimer(self.form)
        self.timer.timeout.connect(self._look)
        self.form.destroyed.connect(self.remove_handles)
        self._refresh()

    def take_over(self):
        """Does nothing: each change is written to the object at once."""

    # Boxes of the stack.
    def _part(self):
        box = Box(tr("Part"), tip=tr("The part, and the program's zero on it"))
        form = QtWidgets.QFormLayout()
        self.part = QtWidgets.QComboBox()
        for candidate in candidates(self.obj):
            self.part.addItem(candidate.Label, candidate.Name)
        self.part.setCurrentIndex(self.part.findData(self.obj.Part.Name) if self.obj.Part else -1)
        self.part.activated.connect(lambda index: self._set("Part", self.document.getObject(self.part.itemData(index))))
        form.addRow(tr("Part"), self.part)
        self.zero, pick = self._choice("Zero", write=self._choose_zero), QtWidgets.QPushButton(tr("Pick"))
        row = QtWidgets.QHBoxLayout()
        pick.setToolTip(tr("Click a corner, the middle of an edge or face, or a hole of the part in the 3D view"))
        pick.setAutoDefault(False)
        pick.clicked.connect(self.pick_zero)
        row.addWidget(self.zero, 1)
        row.addWidget(pick)
        form.addRow(tr("Zero"), row)
        box.body.addLayout(form)
        self.zero_rows = QtWidgets.QFormLayout()
        box.body.addLayout(self.zero_rows)
        box.button.toggled.connect(lambda on: self._make_handles())
        self.part_box = box
        self._fill_zero()
        return box

    def _fill_zero(self):
        while self.zero_rows.rowCount():
            self.zero_rows.removeRow(0)
        if self.obj.Zero == "point":
            self._add_row(self.zero_rows, "ZeroPoint")

    def _choose_zero(self, name, kind):
        if kind == "point" and self.obj.Part is not None:  # it begins where the zero was
            self.obj.ZeroPoint = cam_setup.zero_of(self.obj)
        self._set(name, kind)
        self._fill_zero()

    def set_zero(self, point):
        """Sets the program's zero to a point of the document."""
        self.obj.Zero, self.obj.ZeroPoint = "point", point
        self.zero.setCurrentIndex(self.zero.findData("point"))
        self._fill_zero()
        self._refresh()

    def pick_zero(self):
        """Takes the next click in the 3D view that is near a place of the part as the zero."""
        if self.obj.Part is None:
            return self.say(tr("Choose a part first"))
        self.view.tell_clicks(self._picked)
        self.say(tr("Click a corner, the middle of an edge or face, or a hole of the part"), True)

    def _picked(self, origin, direction):
        place = place_at(self.obj.Part, origin, direction)
        if place is None:
            return self.say(tr("There is no corner, middle or hole of the part: click again"))
        self.view.tell_clicks(None)
        self.say("", True)
        self.set_zero(place)

    def _stock(self):
        box = Box(tr("Stock"), opened=False)
        self.stock_rows = QtWidgets.QFormLayout()
        box.body.addLayout(self.stock_rows)
        self.stock_box = box
        box.button.toggled.connect(lambda on: self._make_handles())
        self._fill_stock()
        return box

    def _fill_stock(self):
        while self.stock_rows.rowCount():
            self.stock_rows.removeRow(0)
        kinds = self._choice("StockFrom", lambda: QtCore.QTimer.singleShot(0, self._fill_stock))
        self.stock_rows.addRow(tr("From"), kinds)
        for name in cam_setup.STOCKS[self.obj.StockFrom]:
            self._add_row(self.stock_rows, name)

    def _add_row(self, rows, name):
        """Adds a row for a property, which is written at each change."""
        widget, write = MAKERS[self.obj.getTypeIdOfProperty(name)](self, name)
        widget.setToolTip(tr(self.obj.getDocumentationOfProperty(name), PROPERTY))
        for number in [widget, *widget.findChildren(QtWidgets.QAbstractSpinBox)]:
            for signal in ("valueChanged", "editingFinished"):  # FreeCAD's box emits only the latter
                if hasattr(number, signal):
                    getattr(number, signal).connect(lambda *value, write=write: self._written(write))
        if hasattr(widget, "activated"):
            widget.activated.connect(lambda index, write=write: self._written(write))
        rows.addRow(property_label(name), widget)
        self.widgets[name] = widget

    def set_length(self, name, value):
        """Changes a length as if it was typed."""
        self.widgets[name].setProperty("rawValue", value)
        self._set(name, value)

    def set_corner(self, name, axis, value):
        """Changes a coordinate of a corner as if it was typed."""
        self.widgets[name].findChildren(QtWidgets.QDoubleSpinBox)[axis].setValue(value)

    _write_quantity = PropertyPanel._write_quantity

    def changed(self, *_):
        """Does nothing. The row makers of PropertyPanel call it, but here _written writes the rows, and planning starts
        only on request."""

    def _tools(self):
        box = Box(tr("Tools"), opened=not self.obj.Tools)
        self.tools = ToolTable(self.obj, self._refresh)
        box.body.addWidget(self.tools)
        self.tools_box = box
        return box

    def _operations(self):
        box = Box(tr("Operations"))
        self.list = QtWidgets.QListWidget()
        self.list.setFixedHeight(92)
        self.list.currentRowChanged.connect(lambda row: self._show_operation())
        self.list.itemDoubleClicked.connect(lambda item: self._show_operation())
        box.body.addWidget(self.list)
        row = QtWidgets.QHBoxLayout()
        self.add_button = QtWidgets.QPushButton(tr("Add"))
        menu = QtWidgets.QMenu(self.add_button)
        for kind in workflow.operation_names():
            stage = workflow.stages_of(kind)[-2]
            action = menu.addAction(stage.label)
            action.setToolTip(stage.tip)
            action.triggered.connect(lambda checked=False, kind=kind: self.add_operation(kind))
        menu.setToolTipsVisible(True)
        self.add_button.setMenu(menu)
        row.addWidget(self.add_button)
        for words, tip, action in ((tr("Remove"), tr("The chosen operation"), self.remove_operation),
                                   ("\u2191", tr("Earlier"), lambda: self.move(-1)),
                                   ("\u2193", tr("Later"), lambda: self.move(1))):
            button = QtWidgets.QPushButton(words)
            button.setToolTip(tip)
            if len(words) == 1:
                button.setMaximumWidth(36)
            button.clicked.connect(action)
            row.addWidget(button)
        box.body.addLayout(row)
        self.chosen_place = QtWidgets.QVBoxLayout()
        box.body.addLayout(self.chosen_place)
        self.operations_box = box
        self._list_operations()
        return box

    def _machine(self):
        box = Box(tr("Machine"))
        form = QtWidgets.QFormLayout()
        self.machine = QtWidgets.QComboBox()
        for identifier, name in workflow.machines().items():
            self.machine.addItem(kernel_text(name), identifier)
        self.machine.setCurrentIndex(self.machine.findData(self.obj.Machine))
        self.machine.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.machine.activated.connect(lambda index: self.choose_machine(self.machine.itemData(index)))
        form.addRow(tr("Machine"), self.machine)
        self.material = QtWidgets.QComboBox()
        self.material.activated.connect(lambda index: self._set("Material", self.material.itemData(index)))
        form.addRow(tr("Material"), self.material)
        box.body.addLayout(form)
        self.limits = QtWidgets.QLabel()
        self.limits.setWordWrap(True)
        self.limits.setStyleSheet("color: gray")
        box.body.addWidget(self.limits)
        self.machine_place = QtWidgets.QVBoxLayout()
        box.body.addLayout(self.machine_place)
        self.machine_box = box
        self._fill_machine()
        return box

    def _fill_machine(self):
        if self.machine_rows is not None:
            self.machine_rows.deleteLater()
        told = workflow.machine(self.obj.Machine)
        self.machine_rows = SettingRows(self.obj, workflow.machine_stage(self.obj.Machine), self._refresh)
        self.machine_place.addWidget(self.machine_rows)
        offer(self.material, self.obj.getEnumerationsOfProperty("Material"), self.obj.Material)
        self.material.setEnabled(self.material.count() > 1)
        known = ([tr("travel {travel}").format(travel=units.told_all(told["travel"], digits=6))]
                 if any(told["travel"]) else [])
        known += [tr("up to {limit}").format(limit=units.told(told[name], unit, 6))
                  for name, unit in (("max_feed", "mm/min"), ("max_spindle", "rpm")) if told[name]]
        known += [tr("turns about {axes}").format(axes=f" {tr('and')} ".join(told["axes"]))] if told["axes"] else []
        self.limits.setText("; ".join([kernel_text(told["description"]), *known]))

    def _plan_row(self):
        row = QtWidgets.QHBoxLayout()
        self.plan_button = QtWidgets.QPushButton(tr("Plan"))
        self.plan_button.setToolTip(tr("Plans all paths in the background"))
        self.plan_button.clicked.connect(lambda: self.stop() if self.task else self.plan())
        self.bar = QtWidgets.QProgressBar()
        self.planned = work.Gauge(self.bar)
        self.bar.setTextVisible(False)
        self.adjust_feeds = QtWidgets.QCheckBox(tr("Adjust feeds to the cut"))
        self.adjust_feeds.setToolTip(tr(self.obj.getDocumentationOfProperty("AdjustFeeds"), PROPERTY))
        self.adjust_feeds.setChecked(self.obj.AdjustFeeds)
        self.adjust_feeds.toggled.connect(lambda on: self._set("AdjustFeeds", on))
        self.layout.addWidget(self.adjust_feeds)
        row.addWidget(self.plan_button)
        row.addWidget(self.bar, 1)
        self.layout.addLayout(row)
        self.outcome = QtWidgets.QLabel()
        self.outcome.setWordWrap(True)
        self.outcome.hide()
        self.message.hide()
        self.layout.addWidget(self.outcome)
        self.layout.addWidget(self.message)

    def say(self, text, good=False):
        super().say(text, good)
        self.message.setVisible(bool(text))

    def _report(self, text):
        self.outcome.setText(units.in_words(text))
        self.outcome.setVisible(bool(text))

    # Actions of the widgets.
    def _choice(self, name, then=lambda: None, write=None):
        box = QtWidgets.QComboBox()
        offer(box, self.obj.getEnumerationsOfProperty(name), getattr(self.obj, name))
        box.setToolTip(tr(self.obj.getDocumentationOfProperty(name), PROPERTY))
        box.activated.connect(lambda index: ((write or self._set)(name, box.itemData(index)), then()))
        return box

    def _set(self, name, value):
        setattr(self.obj, name, value)
        self._refresh()

    def _written(self, write):
        write()
        self._refresh()

    def choose_machine(self, identifier):
        self.obj.Machine = identifier
        self._fill_machine()
        self._refresh()

    def chosen(self):
        row = self.list.currentRow()
        return self.obj.Operations[row] if 0 <= row < len(self.obj.Operations) else None

    def _list_operations(self, row=0):
        self.list.blockSignals(True)
        self.list.clear()
        for operation in self.obj.Operations:
            item = QtWidgets.QListWidgetItem(operation.Label, self.list)
            if not operation.Active:
                item.setForeground(QtCore.Qt.gray)
        self.list.setCurrentRow(min(row, len(self.obj.Operations) - 1))
        self.list.blockSignals(False)
        self._show_operation()

    def _show_operation(self):
        if self.operation_form is not None:
            self.operation_form.hide()
            self.operation_form.deleteLater()
            self.operation_form = None
        if self.chosen() is not None:
            self.operation_form = OperationForm(self.chosen(), self._refresh)
            self.chosen_place.addWidget(self.operation_form)

    def add_operation(self, kind):
        cam_operation.add(self.obj, kind)
        self._list_operations(len(self.obj.Operations) - 1)
        self._refresh()

    def remove_operation(self):
        if self.chosen() is not None:
            row = self.list.currentRow()
            cam_setup.remove(self.obj, self.chosen())
            self._list_operations(max(0, row - 1))
            self._refresh()

    def move(self, by):
        row = self.list.currentRow()
        operations = list(self.obj.Operations)
        if 0 <= row < len(operations) and 0 <= row + by < len(operations):
            operations.insert(row + by, operations.pop(row))
            self.obj.Operations = operations
            self._list_operations(row + by)
            self._refresh()

    def _refresh(self):
        """Updates the hints of the boxes, and whether the plan is up to date."""
        for place, operation in enumerate(self.obj.Operations):
            if self.list.item(place):
                self.list.item(place).setText(operation.Label)
        self.part_box.hint.setText(self.obj.Part.Label if self.obj.Part else tr("none yet"))
        count = len(self.obj.Tools)
        self.tools_box.hint.setText(tr("none yet") if not count else self.obj.Tools[0].Label if count == 1
                                    else tr("{count} tools").format(count=count))
        self.operations_box.hint.setText(f"{len(self.obj.Operations)}" if self.obj.Operations else tr("none yet"))
        self.machine_box.hint.setText(self.obj.Machine)
        try:
            lower, upper = cam_setup.stock_box(self.obj)
            self.stock_box.hint.setText(units.told_all(upper - lower))
        except ValueError:
            self.stock_box.hint.setText("")
        self.machine_rows.refresh()
        if self.operation_form is not None:
            self.operation_form.refresh()
        self._make_handles()
        self._tell()

    # Arrows in the 3D view.
    def _make_handles(self):
        """Makes the arrows anew, unless one of them is being dragged."""
        if self.machine_rows is None:  # the boxes are still being made
            return
        if self.handles and self.handles.dragged():
            self.handles.refresh()
            return
        self.remove_handles()
        self.handles = handles_of(self)

    def remove_handles(self, *_):
        if self.handles:
            self.handles.close()
        self.handles = None

    def close(self):
        self.view.tell_clicks(None)
        self.remove_handles()
        super().close()

    # Planning.
    def program(self):
        return next(iter(cam_setup.programs_of(self.obj)), None)

    def plan(self):
        """Starts planning in the background."""
        self.say("", True)
        try:
            self.job = cam_job.Job(self.obj)
        except ValueError as error:
            return self._complain(error)
        self.task = work.Task(self.job.plan)
        self.task.start()
        self.plan_button.setText(tr("Stop"))
        self.timer.start(50)

    def stop(self):
        if self.task:
            self.task.cancel()

    def _look(self):
        task = self.task
        self.planned.show(task.fraction)
        if task.is_alive():
            self._report(tr("Planning: {message}").format(message=task.message) if task.message else tr("Planning"))
            return
        self.timer.stop()
        self.task = None
        self.plan_button.setText(tr("Plan"))
        self.planned.stop()
        try:
            plan = task.outcome()
        except work.Cancelled:
            self.say(tr("stopped; the program is unchanged"))
        except (ValueError, kernel.load().Error) as error:
            self._complain(error)
        else:
            program = self.program() or machine_program.create(self.obj)
            machine_program.take(program, plan)
        self._tell()

    def _complain(self, error):
        """Shows an error at its setting if known, otherwise below the stack."""
        operation = self.document.getObject(getattr(error, "object", None) or "")
        setting = getattr(error, "setting", "")
        said = False
        if operation in self.obj.Operations:
            self.list.setCurrentRow(self.obj.Operations.index(operation))
            said = self.operation_form is not None and self.operation_form.say(setting, str(error))
        elif operation == self.obj and setting in self.machine_rows.rows:
            self.machine_box.open()
            self.machine_rows.rows[setting].say(str(error))
            said = True
        words, label = str(error), ""
        if operation is not None:
            label = f"{operation.Label}: "
            words = words.removeprefix(label).removeprefix(f"{getattr(operation, 'Type', '')}: ")
        self.say(label + (tr("{setting}: see above").format(setting=setting) if said else words))

    def _tell(self):
        """Shows time, lengths and notes of the plan."""
        program = self.program()
        if self.task or program is None or not program.MadeFrom:
            if not self.task:
                self._report("")
            return
        try:
            current = program.MadeFrom == cam_job.Job(self.obj).digest
        except ValueError:
            current = False
        about = tr("About {time}").format(time=machine_program.clock(program.Seconds))
        if self.obj.AdjustFeeds and program.PlannedSeconds > program.Seconds:
            about += "; " + tr("{time} with the planned feeds").format(
                time=machine_program.clock(program.PlannedSeconds))
        lines = [f"<b>{about}</b>" + ("" if current else f" <span style='color:gray'>{tr('(changed since)')}</span>"),
                 *map(_escaped, program.Reports),
                 *(f"<span style='color:#8a5a00'>{_escaped(translated(note))}</span>" for note in program.Notes)]
        self._report("<br>".join(lines))

    # FreeCAD's interface of a task panel.
    def accept(self):
        self.stop()
        return super().accept()

    def reject(self):
        self.stop()
        self.timer.stop()
        return super().reject()


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")
