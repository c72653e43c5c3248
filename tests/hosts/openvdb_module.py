"""OpenVDB's Python module, which was called pyopenvdb before OpenVDB 11."""

try:
    import openvdb
except ImportError:
    import pyopenvdb as openvdb

__all__ = ["openvdb"]
