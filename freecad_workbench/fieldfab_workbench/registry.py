"""View providers and panels for each kind of object. The lower layers use this registry, since they do not import views
and panels.

A kind is named by its class. InitGui.py fills the registry at FreeCAD's start; without a window it stays empty. This
module imports nothing."""

_tables = {}  # {table name: function that returns the table, {class name: entry}}


def fill(views, panels):
    """Sets the functions that return the tables; they are called at each lookup. views() returns {kind: view provider
    class}, panels() returns {kind: function that makes the panel of an object}."""
    _tables.update(views=views, panels=panels)


def add_view(obj):
    """Gives a new object its view provider; without a window, none."""
    if _tables:
        _found("views", obj)(obj.ViewObject)


def panel_for(obj):
    """Returns the panel that edits an object."""
    return _found("panels", obj)(obj)


def _found(table, obj):
    """Returns a table's entry for the class of an object's proxy, otherwise for its nearest base class. Raises KeyError
    if there is none."""
    entries = _tables[table]()
    for kind in type(obj.Proxy).__mro__:
        if kind.__name__ in entries:
            return entries[kind.__name__]
    raise KeyError(f"no {table} of {type(obj.Proxy).__name__}")
