"""The demo: build, check, mesh and render mtm_az (35 parts) and prospero, with what that took, as one page in out/demo/index.html.

Run by ./dev demo after the build; uses the command only, as a user would.
"""

import html
import json
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = ROOT / "build" / "release" / "bin" / "fieldfab"
DATA = ROOT / "tests" / "data" / "frep"
OUT = ROOT / "out" / "demo"
steps_done = 0
STEPS = 35 * 4 + 5


def fieldfab(*arguments):
    """Runs the command with --json; returns its summary and the seconds it took."""
    global steps_done
    started = time.monotonic()
    done = subprocess.run([COMMAND, "--json", *map(str, arguments)], capture_output=True, text=True)
    seconds = time.monotonic() - started
    steps_done += 1
    verb, model = arguments[0], pathlib.Path(arguments[1]).name
    if sys.stdout.isatty():
        print(f"\r\033[K[{steps_done:3d}/{STEPS}] {verb} {model}: {seconds:.2f} s", end="", flush=True)
    else:
        print(f"[{steps_done:3d}/{STEPS}] {verb} {model}: {seconds:.2f} s", flush=True)
    if done.returncode not in (0, 1) or not done.stdout:
        sys.exit(f"\ndemo: {' '.join(map(str, arguments))}: exit {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout), seconds


def region(bounds, margin):
    low = [bounds[0] - margin, bounds[2] - margin, bounds[4] - margin]
    high = [bounds[1] + margin, bounds[3] + margin, bounds[5] + margin]
    return "--bounds=" + ",".join(f"{v:.6g}" for v in low + high)


def mtm_az():
    """Each of the 35 parts of the PCB mill (Keeter 4.3.5); lengths are inches in the file, so 25.4 * 5 cells an inch is 5 a mm."""
    text = (DATA / "mtm_az" / "mtm_az.bounds").read_text()
    boxes = json.loads(text[: text.rindex("]") + 1])
    rows = []
    for i, box in enumerate(boxes):
        model = DATA / "mtm_az" / f"mtm_az_{i:02d}.math"
        bounds = region(box, 0.02)
        build, t_build = fieldfab("build", model, "-o", OUT / f"part_{i:02d}.asdf", bounds, "--resolution", 127)
        mesh, t_mesh = fieldfab("mesh", model, "-o", OUT / f"part_{i:02d}.stl", bounds, "--resolution", 127)
        check, t_check = fieldfab("check", model, bounds, "--resolution", 32)
        fieldfab("render", model, "-o", OUT / f"part_{i:02d}.png", bounds, "--size", 260, "--alpha", 35, "--beta", -60)
        rows.append((i, build, t_build, mesh, t_mesh, check, t_check))
    return rows


def prospero():
    model = DATA / "prospero.vm"
    plane = "--bounds=-1,-1,0,1,1,0"
    plate = ["--thickness", 0.04, "--bounds=-1.02,-1.02,-0.02,1.02,1.02,0.06", "--resolution", 100]
    figures = {}
    figures["bitmap, 1024 x 1024"] = fieldfab("render", model, "-o", OUT / "prospero.png", "--mode", "bitmap", "--size", 1024, plane)[1]
    figures["distance field of a plate"] = fieldfab("build", model, "-o", OUT / "prospero.asdf", *plate)[1]
    mesh, figures["mesh of a plate"] = fieldfab("mesh", model, "-o", OUT / "prospero.stl", *plate)
    check, figures["check of the plate"] = fieldfab("check", model, *plate)
    figures["picture of the plate"] = fieldfab("render", model, "-o", OUT / "prospero_plate.png", *plate[:3], "--size", 900, "--beta", -35)[1]
    return figures, mesh, check


STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1c2733; max-width: 1080px; margin: 2.5rem auto; padding: 0 1rem }
h1, h2 { font-weight: 600; letter-spacing: -.01em } h2 { margin-top: 2.5rem }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; width: 100% } td, th { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid #dde5ee }
th:first-child, td:first-child { text-align: left } .pass { color: #1b7f46 } .fail { color: #b3261e; font-weight: 600 }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: .8rem } figure { margin: 0 } figcaption { font-size: 13px; color: #5b6b7c }
img { width: 100%; border-radius: 8px; display: block } .wide { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem }
"""


def verdict(check):
    return '<span class="pass">all bounds hold</span>' if check["passed"] else '<span class="fail">a bound is broken</span>'


def page(rows, figures, plate, plate_check):
    total = lambda column: sum(row[column] for row in rows)
    parts = "".join(
        f"<tr><td>part {i:02d}</td><td>{b['cells']:,}</td><td>{b['bytes'] / b['cells']:.1f}</td><td>{tb:.2f}</td><td>{m['triangles']:,}</td><td>{tm:.2f}</td><td>{verdict(c)}</td><td>{tc:.2f}</td></tr>"
        for i, b, tb, m, tm, c, tc in rows
    )
    pictures = "".join(f'<figure><img src="part_{i:02d}.png" alt="part {i:02d}"><figcaption>part {i:02d}</figcaption></figure>' for i, *_ in rows)
    prospero_rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{seconds:.2f} s</td></tr>" for name, seconds in figures.items())
    return f"""<!doctype html><html lang="en"><meta charset="utf-8"><title>Fieldfab demo</title><style>{STYLE}</style>
<h1>Fieldfab: a solid from a formula</h1>
<p>Everything on this page was made by the <code>fieldfab</code> command from prefix math strings and a <code>.vm</code> program; times are whole commands, start to end.</p>
<h2>MTM A-Z, a PCB mill of 35 parts</h2>
<p>5 cells a mm: {sum(r[1]['cells'] for r in rows):,} cells in {total(2):.1f} s, {sum(r[3]['triangles'] for r in rows):,} triangles in {total(4):.1f} s.
Cross-checked against OpenVDB and CGAL in {total(6):.1f} s: {sum(r[5]['passed'] for r in rows)} of {len(rows)} parts pass every bound.</p>
<div class="gallery">{pictures}</div>
<table><tr><th>part</th><th>cells</th><th>bytes a cell</th><th>build, s</th><th>triangles</th><th>mesh, s</th><th>check</th><th>s</th></tr>{parts}</table>
<h2>Prospero, 7866 instructions</h2>
<div class="wide"><figure><img src="prospero.png" alt="prospero as a bitmap"></figure><figure><img src="prospero_plate.png" alt="prospero as a plate"></figure></div>
<table>{prospero_rows}</table><p>The plate: {plate['triangles']:,} triangles, {verdict(plate_check)}.</p></html>"""


def main():
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    rows = mtm_az()
    figures, plate, plate_check = prospero()
    (OUT / "index.html").write_text(page(rows, figures, plate, plate_check))
    print(f"\ndemo: {sum(r[5]['passed'] for r in rows)} of {len(rows)} parts and prospero ({'passed' if plate_check['passed'] else 'FAILED'}) checked; see {OUT.relative_to(ROOT)}/index.html")
    return 0 if plate_check["passed"] and all(r[5]["passed"] for r in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
