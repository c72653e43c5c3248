"""Output of `fieldfab simulate`: coloured meshes, pictures and the HTML report, each read by independent means."""

import base64
import html.parser
import json
import re
import struct
import subprocess
import zlib

import numpy as np
import pytest

from conftest import COMMAND
from mesh_files import read_ply


# A plate of 40 x 30 mm, faced to z = -1; its sides and bottom are the stock's.
TARGET = "max(max(abs(x) - 20, abs(y) - 15), max(z + 1, -(z + 8)))"
SETUP = """
name = "plate <1> & more"
cell = 0.25
[stock]
lower = [-20, -15, -8]
upper = [20, 15, 0]
[target]
model = "plate.frep"
[[tool]]
number = 1
name = "</td><script>alert(1)</script>"
diameter = 6
flute = 16
length = 30
[[tool]]
number = 2
shape = "ball"
diameter = 4
flute = 14
length = 30
"""
NASTY = '(<script>alert `x`</script> &amp; "so" \'quoted\' \xfcber)'


def program(gouge=-1.0, rapid=False, left_out=None):
    """Faces the plate row by row. The row at y = 1 reaches down to `gouge` in its middle; `rapid` makes the row at y =
    9 a rapid."""
    lines = ["G21 G90", "T1 M6", "S10000 M3", "G0 Z5", "G0 X-24 Y-15", "G1 Z-1 F600"]
    for number, y in enumerate(range(-15, 18, 4)):
        there, back = (24, -24) if number % 2 == 0 else (-24, 24)
        if y == left_out:
            lines += ["G0 Z5", f"G0 X{there} Y{y}", "G1 Z-1"]
            continue
        lines.append(f"G1 X{back} Y{y}")
        if y == 1 and gouge < -1:
            lines += ["G1 X-2 Z-1", f"G1 X2 Z{gouge} {NASTY}", "G1 X6 Z-1"]
        lines.append(f"{'G0' if rapid and y == 9 else 'G1'} X{there}")
    return lines + ["G0 Z5", "T2 M6", "S10000 M3", "G43 H2 G0 X-24 Y0", "G0 Z-3", "G1 X-23 F300", "G0 Z5", "M2"]


def run(*args, timeout=300):
    return subprocess.run([str(COMMAND), *map(str, args)], capture_output=True, text=True, errors="replace",
                          timeout=timeout)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    (folder / "plate.frep").write_text(TARGET)
    (folder / "setup.toml").write_text(SETUP)
    (folder / "untargeted.toml").write_text(SETUP.replace('[target]\nmodel = "plate.frep"\n', ""))
    for name, lines in {"good": program(), "gouge": program(gouge=-1.4, rapid=True, left_out=-7)}.items():
        (folder / f"{name}.nc").write_bytes("\n".join(lines).encode("latin-1") + b"\n")
    return folder


def read_png(data):
    """Decodes a PNG by the specification. Returns pixels of shape (height, width, 3)."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, chunks = 8, {}
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + body)
        chunks[kind] = chunks.get(kind, b"") + body
        at += 12 + length
    width, height, depth, colour, *_ = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert (depth, colour) == (8, 2)
    raw = zlib.decompress(chunks[b"IDAT"])
    rows, before, stride = [], bytearray(3 * width), 1 + 3 * width
    for y in range(height):
        kind, row = raw[y * stride], bytearray(raw[y * stride + 1:(y + 1) * stride])
        if kind == 2:
            row = bytearray((np.frombuffer(row, np.uint8) + np.frombuffer(before, np.uint8)).astype(np.uint8))
        elif kind:
            for i in range(len(row)):
                a, b, c = row[i - 3] if i > 2 else 0, before[i], before[i - 3] if i > 2 else 0
                paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
                row[i] = row[i] + {1: a, 3: (a + b) // 2, 4: paeth}[kind] & 255
        rows.append(bytes(row))
        before = row
    return np.frombuffer(b"".join(rows), np.uint8).reshape(height, width, 3)


class Page(html.parser.HTMLParser):
    """Parses a page, checks that its elements nest, and collects table cells, images and texts."""

    VOID = {"meta", "img"}

    def __init__(self, text):
        super().__init__()
        self.open, self.rows, self.images, self.tags, self.text = [], [], [], [], ""
        self.feed(text)
        self.close()
        assert self.open == [], self.open

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag == "img":
            self.images.append(dict(attributes)["src"])
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, f"</{tag}> in {self.open}"

    def handle_data(self, data):
        self.text += data
        if "td" in self.open or "th" in self.open:
            self.rows[-1][-1] += data


def distance_of_plate(p):
    """Returns exact signed distances from the plate, and whether the nearest point is on a face, not on an edge."""
    q = np.abs(p - [0, 0, -4.5]) - [20, 15, 3.5]
    outside = np.linalg.norm(np.maximum(q, 0), axis=1)
    return outside + np.minimum(q.max(axis=1), 0), (q > -1e-4).sum(axis=1) < 2


def test_ply_holds_deviations_colours_and_lines(folder):
    out = folder / "part.ply"
    done = run("simulate", folder / "gouge.nc", "--setup", folder / "setup.toml", "-o", out, "--target",
               folder / "plate.frep")
    assert done.returncode == 1, done.stderr
    vertices, faces = read_ply(out)
    assert vertices.dtype.names == ("x", "y", "z", "red", "green", "blue", "deviation", "line", "tool")
    assert faces.min() == 0 and faces.max() == len(vertices) - 1
    places = np.stack([vertices["x"], vertices["y"], vertices["z"]], axis=1).astype(float)
    wanted, plain = distance_of_plate(places)
    off = np.abs(vertices["deviation"] - wanted)[plain & (wanted < 9)]
    assert plain.mean() > 0.9 and off.max() < 2e-3

    red, green, blue = (vertices[c].astype(int) for c in ("red", "green", "blue"))
    gouged, left, fine = (vertices["deviation"] < -0.05, vertices["deviation"] > 0.05,
                          np.abs(vertices["deviation"]) < 0.05)
    assert gouged.sum() > 100 and left.sum() > 100
    assert (red[gouged] > blue[gouged] + 60).all() and (blue[left] > red[left] + 60).all()
    assert (np.abs(red[fine] - blue[fine]) < 5).all() and (np.abs(red[fine] - green[fine]) < 5).all()
    # Deeper is darker.
    deep = gouged & (vertices["deviation"] < vertices["deviation"].min() + 0.02)
    assert green[deep].max() < green[gouged & (vertices["deviation"] > -0.08)].min()

    text = program(gouge=-1.4, rapid=True, left_out=-7)
    guilty = {i + 1 for i, line in enumerate(text) if "Z-1.4" in line or line == "G1 X6 Z-1"}
    assert set(vertices["line"][gouged]) <= guilty and set(vertices["tool"][gouged]) == {1}
    assert (vertices["tool"][vertices["line"] == 0] == 0).all() and set(vertices["tool"]) <= {0, 1, 2}


def test_other_meshes_stay_as_they_are(folder):
    for extension in ("stl", "off", "obj", "3mf"):
        out = folder / f"part.{extension}"
        done = run("simulate", folder / "good.nc", "--setup", folder / "setup.toml", "--cell", 0.5, "-o", out)
        assert done.returncode == 0 and out.stat().st_size > 1000, done.stderr
    plain = (folder / "part.stl").read_bytes()
    assert len(plain) == 84 + 50 * struct.unpack("<I", plain[80:84])[0]


def test_the_page_tells_everything_and_runs_nothing(folder):
    page_file, json_file = folder / "report.html", folder / "report.json"
    done = run("simulate", folder / "gouge.nc", "--setup", folder / "setup.toml", "--report", page_file, "--report",
               json_file)
    assert done.returncode == 1, done.stderr
    events = json.loads(json_file.read_text())["events"]
    assert {e["kind"] for e in events} == {"gouge", "rapid contact"} and {e["tool"] for e in events} == {1}
    text = page_file.read_text(encoding="utf-8")
    page = Page(text)
    assert "script" not in page.tags and not re.search(r"(src|href)=\"(?!data:image/png)", text) and "url(" not in text
    assert "plate <1> & more" in page.text and f"{len(events)} things are wrong" in page.text
    lines = (folder / "gouge.nc").read_bytes().decode("utf-8", errors="replace").splitlines()
    rows = [row for row in page.rows if len(row) == 7 and row[0].isdigit() and row[2].isdigit()]
    assert len(rows) == len(events)
    for number, (row, event) in enumerate(zip(rows, events), 1):
        assert row[0] == str(number) and row[1] == event["kind"] + event["message"] and row[2] == str(event["line"])
        assert row[3] == lines[event["line"] - 1] and row[4] == str(event["tool"])
        assert [float(n) for n in row[5].split(",")] == pytest.approx(event["place"], abs=1e-3)
    assert any("<script>alert `x`</script> &amp; \"so\"" in row[3] and "\ufffdber" in row[3] for row in rows)
    assert any("</td><script>alert(1)</script>" in row[1] for row in page.rows)
    assert len(page.images) >= 5
    for source in page.images[:5]:
        pixels = read_png(base64.b64decode(source.removeprefix("data:image/png;base64,"), validate=True))
        assert pixels.shape[1] >= 400 and pixels.std() > 5
    assert page.tags.count("svg") >= 3


def test_a_good_program_is_called_good(folder):
    for setup, told in (("setup", "Against the target"), ("untargeted", "There was no target")):
        page = folder / f"good_{setup}.html"
        done = run("simulate", folder / "good.nc", "--setup", folder / f"{setup}.toml", "--cell", 0.5, "--report", page)
        assert done.returncode == 0, done.stderr
        text = Page(page.read_text(encoding="utf-8")).text
        assert "Nothing is wrong." in text and told in text


def test_tools_and_their_times_add_up(folder):
    report = folder / "sums.json"
    done = run("simulate", folder / "good.nc", "--setup", folder / "setup.toml", "--cell", 0.5, "--report", report)
    assert done.returncode == 0, done.stderr
    told = json.loads(report.read_text())
    assert {line["tool"] for line in told["lines"]} == {1, 2}
    for what in ("removed", "seconds", "cut", "air"):
        assert sum(line[what] for line in told["lines"]) == pytest.approx(told[what], rel=1e-6)


def test_pictures_show_the_gouge(folder):
    """In the top view the planted gouge is red, and the omitted row blue, at their positions."""
    marked = folder / "marked.png"
    base = ("simulate", folder / "gouge.nc", "--setup", folder / "setup.toml", "--size", 400, "--alpha", 0, "--beta", 0)
    assert run(*base, "--picture", marked).returncode == 1
    pixels = read_png(marked.read_bytes())
    assert pixels.shape[1] == 400 and pixels.shape[0] > 306 + 20  # the legend lies below
    import fieldfab as ff

    simulation = ff.stock.Simulation(folder / "setup.toml", folder / "gouge.nc")
    plain = simulation.picture(size=400, alpha=0, beta=0, marks=False).astype(int)
    assert plain.shape == (306, 400, 3)  # 40 x 30 with a margin of 3 % of the longer side

    def at(x, y):
        column, row = (x / 42.4 + 0.5) * 400, (0.5 - y / 32.4) * 306
        return plain[int(row) - 1:int(row) + 2, int(column) - 1:int(column) + 2].mean(axis=(0, 1))

    for x in (-1, 1, 3):
        assert at(x, 1)[0] > at(x, 1)[2] + 40, (x, at(x, 1))
    assert at(-5, -7)[2] > at(-5, -7)[0] + 40
    assert abs(at(-12, 1)[0] - at(-12, 1)[2]) < 25
    assert ((simulation.picture(size=400, alpha=0, beta=0) != plain).any(axis=2)).sum() > 300  # marks
    assert (pixels[:306] == simulation.picture(size=400, alpha=0, beta=0)).all()


def test_python_writes_them_too(folder):
    import fieldfab as ff

    simulation = ff.stock.Simulation(folder / "setup.toml", folder / "gouge.nc", cell=0.5)
    simulation.save(folder / "python.ply")
    simulation.html(folder / "python.html")
    vertices, _ = read_ply(folder / "python.ply")
    assert ((simulation.deviation == vertices["deviation"]).all()
            and (simulation.tools_of_vertices == vertices["tool"]).all())
    assert (simulation.colours == np.stack([vertices["red"], vertices["green"], vertices["blue"]], axis=1)).all()
    assert "is wrong" in Page((folder / "python.html").read_text(encoding="utf-8")).text.replace(
        "are wrong", "is wrong")
    with pytest.raises(ff.Error):
        simulation.html(folder / "none" / "x.html")
    with pytest.raises(ff.Error):
        simulation.picture(size=0)


def test_what_is_cut_away_altogether_has_a_page_too(folder):
    setup, page = folder / "tiny.toml", folder / "tiny.html"
    setup.write_text(SETUP.replace("[-20, -15, -8]", "[-2, -2, -1]").replace("[20, 15, 0]", "[2, 2, 0]"))
    (folder / "tiny.nc").write_text("T1 M6\nS1000 M3\nG0 X-9 Y0 Z5\nG0 Z-2\nG1 X9 F300\nM2\n")
    done = run("simulate", folder / "tiny.nc", "--setup", setup, "--report", page, "-o", folder / "tiny.ply",
               "--picture", folder / "tiny.png")
    assert done.returncode == 0, done.stderr
    assert "Material left0 mm\u00b3" in Page(page.read_text(encoding="utf-8")).text.replace("\n", "")
    assert len(read_ply(folder / "tiny.ply")[0]) == 0


@pytest.mark.parametrize("option, name, wanted", [
    ("--report", "x.pdf", "a report is a .html or a .json"),
    ("--report", "x", "a report is a .html or a .json"),
    ("--picture", "x.jpg", "a picture of a stock is a .png"),
    ("-o", "x.step", "cannot write a stock as '.step'"),
    ("--report", "none/x.html", "none/x.html"),
    ("--report", "none/x.json", "none/x.json"),
    ("--picture", "none/x.png", "none/x.png"),
    ("-o", "none/x.ply", "none/x.ply"),
])
def test_wrong_names_end_with_one_clear_line(folder, option, name, wanted):
    done = run("simulate", folder / "good.nc", "--setup", folder / "setup.toml", "--cell", 1, option, folder / name)
    assert done.returncode == 2 and wanted in done.stderr and len(done.stderr.strip().splitlines()) == 1, done
    assert not (folder / name).exists()


def test_colours_need_what_they_tell_of(folder):
    base = ("simulate", folder / "good.nc", "--setup", folder / "untargeted.toml", "--cell", 1, "--picture",
            folder / "c.png")
    done = run(*base, "--colours", "deviation")
    assert done.returncode == 2 and "there is no target" in done.stderr and len(done.stderr.strip().splitlines()) == 1
    for colours in ("tool", "line"):
        assert run(*base, "--colours", colours).returncode == 0
    assert run(*base, "--colours", "pink").returncode == 2


def test_existing_files_stay_when_something_fails(folder):
    page = folder / "kept.html"
    page.write_text("mine")
    bad = folder / "bad.nc"
    bad.write_text("T9 M6\nG1 X0\n")
    assert run("simulate", bad, "--setup", folder / "setup.toml", "--report", page).returncode == 2
    assert page.read_text() == "mine"
