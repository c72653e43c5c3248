"""Jobs of the Machine view, in a worker: planning and simulation by fieldfab.cam, with drawings for the page."""

import json
import math
import os

import numpy as np

import fieldfab as ff

from .models import Mistakes

STILLS = 20  # number of surfaces of the stock over time
POSES = 400  # number of positions of the tool over time
COARSE = 4  # cells per side that are merged in the drawn stock
ROLES = ("cutting", "shank", "holder")


def tables():
    """Returns the tables for the panels: machines, operations with the settings of their stages, and the settings that
    join their paths."""
    stages = {each["name"]: each for each in ff.cam.stages()}
    operations = [{"name": name, "help": each["help"],
                   "settings": [setting for stage in ff.cam.chain("solid", name)
                                for setting in stages[stage]["settings"]]}
                  for name, each in stages.items() if each["operation"]]
    return {"machines": [ff.cam.machine(each) for each in ff.cam.machines()], "operations": operations,
            "joining": ff.cam.joining_settings()}


def toml_value(value):
    return json.dumps(value, ensure_ascii=False) if isinstance(value, (str, bool)) else f"{value:.9g}"


def toml_of(job, model=None):
    """Returns a job file for `fieldfab cam`, for a model's file or a given part. Names and values were checked: none is
    a path."""
    def table(head, values):
        return [head, *(f"{name} = {toml_value(value)}" for name, value in values.items()), ""]

    lines = [f"machine = {toml_value(job['machine'])}"]
    if job["material"]:
        lines.append(f"material = {toml_value(job['material'])}")
    lines += ["", "[input]", *([f"model = {toml_value(model)}"] if model else []), f"zero = {toml_value(job['zero'])}",
              "", *table("[stock]", job["stock"])]
    if job["setting"]:
        lines += table("[setting]", job["setting"])
    if job["adjust_feeds"]:
        lines += table("[feeds]", {})
    for name, tables_of_it in (("tool", job["tools"]), ("operation", job["operations"])):
        for values in tables_of_it:
            lines += table(f"[[{name}]]", values)
    return "\n".join(lines)


class Drawing:
    """Consecutive arrays in a binary file for the page. Each is described by its offset and sizes."""

    def __init__(self, path):
        self._file, self._at = open(path, "wb"), 0

    def close(self):
        self._file.close()

    def _add(self, array):
        start, data = self._at, np.ascontiguousarray(array).tobytes()
        data += bytes(-len(data) % 4)
        self._file.write(data)
        self._at += len(data)
        return start

    def lines(self, rows):
        return {"at": self._add(rows.astype("<f4")), "count": len(rows)}

    def surface(self, vertices, normals, corners, colours=None):
        """Adds a mesh. Normals and colours have four bytes each (the last is padding), indices two bytes if they
        fit."""
        four = np.zeros((len(vertices), 4), np.int8)
        four[:, :3] = np.rint(127 * normals)
        told = {"vertices": len(vertices), "triangles": len(corners), "at": self._add(vertices.astype("<f4")),
                "normals": self._add(four),
                "corners": self._add(corners[:, :3].astype("<u2" if len(vertices) < 65536 else "<u4"))}
        if colours is not None:
            told["colours"] = self._add(np.hstack([colours, np.full((len(colours), 1), 255)]).astype(np.uint8))
        return told


def bent(start, end, bulge):
    """Returns points along an arc, without its start. `bulge`: tangent of a quarter of its angle, anticlockwise."""
    angle, chord = 4 * math.atan(bulge), end[:2] - start[:2]
    count = max(1, math.ceil(abs(angle) / 0.2))
    centre = (start[:2] + end[:2]) / 2 + np.array([-chord[1], chord[0]]) * (1 - bulge * bulge) / (4 * bulge)
    shares = np.arange(1, count + 1) / count
    arm = start[:2] - centre
    turns = shares * angle
    xy = centre + np.stack([np.cos(turns) * arm[0] - np.sin(turns) * arm[1],
                            np.sin(turns) * arm[0] + np.cos(turns) * arm[1]], axis=1)
    return np.column_stack([xy, start[2] + shares * (end[2] - start[2])])


def ways_of(job):
    """Returns for each operation (rapids, cuts): ends of straight segments in model coordinates, two rows per
    segment."""
    found = []
    for moves in job.moves:
        places = moves[:, :3] + np.array(job.zero)
        pieces = ([], [])
        for i in range(1, len(places)):
            rapid, bulge = moves[i, 3] == 0, moves[i, 4]
            way = bent(places[i - 1], places[i], bulge) if bulge and moves[i, 7] == 1 else places[i : i + 1]
            ends = np.vstack([places[i - 1 : i], way])
            pieces[0 if rapid else 1].append(np.repeat(ends, 2, axis=0)[1:-1])
        found.append(tuple(np.vstack(each) if each else np.empty((0, 3)) for each in pieces))
    return found


def plan(solid, job, into, progress):
    """Writes the program, sheet.html, job.toml for `fieldfab cam`, and the tools' paths as ways.json and .bin. Returns
    the values of the answer."""
    text = toml_of(job)
    for name, content in (("setup.toml", text), ("job.toml", toml_of(job, "part.frep"))):
        with open(os.path.join(into, name), "w", encoding="utf-8") as file:
            file.write(content)
    planned = ff.cam.Job.parse(text, solid, "the job", progress=progress)
    planned.run(progress=progress)
    program = "program" + ff.cam.machine(job["machine"])["extension"]
    planned.save(os.path.join(into, program))
    planned.sheet(os.path.join(into, "sheet.html"))
    drawing = Drawing(os.path.join(into, "ways.bin"))
    told = {"ways": [{"rapids": drawing.lines(rapids), "cuts": drawing.lines(cuts)}
                     for rapids, cuts in ways_of(planned)]}
    drawing.close()
    with open(os.path.join(into, "ways.json"), "w", encoding="utf-8") as file:
        json.dump(told, file)
    reports = [{name: each[name] for name in ("name", "cut", "rapid", "seconds")} for each in planned.reports]
    low, high = np.array(planned.stock[:3]) + planned.zero, np.array(planned.stock[3:]) + planned.zero
    return {"program": program, "notes": planned.notes, "reports": reports,
            "seconds": sum(each["seconds"] for each in reports),
            "planned_seconds": sum(each["planned_seconds"] for each in planned.reports),
            "stock": [*low.tolist(), *high.tolist()]}


def tool_parts(playback, drawing):
    """Returns the drawing of each tool by its number."""
    found, tools = {}, playback.tools
    for number in np.unique(tools):
        move = int(np.argmax(tools == number))
        parts = {role: ff.stock.to_draw(playback.tool_mesh(move, role)) for role in ROLES}
        found[int(number)] = {role: drawing.surface(*part) for role, part in parts.items() if len(part[0])}
    return found


def simulate(solid, program, into, progress):
    """Simulates the program. Writes report.html, and stock and tool over time as stock.json and .bin. Returns the
    values of the answer."""
    done = ff.stock.Simulation(os.path.join(into, "setup.toml"), os.path.join(into, program), part=solid, remember=True,
                               progress=lambda share, words: progress(0.6 * share, words))
    done.html(os.path.join(into, "report.html"))
    playback, surface, drawing = done.playback, ff.stock.Surface(), Drawing(os.path.join(into, "stock.bin"))
    if len(playback) == 0:
        raise Mistakes("the program moves nothing")
    colours = np.array([done.colours_of_tools.get(int(tool), (150, 150, 150))
                        for tool in range(int(done.tools_of_cuts.max()) + 1)], np.uint8)
    end, stills, poses = float(playback.seconds[-1]), [], []
    for i in range(STILLS + 1):
        progress(0.6 + 0.4 * i / STILLS, "pictures of the stock")
        changed = surface.update(playback.stock_at(end * i / STILLS))
        pieces = surface.to_draw(changed, COARSE)
        stills.append({"seconds": end * i / STILLS, "pieces": [{"piece": index, **drawing.surface(
            v, n, c, colours[done.tools_of_cuts[cuts]])} for index, (v, n, c, cuts) in zip(changed, pieces)]})
    for i in range(POSES + 1):
        at = playback.at(end * i / POSES)
        poses.append([*at["tip"], *at["axis"], at["tool"], at["line"]])
    told = {"seconds": end, "stills": stills, "poses": poses, "tools": tool_parts(playback, drawing)}
    drawing.close()
    with open(os.path.join(into, "stock.json"), "w", encoding="utf-8") as file:
        json.dump(told, file)
    report = done.report
    events = [{name: each[name] for name in ("kind", "line", "amount") if name in each}
              for each in report["events"][:100]]
    return {"good": bool(done.good), "events": events, "simulated": report["seconds"], "removed": report["removed"],
            "deviation": report.get("deviation")}


def machine(model, request, progress):
    """Plans a job, and simulates it on request."""
    job, into, both = request["job"], request["into"], request["simulate"]
    solid = model.solid
    told = plan(solid, job, into, (lambda share, words: progress(0.5 * share, words)) if both else progress)
    if both:
        told |= simulate(solid, told["program"], into, lambda share, words: progress(0.5 + 0.5 * share, words))
    return told
