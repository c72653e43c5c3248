"""fabserver's server: `python3 -m fieldfab.serve` (docs/web.md). It knows the module fieldfab and nothing else of the house."""
