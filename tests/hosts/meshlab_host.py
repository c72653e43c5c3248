"""MeshLab with and without a window, for tests and figures: a separate home folder, scripts and meshes."""

import os
import pathlib
import subprocess
import time
import xml.sax.saxutils

import numpy as np
from conftest import BUILD

import fieldfab

VERSION = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "meshlab"], stdout=subprocess.PIPE).stdout.decode()
# Later versions leave places that are not finite out when they open a file.
REMOVES_NAN = not VERSION.startswith("2020")
# What the line of a file that cannot be opened begins with.
REFUSED = "Fieldfab: " if VERSION.startswith("2020") else "Error: "
APPLIED = "Applied filter " if VERSION < "2025" else "Applied filter: "  # before a filter's name, in the log
SERVER, WINDOW = BUILD / "meshlab" / "meshlabserver", BUILD / "meshlab" / "meshlab"
# MeshLab's own, or what stands for it in later versions (tests/hosts/meshlab_server.cpp).
MESHLABSERVER = next(path for path in (pathlib.Path("/usr/bin/meshlabserver"), SERVER) if path.exists())
REMESH = "Fieldfab: Remesh through a distance field"
OFFSET = "Fieldfab: Offset"
SHELL = "Fieldfab: Shell (hollow out)"
BOOLEAN = "Fieldfab: Boolean of two layers"
LATTICE = "Fieldfab: Lattice infill"
FREP = "Fieldfab: Solid from f-rep expression"
VOLUME = "Fieldfab: Volume import with threshold"
DEVIATION = "Fieldfab: Deviation from a layer or f-rep"
REPORT = "Fieldfab: Validity report"

# Every parameter of each filter, in order: Debian's meshlabserver fails an assertion if a script lacks one.
PARAMETERS = {
    REMESH: {"Voxel": ("AbsPerc", 1), "Edges": ("Enum", 0), "GapWidth": ("AbsPerc", 0)},
    OFFSET: {"Distance": ("AbsPerc", 1), "Voxel": ("AbsPerc", 1), "Edges": ("Enum", 0)},
    SHELL: {"Wall": ("AbsPerc", 1), "Side": ("Enum", 0), "DrainHoles": ("Int", 0), "HoleDiameter": ("AbsPerc", 2),
            "Voxel": ("AbsPerc", 1), "Edges": ("Enum", 0)},
    BOOLEAN: {"Operation": ("Enum", 0), "First": ("Mesh", 0), "Second": ("Mesh", 1), "Radius": ("AbsPerc", 0),
              "Voxel": ("AbsPerc", 1), "Edges": ("Enum", 0)},
    LATTICE: {"Lattice": ("Enum", 0), "Period": ("AbsPerc", 10), "Strut": ("AbsPerc", 1), "Wall": ("AbsPerc", 1),
              "Voxel": ("AbsPerc", 1), "Edges": ("Enum", 0)},
    FREP: {"Formula": ("String", "sphere(10)"), "Bounds": ("String", ""), "Voxel": ("Float", 0)},
    VOLUME: {"File": ("OpenFile", ""), "Threshold": ("String", "automatic"), "Below": ("Bool", False),
             "Denoise": ("String", "none"), "KeepLargest": ("Bool", False), "Voxel": ("Float", 0)},
    DEVIATION: {"Reference": ("Enum", 0), "Layer": ("Mesh", 0), "Formula": ("String", ""), "Range": ("AbsPerc", 0)},
    REPORT: {},
    "Uniform Mesh Resampling": {"CellSize": ("AbsPerc", 1), "Offset": ("AbsPerc", 0), "mergeCloseVert": ("Bool", True),
                                "discretize": ("Bool", False),
                                "multisample": ("Bool", False), "absDist": ("Bool", False)},
}


def script(*steps):
    """Returns the text of an .mlx file. Steps are names of filters, or pairs of a name and changes to PARAMETERS."""
    lines = ["<!DOCTYPE FilterScript>", "<FilterScript>"]
    for step in steps:
        name, given = (step, None) if isinstance(step, str) else step
        lines.append(f" <filter name={xml.sax.saxutils.quoteattr(name)}>")
        if given is not None:
            assert set(given) <= set(PARAMETERS[name]), given
            for key, (kind, default) in PARAMETERS[name].items():
                value = given.get(key, default)
                text = xml.sax.saxutils.quoteattr(str(value).lower() if kind == "Bool" else str(value))
                more = {"AbsPerc": ' min="0" max="1000"', "Enum": ' enum_cardinality="1" enum_val0="0"',
                        "OpenFile": ' exts_cardinality="0"'}.get(kind, "")
                lines.append(f'  <Param type="Rich{kind}" name="{key}" value={text}{more}/>')
        lines.append(" </filter>")
    return "\n".join([*lines, "</FilterScript>"])


def environment(home, **more):
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "PYTHON", "QT_"))}
    return {**kept, "HOME": str(home), "XDG_RUNTIME_DIR": str(home), "LIBGL_ALWAYS_SOFTWARE": "1", **more}


class Said:
    def __init__(self, code, text):
        self.code, self.text = code, text

    def __contains__(self, words):
        return words in self.text


def serve(folder, meshes, steps, output=None, screen=None, timeout=300, mask=()):
    """Runs meshlabserver with a script and returns its output. `output`: the file of the last layer, or a list with a
    file for each layer."""
    folder = pathlib.Path(folder)
    arguments = [str(SERVER)]
    for mesh in meshes:
        arguments += ["-i", str(mesh)]
    (folder / "script.mlx").write_text(script(*steps))
    if isinstance(output, (list, tuple)):
        for n, each in enumerate(output):
            arguments += ["-o", str(each), "-l", str(n), *mask]
    elif output:
        arguments += ["-o", str(output), "-l", "x", *mask]
    if steps:
        arguments += ["-s", str(folder / "script.mlx")]
    if screen is None:
        arguments = ["xvfb-run", "-a", *arguments]
    run = subprocess.run(arguments, env=environment(folder, **({"DISPLAY": screen} if screen else {})), cwd=folder,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=timeout)
    return Said(run.returncode, run.stdout.decode(errors="replace"))


def write_ply(path, vertices, triangles):
    """Writes a binary .ply without checks; vertices may be NaN."""
    vertices, triangles = np.asarray(vertices, "<f4"), np.asarray(triangles, "<i4").reshape(-1, 3)
    rows = np.zeros(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, triangles
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    pathlib.Path(path).write_bytes(head.encode() + vertices.tobytes() + rows.tobytes())
    return pathlib.Path(path)


def verdict(path):
    """Returns CGAL's verdict on a mesh file, and the mesh."""
    mesh = fieldfab.Mesh.load(path)
    return fieldfab.inspect(mesh), mesh


# Meshes, as (vertices, triangles).


def cube(side=20.0, at=(0, 0, 0)):
    corners = np.array([[x, y, z] for x in (0, side) for y in (0, side) for z in (0, side)], float) + np.asarray(at)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def sphere(rings=48, radius=20.0, at=(0, 0, 0)):
    """Returns a sphere of rings of quadrilaterals, each split into two triangles."""
    theta, phi = np.linspace(0, np.pi, rings + 1)[1:-1], np.arange(2 * rings) * np.pi / rings
    grid = np.stack([np.outer(np.sin(theta), np.cos(phi)), np.outer(np.sin(theta), np.sin(phi)),
                     np.outer(np.cos(theta), np.ones_like(phi))], -1).reshape(-1, 3)
    vertices = np.concatenate([[[0, 0, 1]], grid, [[0, 0, -1]]]) * radius + np.asarray(at)
    around, triangles = 2 * rings, []
    ring = lambda i, j: 1 + i * around + j % around
    for j in range(around):
        triangles += [(0, ring(0, j), ring(0, j + 1)), (len(vertices) - 1, ring(rings - 2, j + 1), ring(rings - 2, j))]
        for i in range(rings - 2):
            triangles += [(ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)),
                          (ring(i, j), ring(i + 1, j + 1), ring(i, j + 1))]
    return vertices, np.array(triangles)


def with_holes(mesh, count=6, radius=3.0, seed=1):
    """Returns the mesh without the triangles near `count` random points."""
    vertices, triangles = mesh
    middles, random = vertices[triangles].mean(1), np.random.default_rng(seed)
    keep = np.ones(len(triangles), bool)
    for place in middles[random.choice(len(middles), count, replace=False)]:
        keep &= np.linalg.norm(middles - place, axis=1) > radius
    return vertices, triangles[keep]


def figure_eight(radius=20.0, tube=5.0, around=240, across=48):
    """Returns a tube along a plane lemniscate; it intersects itself where the curve crosses itself."""
    t, p = np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across
    centre = radius * np.stack([np.sin(t), np.sin(t) * np.cos(t), 0 * t], -1)
    along = np.stack([np.cos(t), np.cos(2 * t), 0 * t], -1)
    along /= np.linalg.norm(along, axis=1)[:, None]
    side = np.stack([-along[:, 1], along[:, 0], 0 * t], -1)
    vertices = centre[:, None] + tube * (np.cos(p)[None, :, None] * side[:, None]
                                         + np.sin(p)[None, :, None] * np.array([0, 0, 1.0]))
    index = lambda i, j: (i % around) * across + j % across
    triangles = [t for i in range(around) for j in range(across)
                 for t in ((index(i, j), index(i + 1, j), index(i + 1, j + 1)),
                           (index(i, j), index(i + 1, j + 1), index(i, j + 1)))]
    triangles = np.array(triangles)
    vertices = vertices.reshape(-1, 3)
    outward = fieldfab.Mesh(np.float32(vertices), np.uint32(triangles)).volume > 0
    return vertices, triangles if outward else triangles[:, ::-1]


def joined(*meshes):
    vertices, triangles, count = [], [], 0
    for v, t in meshes:
        vertices.append(v)
        triangles.append(np.asarray(t) + count)
        count += len(v)
    return np.concatenate(vertices), np.concatenate(triangles)


def plates(count=6, thickness=1.0, side=40.0, gap=3.0):
    """Returns a stack of thin boxes, slightly rotated."""
    boxes = []
    for n in range(count):
        v, t = cube(1.0)
        boxes.append((v * np.array([side, side, thickness]) + np.array([0, 0, n * (thickness + gap)]), t))
    v, t = joined(*boxes)
    turn = np.array([[0.8, -0.6, 0], [0.48, 0.64, -0.6], [0.36, 0.48, 0.8]])
    return v @ turn.T, t


def scan(path, voxel=1.5):
    """Writes the head of the CT scan as a mesh of some 500,000 triangles."""
    fieldfab.mesh(fieldfab.load(DATA_CT / "cthead"), voxel=voxel).save(path)
    return path


DATA_CT = pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "data" / "ct"


class Window:
    """MeshLab's window on a separate screen, driven by keys. Its log goes to its stdout."""

    def __init__(self, home, screen, *files):
        self.home, self.env = pathlib.Path(home), environment(home, DISPLAY=screen)
        self.log = self.home / "window.log"
        self.process = subprocess.Popen([str(WINDOW), *map(str, files)], env=self.env, cwd=home,
                                        stdout=open(self.log, "w"), stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        self.wait_for("All files opened" if files else "gdp files", 90)
        time.sleep(1.5)
        self.window = max((self._width(each), each) for each in self._windows("MeshLab"))[1]
        self._do("windowsize", "--sync", self.window, "1400", "860", "windowmove", self.window, "0", "0")
        self.focus(self.window)

    def _do(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.env, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=60).stdout.decode()

    def _windows(self, name):
        return self._do("search", "--onlyvisible", "--name", name).split()

    def _width(self, window):
        return int(next(line for line in self._do("getwindowgeometry", "--shell", window).splitlines()
                        if line.startswith("WIDTH")).split("=")[1])

    def focus(self, window):
        self._do("windowfocus", "--sync", window)
        time.sleep(0.7)

    def keys(self, *names):
        self._do("key", "--delay", "60", *names)
        time.sleep(0.4)

    def click(self, x, y):
        self._do("mousemove", x, y, "click", "1")

    def type(self, text):
        self._do("type", "--delay", "40", text)
        time.sleep(0.5)

    def said(self):
        return self.log.read_text(errors="replace")

    def wait_for(self, words, seconds=60, times=1):
        """Waits until the log has these words `times` times. Raises AssertionError after `seconds`."""
        end = time.time() + seconds
        while self.said().count(words) < times:
            assert self.process.poll() is None, f"MeshLab has ended: {self.said()[-2000:]}"
            assert time.time() < end, f"'{words}' was not said: {self.said()[-2000:]}"
            time.sleep(0.1)

    def open_filter(self, name):
        """Opens a filter by MeshLab's search. Its dialog is then in front, with the focus on Apply."""
        self.focus(self.window)
        self.keys("ctrl+f")
        self.type(name.replace(":", "").split("(")[0])
        self.keys("Down", "Return")
        time.sleep(1)
        dialogs = self._windows(name.split("(")[0])
        if dialogs:
            self.focus(dialogs[-1])
        return dialogs

    def fill_in(self, rows_from_the_last):
        """Types values into the dialog: pairs of steps back from Apply, and text. Returns the focus to Apply."""
        more = {"2020": 0, "2022": 3}.get(VERSION[:4], 2)  # later dialogs have more places for the focus
        for steps, text in ((steps + more, text) for steps, text in rows_from_the_last):
            self.keys(*["shift+Tab"] * steps)
            if text == "Down":  # selects the next item of a list
                self.keys("Down")
            else:
                self.keys("ctrl+a")
                self.type(text)
            self.keys(*["Tab"] * steps)

    def aside(self):
        """Moves the dialog away from the mesh."""
        self._do("windowmove", self._do("getwindowfocus").strip(), "4", "500")
        time.sleep(0.5)

    def apply(self):
        self.keys("space")

    def picture(self, path):
        pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["import", "-window", "root", str(path)], env=self.env, check=True, timeout=60)

    def close(self):
        self.process.kill()
        self.process.wait()
