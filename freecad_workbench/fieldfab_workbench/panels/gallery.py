"""Shape gallery: pictures of the library's shapes and of the designs, searchable by words. A chosen shape is inserted
into a text with its parameters."""

from .. import shapes
from ..shim import QtCore, QtGui, QtWidgets
from ..words import marked, tr
from .wheel import WheelGuard

ALL = marked("All")
THUMBNAIL = QtCore.QSize(112, 96)
SHAPE = QtCore.Qt.UserRole


class Gallery(QtWidgets.QDialog):
    """Emits `inserted(text)` with the text to insert: a call, or with `whole` a complete text for a new solid."""

    inserted = QtCore.Signal(str)

    def __init__(self, parent=None, whole=False):
        super().__init__(parent)
        self.whole, self.shapes, self.chosen, self.boxes, self.icons = whole, shapes.shapes(), None, {}, {}
        self.setWindowTitle(tr("Shape gallery"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(940, 600)
        columns = QtWidgets.QHBoxLayout(self)
        columns.addLayout(self._groups())
        columns.addLayout(self._pictures(), 1)
        columns.addWidget(self._details())
        self.wheel = WheelGuard(self)
        self._fill()

    # Left: groups.
    def _groups(self):
        column = QtWidgets.QVBoxLayout()
        self.groups = QtWidgets.QListWidget()
        for group in (ALL, *dict.fromkeys(shape.group for shape in self.shapes)):
            QtWidgets.QListWidgetItem(tr(group), self.groups).setData(SHAPE, group)
        self.groups.setFixedWidth(self.groups.sizeHintForColumn(0) + 24)
        self.groups.setCurrentRow(0)
        self.groups.currentRowChanged.connect(lambda row: self._fill())
        column.addWidget(self.groups)
        return column

    # Middle: pictures.
    def _pictures(self):
        column = QtWidgets.QVBoxLayout()
        self.search = QtWidgets.QLineEdit()
        self.search.setPlaceholderText(tr("Search: a name, or what it does"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(lambda text: self._fill())
        self.pictures = QtWidgets.QListWidget()
        self.pictures.setViewMode(QtWidgets.QListView.IconMode)
        self.pictures.setResizeMode(QtWidgets.QListView.Adjust)
        self.pictures.setMovement(QtWidgets.QListView.Static)
        self.pictures.setIconSize(THUMBNAIL)
        self.pictures.setGridSize(THUMBNAIL + QtCore.QSize(14, 44))
        self.pictures.setWordWrap(True)
        self.pictures.currentItemChanged.connect(lambda item, before: self._show(item.data(SHAPE)) if item else None)
        self.pictures.itemDoubleClicked.connect(lambda item: self.insert())
        column.addWidget(self.search)
        column.addWidget(self.pictures)
        return column

    def _fill(self):
        """Shows the shapes of the group that match all words. A search covers all groups."""
        words, group = self.search.text().lower().split(), self.groups.currentItem().data(SHAPE)
        self.pictures.clear()
        for shape in self.shapes:
            said = f"{shape.name} {shape.name.replace('_', ' ')} {shape.group} {shape.meaning}".lower()
            if all(word in said for word in words) and (words or group in (ALL, shape.group)):
                item = QtWidgets.QListWidgetItem(self._icon(shape), shape.name.replace("_", " "), self.pictures)
                item.setSizeHint(self.pictures.gridSize())
                item.setToolTip(f"{shape.signature}\n{shape.meaning}")
                item.setData(SHAPE, shape)
        if self.pictures.count():
            self.pictures.setCurrentRow(0)

    def _icon(self, shape):
        """Returns the shape's picture, scaled to a common size so that the names align."""
        if shape.name not in self.icons:
            canvas = QtGui.QPixmap(THUMBNAIL)
            canvas.fill(QtCore.Qt.transparent)
            picture = QtGui.QPixmap(shape.picture or "")
            if not picture.isNull():
                picture = picture.scaled(THUMBNAIL, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
                painter = QtGui.QPainter(canvas)
                painter.drawPixmap((THUMBNAIL.width() - picture.width()) // 2, THUMBNAIL.height() - picture.height(),
                                   picture)
                painter.end()
            self.icons[shape.name] = QtGui.QIcon(canvas)
        return self.icons[shape.name]

    # Right: the chosen shape.
    def _details(self):
        side = QtWidgets.QWidget()
        side.setFixedWidth(270)
        column = QtWidgets.QVBoxLayout(side)
        column.setContentsMargins(4, 0, 0, 0)
        self.picture = QtWidgets.QLabel(alignment=QtCore.Qt.AlignCenter)
        self.picture.setFixedHeight(200)
        self.name, self.meaning = QtWidgets.QLabel(), QtWidgets.QLabel()
        for label in (self.name, self.meaning):
            label.setWordWrap(True)
            label.setTextFormat(QtCore.Qt.PlainText)
        font = self.name.font()
        font.setBold(True)
        self.name.setFont(font)
        self.form = QtWidgets.QFormLayout()
        self.button = QtWidgets.QPushButton(tr("Make this solid") if self.whole else tr("Insert at the cursor"))
        self.button.setDefault(True)
        self.button.clicked.connect(self.insert)
        closing = QtWidgets.QPushButton(tr("Close"))
        closing.setAutoDefault(False)
        closing.clicked.connect(self.close)
        for widget in (self.picture, self.name, self.meaning):
            column.addWidget(widget)
        column.addLayout(self.form)
        column.addStretch()
        column.addWidget(self.button)
        column.addWidget(closing)
        return side

    def _show(self, shape):
        self.chosen = shape
        pixmap = QtGui.QPixmap(shape.picture or "")
        if not pixmap.isNull():
            pixmap = pixmap.scaled(250, 196, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
        self.picture.setPixmap(pixmap)
        self.name.setText(shape.signature)
        self.meaning.setText(shape.meaning)
        while self.form.rowCount():
            self.form.removeRow(0)
        self.boxes = {name: self._box(value) for name, value in shape.values.items()}
        for name, box in self.boxes.items():
            default = shape.defaults.get(name)
            box.setToolTip(tr("default: {default}").format(default=default) if default
                           else tr("a number, a shape, or any formula"))
            self.form.addRow(tr("values") if name == "…" else name, box)

    @staticmethod
    def _box(value):
        if not shapes.is_number(value):
            return QtWidgets.QLineEdit(value)
        box = QtWidgets.QDoubleSpinBox()
        box.setRange(-1e6, 1e6)
        box.setDecimals(3)
        box.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)
        box.setValue(float(value))
        return box

    def values(self):
        return {name: f"{box.value():.6g}" if isinstance(box, QtWidgets.QDoubleSpinBox) else box.text().strip()
                for name, box in self.boxes.items()}

    def insert(self):
        if self.chosen:
            self.inserted.emit(self.chosen.solid(self.values()) if self.whole else self.chosen.call(self.values()))
            if self.whole:
                self.close()
