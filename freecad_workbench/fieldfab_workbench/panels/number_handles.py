"""Arrows in the 3D view for the numbers of a formula: of its parameters, and of the line with the cursor."""

import FreeCAD

from .. import kernel, work
from ..frep_language import Places, with_values
from ..shim import QtCore, QtGui
from ..views.handles import COLOUR, Handle, Handles
from ..words import tr
from .property_handles import AXES, COLOURS

MOST = 8  # arrows at a time, unless they are asked for by the cursor
ALONG = 0.999  # least cosine of an arrow and the axis whose colour it has
TICK = 50  # ms between looks at the text and at the background work


class NumberHandles:
    """The arrows of an FrepPanel. They are found anew, in the background, when the text or a parameter has changed.
    Dragging one writes the number into the text, or into the row of its parameter."""

    def __init__(self, panel):
        self._panel, self._editor = panel, panel.text
        self._task, self._wanted = None, None
        self.found, self.handles = [], None  # fieldfab.handles.Handle of the text's numbers; views.handles.Handles
        self._diagonal, self._dragged = 0.0, None  # number that is being dragged
        self._editor.cursorPositionChanged.connect(self._show)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(TICK)
        panel.form.destroyed.connect(self.close)

    def close(self, *_):
        self._timer.stop()
        self._wanted = None  # the cursor may still move while the editor goes
        if self._task:
            self._task.cancel()
        self._remove()

    def _remove(self):
        if self.handles:
            self.handles.close()
        self.handles = None

    # Finding them.
    def _text(self):
        """Returns the text with the numbers of the rows: its numbers are the same ones in the same order."""
        return with_values(self._editor.toPlainText(), {name: row.value() for name, row in self._panel.rows.items()})

    def _look(self):
        if self.handles and self.handles.dragged():
            return
        self._dragged = None
        if self._task and not self._task.is_alive():
            task, self._task = self._task, None
            self.found, self._diagonal = task.result if task.error is None else ([], 0.0)
            self._show()
        text = None if self._editor.message else self._text()
        if text != self._wanted and self._task is None:
            self._wanted = text
            if text is not None:
                self._task = work.Task(lambda progress: _find(text, progress))
                self._task.start()
        elif text != self._wanted:
            self._task.cancel()

    # Showing them.
    def _show(self):
        if self.handles and self.handles.dragged():
            return
        chosen = self._chosen()
        self._remove()
        if chosen and self._wanted is not None:
            self.handles = Handles(self._panel.document, [self._handle(each) for each in chosen], self._diagonal)

    def _chosen(self):
        """Returns the arrows that are shown: all if there are few; otherwise those of the cursor's line or, if it has
        none, those of parameters."""
        rows = self._panel.rows
        usable = [each for each in self.found if each.number.name not in rows or rows[each.number.name].isEnabled()]
        if len(usable) <= MOST:
            return usable
        numbers, places = self._numbers(), Places(self._editor.toPlainText())
        line = self._editor.textCursor().blockNumber()
        here = [each for each in usable if each.index < len(numbers) and self._editor.document().findBlock(
            places.unit(numbers[each.index].offset)).blockNumber() == line]
        return here or [each for each in usable if each.number.name][:MOST]

    def _numbers(self):
        return _handles_of_kernel().numbers(self._editor.toPlainText())

    def _handle(self, found):
        place = self._panel.obj.getGlobalPlacement()
        along, value = FreeCAD.Vector(*found.along), [found.number.value]
        start = place.multVec(FreeCAD.Vector(*found.at) - along * found.number.value * found.rate)
        row = self._panel.rows.get(found.number.name)

        def write(number):
            value[0] = number
            if row:
                row.box.setValue(number)
            else:
                self._write(found.index, number)
            self._panel.say(tr("{name} is {value}").format(
                name=found.number.name or tr("The number"), value=f"{number:g}"), True)

        along = place.Rotation.multVec(along)
        colour = next((colour for axis, colour in zip(AXES, COLOURS) if abs(axis * along) > ALONG), COLOUR)
        return Handle(lambda: start, along, row.value if row else lambda: value[0], write, colour, found.rate)

    def _write(self, index, value):
        """Replaces a number of the text and selects it; undo takes a whole drag back."""
        text = self._editor.toPlainText()
        number, places = self._numbers()[index], Places(text)
        written = _handles_of_kernel().written(value)
        start, cursor = places.unit(number.offset), self._editor.textCursor()
        cursor.joinPreviousEditBlock() if self._dragged == index else cursor.beginEditBlock()
        cursor.setPosition(start)
        cursor.setPosition(places.unit(number.offset + number.length), QtGui.QTextCursor.KeepAnchor)
        cursor.insertText(written)
        cursor.endEditBlock()
        cursor.setPosition(start)
        cursor.setPosition(start + len(written), QtGui.QTextCursor.KeepAnchor)
        self._dragged = index
        self._editor.setTextCursor(cursor)


def _handles_of_kernel():
    kernel.load()
    from fieldfab import handles

    return handles


def _find(text, progress):
    """Returns the handles of a text's numbers and the diagonal of its solid, mm."""
    found = _handles_of_kernel().handles(text, progress=progress)
    box = kernel.load().parse(text).bounds() if found else None
    return (found, FreeCAD.Vector(*box[3:]).distanceToPoint(FreeCAD.Vector(*box[:3]))) if box else ([], 0.0)
