"""The views and the panels of the kinds of objects, for the layers below views and panels, which do not import these.

A kind is named by its class. InitGui.py fills the registry at FreeCAD's start; without a window it stays empty. It imports nothing itself."""

_tables = {}  # {name of the table: function that returns it, {name of a class: what belongs to it}}


def fill(views, panels):
    """Two functions, called whenever one is asked for: views() returns {kind: class of its view provider}, panels() {kind: function of an object that
    returns the panel that edits it}."""
    _tables.update(views=views, panels=panels)


def add_view(obj):
    """Gives a new object its view provider; without a window it has none."""
    if _tables:
        _found("views", obj)(obj.ViewObject)


def panel_for(obj):
    """The panel that edits an object."""
    return _found("panels", obj)(obj)


def _found(table, obj):
    """What a table has for the class of an object's proxy, else for the nearest class that this one derives from. Raises KeyError."""
    entries, kinds = _tables[table](), [each.__name__ for each in type(obj.Proxy).__mro__]
    return entries[next((kind for kind in kinds if kind in entries), kinds[0])]
