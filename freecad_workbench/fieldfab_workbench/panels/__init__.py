"""The task panels."""


def panel_for(obj):
    """The panel that edits an object."""
    from ..objects.frep_solid import FrepSolid

    if isinstance(obj.Proxy, FrepSolid):
        from .frep_panel import FrepPanel

        return FrepPanel(obj)
    if obj.Proxy.NAME == "Scan":
        from .scan_panel import ScanPanel

        return ScanPanel(obj)
    from .property_panel import PropertyPanel

    return PropertyPanel(obj)
