"""Generates documents from the design language's table and examples/: the shape library's manual with its pictures, the
gallery, and the type stubs of fieldfab.shapes. `./dev docs` runs it. With --check it writes nothing and reports texts
that are out of date."""

import pathlib
import sys
import tempfile
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "release" / "python"))

import fieldfab as ff

PICTURES = ROOT / "docs" / "figures"
VIEW: dict[str, Any] = dict(alpha=0.5, beta=-0.95, perspective=0.5, samples=2)
DISTANCES = {"exact": "exact", "bound": "bound", "neither": "–", "": ""}


def stubs():
    kinds = {"expression": "Operand", "angle": "Operand", "number": "float", "whole": "int", "text": "str"}
    lines = ['"""Shapes, and what is done with them, as expressions. Lengths in mm, angles in radians. '
             'Made by ./dev docs."""', ""]
    lines += ["from collections.abc import Iterable", "from typing import Any", "", "from ._core import Operand, Solid",
              ""]
    for f in library():
        parts = [f"{p['name']}: {kinds[p['kind']]}" + ("" if p["default"] is None else " = ...")
                 for p in f["parameters"]]
        if f["any_number"]:  # further ones, as arguments or in lists
            parts = [f"*{f['parameters'][0]['name']}: Any"]
        lines.append(f"def {f['name']}({', '.join(parts)}) -> Solid: ...")
    return "\n".join(lines) + "\n"


def library():
    return [f for f in ff.library() if f["group"] != "numbers"]


def manual():
    lines = [
        "# The shape library",
        "",
        "All functions of `.frep` text and of Python's `fieldfab.shapes`, with a picture of each example; "
        "made by `./dev docs`.",
        "Lengths are mm; angles are degrees in `.frep`, radians in Python. "
        "All arguments except counts and plain numbers may",
        "depend on `x`, `y` and `z`.",
        "",
        "*Exact*: the value is the distance to the surface. "
        "*Bound*: the value is never more than that, so that offsets and",
        "walls are at least that far away, and edges stay sharp when the solid grows. "
        "*–*: only the sign is defined, and the",
        "value is smooth.",
    ]
    group = None
    for f in library():
        if f["group"] != group:
            group = f["group"]
            lines += ["", f"## {group}", "", "| | | |", "|---|---|---|"]
        about = " · ".join(filter(None, [f["meaning"], DISTANCES[f["distance"]]]))
        picture = f"![{f['name']}](figures/shapes/{f['name']}.png)"
        told = f"{about}<br>`{f['example']}`".replace("|", r"\|")  # a bar ends a cell, also in code
        lines.append(f"| {picture} | `{f['signature']}` | {told} |")
    return "\n".join(lines) + "\n"


def gallery():
    lines = ["# Gallery", "", "The designs of `examples/`, each a few lines of `.frep`; "
             "pictures by `fieldfab render`, made by `./dev docs`.", ""]
    for path in sorted((ROOT / "examples").glob("*.frep")):
        title, *text = path.read_text().splitlines()
        name = path.stem.replace("_", " ")
        lines += [f"## {name.capitalize()}", "", title.lstrip("# ").capitalize() + ".", "",
                  f"![{name}](figures/gallery/{path.stem}.png)", ""]
        lines += ["```frep", *text, "```", ""]
    for path in sorted((ROOT / "examples" / "openscad").glob("*.scad")):
        if path.stem == "fieldfab":  # the library, copied there by a run
            continue
        title, *text = path.read_text().splitlines()
        lines += [f"## {path.stem.capitalize()}, in OpenSCAD", "", title.lstrip("/ "), "",
                  f"![{path.stem}](figures/openscad_{path.stem}.png)", ""]
        lines += [f"`fieldfab openscad examples/openscad/{path.name} -o {path.stem}.stl` ([openscad.md](openscad.md))",
                  "", "```openscad", *text, "```", ""]
    return "\n".join(lines)


def render(expression, path):
    """Writes the picture if it differs from the file."""
    image = ff.render(expression, size=240, **VIEW)
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "made.png"
        image.save(made)
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_bytes() != made.read_bytes():
            path.write_bytes(made.read_bytes())


def texts():
    return {
        ROOT / "docs" / "shapes.md": manual(),
        ROOT / "docs" / "gallery.md": gallery(),
        ROOT / "python" / "fieldfab" / "shapes.pyi": stubs(),
    }


def main():
    if "--check" in sys.argv:
        stale = [str(path.relative_to(ROOT)) for path, text in texts().items()
                 if not path.exists() or path.read_text() != text]
        sys.exit(f"stale, run ./dev docs: {', '.join(stale)}" if stale else 0)
    for path, text in texts().items():
        path.write_text(text)
    for f in library():
        render(ff.parse(f["example"]), PICTURES / "shapes" / f"{f['name']}.png")
    for path in (ROOT / "examples").glob("*.frep"):
        render(ff.parse(path.read_text()), PICTURES / "gallery" / f"{path.stem}.png")


if __name__ == "__main__":
    main()
