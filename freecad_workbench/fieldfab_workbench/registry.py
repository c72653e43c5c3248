"""The views and the panels of the kinds of objects, for the layers below views and panels, which do not import these.

A kind is named by its class. InitGui.py fills the registry at FreeCAD's start; without a window it stays empty.
It imports nothing itself."""

_tables = {}  # {name of the table: function that returns it, {name of a class: what belongs to it}}


def fill(views, panels):
    """Two functions, called at each question: views() returns {kind: class of its view provider}, panels() returns
    {kind: function that makes the panel of an object}."""
    _tables.update(views=views, panels=panels)


def add_view(obj):
    """Gives a new object its view provider; without a window it has none."""
    if _tables:
        _found("views", obj)(obj.ViewObject)


def panel_for(obj):
    """The panel that edits an object."""
    return _found("panels", obj)(obj)


def _found(table, obj):
    """What a table has for the class of an object's proxy, else for the nearest class that this one derives from.
    Raises KeyError where it has neither."""
    entries = _tables[table]()
    for kind in type(obj.Proxy).__mro__:
        if kind.__name__ in entries:
            return entries[kind.__name__]
    raise KeyError(f"no {table} of {type(obj.Proxy).__name__}")
