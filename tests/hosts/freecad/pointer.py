"""The real pointer, for tests in FreeCAD's window: xdotool moves it, turns its wheel and presses its buttons."""

import subprocess

from window import live

from fieldfab_workbench.shim import QtCore, QtWidgets
from fieldfab_workbench.views import handles
from fieldfab_workbench.views.part_view import PartView


def _at(widget, place=None):
    at = widget.mapToGlobal(place or widget.rect().center())
    scale = widget.devicePixelRatioF()
    return str(round(at.x() * scale)), str(round(at.y() * scale))


def _xdotool(*words):
    subprocess.run(["xdotool", *words], check=True, timeout=20)
    live(0.15)


def turn_wheel(widget, notches=-3, place=None):
    """Turns the wheel over a widget; negative notches are towards the user."""
    _xdotool("mousemove", *_at(widget, place), "click", "--repeat", str(abs(notches)), "--delay", "5",
             "4" if notches > 0 else "5")


def click(widget, place=None, held=None):
    """Clicks a widget, with a key held down."""
    keys = ([f"key{way}", held] if held else [] for way in ("down", "up"))
    _xdotool("mousemove", *_at(widget, place), *next(keys), "click", "1", *next(keys))


def drag(widget, begin, end, steps=8):
    """Drags with the left button between two points of a widget."""
    _xdotool("mousemove", *_at(widget, begin), "mousedown", "1")
    for step in range(1, steps + 1):
        _xdotool("mousemove", *_at(widget, begin + (end - begin) * step / steps))
    _xdotool("mouseup", "1")


def drag_arrow(document, arrows, number, by):
    """Drags one of a panel's arrows (views.handles.Handles) by `by` mm along its way. An arrow under the panel, which
    FreeCAD 1.1 lays over the view, is moved beside it first."""
    handle, view = arrows.arrows[number][0], PartView(document)
    away = handle.read() * handle.rate + handles.GRIP * arrows.size
    place = handle.start() + handle.along * away
    if not _is_free(view.widget(), point_of(view, place)):
        view.look_at(place)
        live(0.3)
        assert _is_free(view.widget(), point_of(view, place)), "the panel covers the middle of the view"
    drag(view.widget(), *(point_of(view, place + handle.along * way) for way in (0, by)))
    live(0.4)


def point_of(view, place):
    """Returns the point of a PartView's widget where a place is seen."""
    widget, (x, y) = view.widget(), view.pixel_of(place)
    scale = view.view.getSize()[0] / widget.width()  # screen pixels per Qt pixel
    return QtCore.QPoint(round(x / scale), round(widget.height() - y / scale))


def _is_free(widget, point):
    """Whether no other widget lies over a point of a view's widget."""
    return QtWidgets.QApplication.widgetAt(widget.mapToGlobal(point)) in (widget, widget.viewport())


def type_text(text):
    """Types into the widget with the focus."""
    _xdotool("type", "--delay", "10", text)


def is_seen(widget):
    """Whether the pointer can reach the centre of a widget."""
    return widget.isVisible() and widget.visibleRegion().contains(widget.rect().center()) and QtCore.QRect(
        0, 0, 1400, 860).contains(widget.mapToGlobal(widget.rect().center()))
