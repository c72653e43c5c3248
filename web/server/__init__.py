"""fabserver's server: `python3 -m fieldfab.serve` (docs/web.md). Of this project it imports only the module
fieldfab."""
