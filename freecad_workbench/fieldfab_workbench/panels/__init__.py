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
    from ..objects.simulation import Simulation

    if isinstance(obj.Proxy, Simulation):
        from .simulation_panel import SimulationPanel

        return SimulationPanel(obj)
    setup = _setup_of(obj)
    if setup is not None:
        from .cam_setup_panel import SetupPanel

        return SetupPanel(setup)
    if obj.Proxy.NAME == "CamOperation":
        from .cam_operation_panel import OperationPanel

        return OperationPanel(obj)
    from .property_panel import PropertyPanel

    return PropertyPanel(obj)


def _setup_of(obj):
    """The CAM set-up whose panel edits an object: a set-up, its tools and its programs."""
    from ..objects import cam_setup

    if obj.Proxy.NAME == "CamTool":
        return cam_setup.setup_of(obj)
    return obj.Setup if obj.Proxy.NAME == "MachineProgram" else obj if cam_setup.is_setup(obj) else None
