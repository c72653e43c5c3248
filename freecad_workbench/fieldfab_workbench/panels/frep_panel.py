"""Task panel of an f-rep solid: its text, parameters, resolution and preview."""

from .. import kernel, preferences, units
from ..certainty import is_uncertain, with_doubt
from ..frep_language import with_values
from ..objects.frep_solid import property_name
from ..shim import QtWidgets
from ..views.preview import Preview
from ..words import tr
from .edit_panel import EditPanel
from .frep_editor import FrepEditor
from .gallery import Gallery
from .measures import MeasureBox
from .number_handles import NumberHandles
from .parameter_rows import ParameterRow


class FrepPanel(EditPanel):
    """The panel of a solid that is written as a text, which the object's proxy understands."""

    def __init__(self, obj):
        super().__init__(obj, self.title())
        self.text = self.editor(self._object_text())
        self.text.setMinimumHeight(200)
        self.layout.addWidget(self._tools())
        self.layout.addWidget(self.text, 1)
        self.layout.addWidget(self.message)
        if units.in_inches():
            self.layout.addWidget(QtWidgets.QLabel(tr("Numbers of the text are in mm")))
        self.sliders = QtWidgets.QFormLayout()
        self.layout.addLayout(self.sliders)
        self.layout.addLayout(self._resolution())
        self.rows, self.numbers = {}, {}  # {name: ParameterRow}, {name: parameter of the text}
        self.preview = Preview(obj, self._told, self.form)
        self.handles = self.arrows()
        self.text.checked.connect(self._checked)
        self.text.check()

    # What the kinds of texts have of their own.
    def title(self):
        return tr("F-rep solid")

    def editor(self, text):
        made = FrepEditor(text)
        made.setObjectName("FrepEditor")
        return made

    def arrows(self):
        """Returns the arrows in the 3D view, or None."""
        return NumberHandles(self)

    def valid(self, count):
        """Returns what is said about a valid text."""
        return tr("{count} operations").format(count=count)

    def _object_text(self):
        return getattr(self.obj, self.obj.Proxy.TEXT)

    def _tools(self):
        gallery = QtWidgets.QPushButton(tr("Insert a shape…"))
        gallery.setToolTip(tr("Choose a shape by its picture; it is inserted where the cursor is"))
        gallery.setAutoDefault(False)
        gallery.clicked.connect(self._open_gallery)
        return gallery

    def _open_gallery(self):
        self.gallery = Gallery(self.form)
        self.gallery.inserted.connect(self.text.insert)
        self.gallery.show()

    # Resolution and parameters.
    def _resolution(self):
        numbers = QtWidgets.QFormLayout()
        self.voxel = self._length(self.obj.VoxelSize.Value, self._default_cell())
        self.max_error = self._length(self.obj.MaxError.Value, tr("a tenth of the smallest cell"))
        numbers.addRow(tr("Smallest cell"), self.voxel)
        numbers.addRow(tr("Largest error"), self.max_error)
        for box in (self.voxel, self.max_error):
            box.valueChanged.connect(lambda value: self._show())
        return numbers

    @staticmethod
    def _default_cell():
        """Returns the default cell size as text. Without a preference the number comes from the kernel, which may be
        missing."""
        try:
            cells = preferences.cells() or round(kernel.load().default_cells)
        except ImportError:
            return tr("Automatic")
        return tr("1/{cells} of the longest side").format(cells=cells)

    @staticmethod
    def _length(value, zero):
        box = MeasureBox(value, zero=tr("automatic"))
        box.setToolTip(tr("0 is automatic: {zero}").format(zero=zero))
        return box

    def _follow_text(self):
        """Updates the rows to the parameters of the text. If a number has changed in the text, its row takes it, as the
        object will."""
        wanted = self.obj.Proxy.parameters(self.text.toPlainText())
        if [(n, p.range) for n, p in wanted.items()] != [(n, p.range) for n, p in self.numbers.items()]:
            kept = {name: row.value() for name, row in self.rows.items()}
            while self.sliders.rowCount():
                self.sliders.removeRow(0)
            self.rows = {name: self._row(each, kept.get(name, self._held(each))) for name, each in wanted.items()}
        for name, each in wanted.items():
            if name in self.numbers and self.numbers[name].value != each.value:
                self.rows[name].set(each.value)
        self.numbers = wanted

    def _held(self, parameter):
        """Returns the object's value of a parameter if its text has the same number, otherwise the text's number."""
        before = self.obj.Proxy.parameters(self.obj.FollowedText).get(parameter.name)
        same = before is not None and before.value == parameter.value
        return getattr(self.obj, property_name(parameter.name), parameter.value) if same else parameter.value

    def _row(self, parameter, value):
        name = parameter.name
        row = ParameterRow(value, parameter.range)
        row.changed.connect(lambda number: self._drive(name))
        driven = any(path == property_name(name) for path, expression in self.obj.ExpressionEngine)
        row.setEnabled(not driven)
        words = (tr("{name} is driven by an expression") if driven
                 else tr("Parameter {name} of the text, also a property of the object"))
        row.setToolTip("\n".join(filter(None, [parameter.comment, words.format(name=name)])))
        self.sliders.addRow(name, row)
        return row

    def _drive(self, name):
        """Writes a value to its property, if this exists already, and updates the preview."""
        if self.obj.FollowedText == self.text.toPlainText():
            setattr(self.obj, property_name(name), self.rows[name].value())
        self._show()

    # Preview.
    def _checked(self, count, mistake):
        if mistake:
            self.say(mistake)
            return
        known = self.obj.isValid() and self.text.toPlainText() == self._object_text() and is_uncertain(self.obj)
        self.say(*with_doubt(self.valid(count), self.obj.Certainty if known else ""))
        self._follow_text()
        self._show()

    def _show(self):
        """Previews the text with its parameter values, if it is valid."""
        if self.text.message:
            return
        source, settings = self._source(), self.obj.Proxy.mesh_settings(self.obj)
        for name, box in (("voxel", self.voxel), ("max_error", self.max_error)):
            settings.pop(name, None)
            if box.value():
                settings[name] = box.value()
        self.preview.show(source, settings)

    def _source(self):
        return self.obj.Proxy.source_of_text(self.written())

    def written(self):
        """Returns the text with the values of its rows."""
        return with_values(self.text.toPlainText(), {name: row.value() for name, row in self.rows.items()})

    def _told(self, words, good):
        if not self.text.message:
            self.say(words, good)

    def take_over(self):
        self.text.check()
        if self._object_text() != self.text.toPlainText():
            setattr(self.obj, self.obj.Proxy.TEXT, self.text.toPlainText())
        for name, row in self.rows.items():
            held = property_name(name)
            if held in self.obj.PropertiesList and row.isEnabled() and getattr(self.obj, held) != row.value():
                setattr(self.obj, held, row.value())
        self.obj.VoxelSize, self.obj.MaxError = self.voxel.value(), self.max_error.value()

    def close(self):
        self.preview.close()
        if self.handles:
            self.handles.close()
        super().close()
