"""The demo: a newcomer's first look, as one page of static files in out/demo/index.html. It works from a disk and from
any web server.

It shows a machine of 35 coloured parts, the head of a CT scan, a part planned for five axes and simulated (all can be
rotated), prospero, and the cross-checks of each part. `./dev demo` runs it after the build. It uses the command only.
"""

import base64
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("FIELDFAB_BUILD", ROOT / "build" / "release"))
DATA = ROOT / "tests" / "data"
OUT = ROOT / "out" / "demo"
COLOURS = ("#c8ccd0", "#b08d57", "#6f8fa6", "#d9a441", "#7a8450", "#a65e4e")
FRAMES = 60
steps_done = 0


def fieldfab(*arguments):
    """Runs the command with --json; returns its summary and the seconds it took."""
    global steps_done
    started = time.monotonic()
    done = subprocess.run([BUILD / "bin" / "fieldfab", "--json", *map(str, arguments)], capture_output=True, text=True)
    seconds = time.monotonic() - started
    steps_done += 1
    verb, model = arguments[0], pathlib.Path(arguments[1]).name
    start, end = ("\r\033[K", "") if sys.stdout.isatty() else ("", "\n")
    print(f"{start}[{steps_done:3d}] {verb} {model}: {seconds:.2f} s", end=end, flush=True)
    if done.returncode not in (0, 1) or not done.stdout:
        sys.exit(f"\ndemo: {' '.join(map(str, arguments))}: exit {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout), seconds


def region(bounds, margin):
    low = [bounds[0] - margin, bounds[2] - margin, bounds[4] - margin]
    high = [bounds[1] + margin, bounds[3] + margin, bounds[5] + margin]
    return "--bounds=" + ",".join(f"{v:.6g}" for v in low + high)


def checked_parts(out, count, cells):
    """Builds, meshes and checks each part of the PCB mill mtm_az (Keeter 4.3.5). `cells`: cells per inch, the unit of
    the files; 127 are 5 per mm."""
    text = (DATA / "frep" / "mtm_az" / "mtm_az.bounds").read_text()
    rows = []
    for i, box in enumerate(json.loads(text[: text.rindex("]") + 1])[:count]):
        model, bounds = DATA / "frep" / "mtm_az" / f"mtm_az_{i:02d}.math", region(box, 0.02)
        build, t_build = fieldfab("build", model, "-o", out / f"part_{i:02d}.asdf", bounds, "--resolution", cells)
        mesh, t_mesh = fieldfab("mesh", model, "-o", out / f"part_{i:02d}.stl", bounds, "--resolution", cells)
        check, t_check = fieldfab("check", model, bounds, "--resolution", cells // 4)
        rows.append((i, build, t_build, mesh, t_mesh, check, t_check))
    return rows


def machine(out, count, voxel):
    """Writes the distance fields of all parts with their colours as mtm_az.frep, .glb and .png, in mm."""
    lines = [f'part(scale(open("part_{i:02d}.asdf"), 25.4), "part {i:02d}", "{COLOURS[i % len(COLOURS)]}")\n'
             for i in range(count)]
    (out / "mtm_az.frep").write_text("".join(lines))
    fieldfab("render", out / "mtm_az.frep", "-o", out / "mtm_az.png", "--size", 900, "--alpha", 35, "--beta", -63)
    return fieldfab("mesh", out / "mtm_az.frep", "-o", out / "mtm_az.glb", "--voxel", voxel)


def head(out, voxel):
    """Writes the skin of the CT scan as cthead.frep, .glb and .png. The slices run from the crown, at the lowest z, to
    the neck; half a turn about y sets the head upright, and its face remains in front."""
    text = out / "cthead.frep"
    scan = os.path.relpath(DATA / "ct" / "cthead", out)
    text.write_text(f'rotate_y(open("{scan}", threshold = 60, keep_largest = 1), 180)\n')
    fieldfab("render", text, "-o", out / "cthead.png", "--size", 900, "--alpha", 35, "--beta", -80)
    return fieldfab("mesh", text, "-o", out / "cthead.glb", "--voxel", voxel)


def machined(out, job, frames, cell):
    """Plans and simulates a job. Writes its program, a drawing of its cuts, report, film and final stock."""
    program, cuts = out / "program.ngc", out / "cuts.svg"
    plan, t_plan = fieldfab("cam", job, "-o", program, "--picture", cuts, "--oblique", "--sheet", out / "sheet.html")
    # The drawing has the size of the cuts. Rapids, in red, lead out of it.
    cuts.write_text(re.sub(r'<path stroke="#e12828".*?/>\n', "", cuts.read_text()))
    done, t_done = fieldfab("simulate", program, "--setup", job, "-o", out / "stock.glb", "--report",
                            out / "report.html", "--frames", out / "film", "--frame-count", frames,
                            "--size", 720, "--cell", cell)
    return plan, t_plan, done, t_done


def prospero(out):
    model = DATA / "frep" / "prospero.vm"
    plane = "--bounds=-1.1,-1.1,0,1.1,1.1,0"
    plate = ["--thickness", 0.04, "--bounds=-1.1,-1.1,-0.02,1.1,1.1,0.06", "--resolution", 100]
    figures = {}
    figures["bitmap, 1024 x 1024"] = fieldfab("render", model, "-o", out / "prospero.png", "--mode", "bitmap", "--size",
                                              1024, plane)[1]
    figures["distance field of a plate"] = fieldfab("build", model, "-o", out / "prospero.asdf", *plate)[1]
    mesh, figures["mesh of a plate"] = fieldfab("mesh", model, "-o", out / "prospero.stl", *plate)
    check, figures["check of the plate"] = fieldfab("check", model, *plate)
    figures["picture of the plate"] = fieldfab("render", model, "-o", out / "prospero_plate.png", *plate[:3], "--size",
                                               900, "--beta", -35)[1]
    return figures, mesh, check


STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1c2733; background: #fff;
  max-width: 1080px; margin: 2.5rem auto; padding: 0 1rem }
h1, h2 { font-weight: 600; letter-spacing: -.01em } h2 { margin-top: 2.5rem } a { color: #0f6a63 }
.lead { font-size: 1.2rem } .table { overflow-x: auto } summary { cursor: pointer; margin: .6rem }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; width: 100% }
td, th { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid #dde5ee }
th:first-child, td:first-child { text-align: left } .pass { color: #1b7f46 } .fail { color: #b3261e; font-weight: 600 }
figure { margin: 0 0 1rem } figcaption { font-size: 14px; color: #4d5c6c; margin-top: .3rem }
img { width: 100%; border-radius: 8px; display: block }
.wide { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)); gap: 1rem;
  align-items: center }
.scene { height: min(560px, 76vh, 90vw); border-radius: 8px; overflow: hidden;
  background: linear-gradient(#f4f6fa, #d1d9e3); cursor: grab }  /* as kernel/src/render/shade.cpp paints the stills */
.scene:active { cursor: grabbing }
.scene canvas { width: 100%; height: 100%; display: block; touch-action: pan-y !important }
.scene img { height: 100%; object-fit: contain; border-radius: 0 }
.film { display: flex; gap: .6rem; align-items: center; margin-top: .4rem } .film input { flex: 1 }
button { font: inherit; padding: .1rem .8rem }
@media (max-width: 600px) { table { font-size: 12px } td, th { padding: .25rem .15rem } }
"""


def verdict(passed):
    return '<span class="pass">✓</span>' if passed else '<span class="fail">a bound is broken</span>'


def scene(name, picture, words, colour="", height=0.45):
    """Returns HTML of a model that can be rotated, seen first from an angle above the ground; without WebGL or scripts
    its picture is shown."""
    return f"""<figure data-model="{name}" data-colour="{colour}" data-height="{height}">
<div class="scene" role="img" aria-label="{words}"><img src="{picture}" alt="{words}"></div>
<figcaption>{words}. Drag to turn; arrow keys and the wheel work once it is clicked.
<a href="{name}.glb" download>{name}.glb</a></figcaption></figure>"""


def prospero_told(figures, plate, check):
    rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{seconds:.2f} s</td></tr>"
                   for name, seconds in figures.items())
    return f"""<h2>Prospero, 7866 instructions</h2>
<div class="wide"><figure><img src="prospero.png" alt="prospero as a bitmap"></figure>
<figure><img src="prospero_plate.png" alt="prospero as a plate"></figure></div>
<table>{rows}</table><p>The plate has {plate['triangles']:,} triangles. Its check: {verdict(check['passed'])}</p>"""


def table(rows):
    def text(value):
        return f"{value:.2f}" if isinstance(value, float) else f"{value:,}" if isinstance(value, int) else value

    heads = "".join(f"<th>{head}</th>" for head in ("", "cells", "build, s", "triangles", "mesh, s", "check, s", ""))
    lines = "".join("<tr>" + "".join(f"<td>{text(value)}</td>" for value in row) + "</tr>" for row in rows)
    return f'<div class="table"><table><tr>{heads}</tr>{lines}</table></div>'


def checks(parts, cells):
    """Returns HTML of the sums over all parts, and of a folded table with a row of each."""
    rows = [(f"part {i:02d}", build["cells"], t_build, mesh["triangles"], t_mesh, t_check, verdict(check["passed"]))
            for i, build, t_build, mesh, t_mesh, check, t_check in parts]
    sums = [sum(column) for column in list(zip(*rows))[1:-1]]
    passed = sum(part[5]["passed"] for part in parts)
    total = (f"{len(parts)} parts", *sums, verdict(passed == len(parts)))
    return f"""<h2 id="checks">Each part, checked against OpenVDB and CGAL</h2>
<p>{passed} of {len(parts)} parts pass every bound (✓), at {cells / 25.4:.0f} cells a mm.</p>
{table([total])}
<details><summary>Each part</summary>{table(rows)}</details>"""


def next_steps(out):
    tutorial = os.path.relpath(ROOT / "docs" / "tutorial.md", out)
    return f"""<h2>Next</h2>
<ul><li><code>build/release/bin/fieldfab serve</code> designs in the browser, as text or as a graph of nodes.</li>
<li><code>./dev freecad</code> starts FreeCAD with Fieldfab's workbench: design, plan, simulate.</li>
<li><a href="{tutorial}">The tutorial</a> makes a bracket that carries a scanned head, from a blank document to the
machine, in about a quarter of an hour.</li></ul>"""


def page(out, parts, cells, mill, scan, cut, frames, plate):
    _, t_plan, _, t_done = cut
    return f"""<!doctype html><html lang="en"><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>Fieldfab demo</title><style>{STYLE}</style>
<h1>Fieldfab</h1>
<p class="lead">Fieldfab makes solids from formulas, CT scans and meshes, and turns them into meshes, pictures and
machine programs. It is for people who print or mill parts that start from scans, formulas or lattices.</p>
<p>The <code>fieldfab</code> command made everything below on this machine; times are whole commands, start to end.</p>
<h2>MTM A-Z, a PCB mill of {len(parts)} parts</h2>
{scene("mtm_az", "mtm_az.png", "The mill, from prefix math strings")}
<p>{mill[0]['triangles']:,} triangles in {mill[1]:.1f} s.</p>
<h2>A head, from a CT scan</h2>
{scene("cthead", "cthead.png", "The skin of a scanned head, 256 x 256 x 99 samples", "#d8b9a0", 0.2)}
<p>{scan[0]['triangles']:,} triangles in {scan[1]:.1f} s.</p>
<h2>A plan for five axes, and its simulation</h2>
<div class="wide"><figure><img src="cuts.svg" alt="The cuts, as lines">
<figcaption>The cuts, in order from blue to green, planned in {t_plan:.1f} s.
<a href="program.ngc" download>Program</a>, <a href="sheet.html">set-up sheet</a></figcaption></figure>
<figure data-film="film"><img src="film/frame_{frames:04d}.png" alt="The stock while it is machined">
<div class="film"><button hidden>Play</button>
<input type="range" min="1" max="{frames}" value="{frames}" aria-label="Time" hidden></div>
<figcaption>The program, carried out on the stock in {t_done:.1f} s.
<a href="report.html">Report</a></figcaption></figure></div>
{scene("stock", f"film/frame_{frames:04d}.png", "What is left of the stock")}
{prospero_told(*plate) if plate else ""}
{checks(parts, cells)}
{next_steps(out)}
<script src="demo.js"></script></html>"""


def with_scripts(out):
    """Writes each .glb as a script, too: browsers load no other files for a page from a disk."""
    for path in out.glob("*.glb"):
        (out / f"{path.name}.js").write_text(
            f'fieldfabModel("{path.stem}", "{base64.b64encode(path.read_bytes()).decode()}")\n')
    script = BUILD / "web" / "npm" / "demo.js"
    if script.exists():
        shutil.copy(script, out)
    else:
        print("demo: npm was out of reach when Fieldfab was built: the page has pictures, and nothing turns")


def main(out=OUT, parts=35, cells=127, with_prospero=True, voxel=1, head_voxel=2,
         job=ROOT / "examples" / "cam" / "knob_five_axis.toml", frames=FRAMES, cell=0.2):
    """Makes the page in a folder. A test uses fewer parts and larger cells."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    rows = checked_parts(out, parts, cells)
    mill, scan, cut = machine(out, parts, voxel), head(out, head_voxel), machined(out, job, frames, cell)
    plate = prospero(out) if with_prospero else None
    with_scripts(out)
    (out / "index.html").write_text(page(out, rows, cells, mill, scan, cut, frames, plate))
    passed = [row[5]["passed"] for row in rows] + ([plate[2]["passed"]] if plate else [])
    print(f"\ndemo: {sum(passed)} of {len(passed)} parts passed their checks, prospero's plate among them; "
          f"see {out}/index.html")
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
