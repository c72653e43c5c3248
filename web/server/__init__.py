"""fabserver's server: `python3 -m fieldfab.serve` (docs/web.md). It imports the module fieldfab and nothing else of
this project."""
