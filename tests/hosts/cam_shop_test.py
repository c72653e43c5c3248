"""Facing, chamfers, engraving and threads: jobs through the command, simulated, and read by LinuxCNC's interpreter."""

import math
import re

import pytest
from cam_test import job, run

import fieldfab as ff
import rs274

JOB = """
machine = "linuxcnc"
[input]
model = "part.frep"
{bounds}
[stock]
{stock}
[[tool]]
{tool}
[[operation]]
{operation}
"""
PLATE = ("difference(box(40, 30, 8), move(cylinder(1.5, 30), 9, 5, 0), move(cylinder(1.5, 30), -9, 5, 0), "
         "move(cylinder(1.5, 30), 0, -8, 0))")
V = 'shape = "v"\ndiameter = 8\nangle = 90\nflute = 10'
FLAT = 'diameter = {}\nflute = 30'


def job_text(part, **more):
    """Returns a job for a part whose first box is its outline: found bounds would be a little wider than it."""
    box = re.search(r"box\((\d+), (\d+), (\d+)\)", part)
    half = [int(size) / 2 for size in box.groups()] if box else None
    return JOB.format(bounds=f"bounds = {[-h for h in half] + half}" if half else "", **more)


def stock(x, y, low, high):
    """The table of a stock around the origin; margins are about the part's bounds, which are a little wider than it."""
    return f'coordinates = "model"\nlower = [{-x / 2}, {-y / 2}, {low}]\nupper = [{x / 2}, {y / 2}, {high}]'


def cut(folder, part, operation, tool, stock):
    """Returns the simulated stock's mesh and the program."""
    path = job(folder, job_text(part, operation=operation, tool=tool, stock=stock), part_frep=part)
    run("cam", path, "-o", folder / "out.ngc")
    run("simulate", folder / "out.ngc", "--setup", path, "-o", folder / "stock.stl", check=False)
    return ff.Mesh.load(folder / "stock.stl"), (folder / "out.ngc").read_text()


@pytest.mark.parametrize("more", ["", "both_ways = false", "angle = 30", "stepdown = 0.7\nallowance = 0.2"])
def test_facing_leaves_the_parts_top(tmp_path, more):
    left, program = cut(tmp_path, "box(40, 30, 10)", 'type = "face"\n' + more, FLAT.format(12), stock(46, 36, -5, 6.5))
    top = 5 + (0.2 if "allowance" in more else 0)
    assert left.vertices[:, 2].max() == pytest.approx(top, abs=1e-3)
    assert left.volume == pytest.approx(46 * 36 * (top + 5), rel=1e-3)


def test_facing_without_anything_above_the_part(tmp_path):
    path = job(tmp_path, job_text("box(40, 30, 10)", operation='type = "face"', tool=FLAT.format(12),
                                  stock=stock(46, 36, -5, 5)),
               part_frep="box(40, 30, 10)")
    assert "nothing to face" in run("cam", path, "-o", tmp_path / "out.ngc", check=False).stderr
    path = job(tmp_path, job_text("", operation='type = "face"', tool=FLAT.format(12), stock="thickness = 3"),
               part_frep="rectangle(40, 30)")
    assert "give the depth" in run("cam", path, "-o", tmp_path / "out.ngc", check=False).stderr


@pytest.mark.parametrize("beyond", [0.3, 1.2])
def test_a_chamfer_is_as_wide_as_asked(tmp_path, beyond):
    left, _ = cut(tmp_path, "box(40, 30, 10)", f'type = "chamfer"\nwidth = 1\nbeyond = {beyond}', V,
                  stock(40, 30, -5, 5))
    removed = 0.5 * 140 - 4 / 3  # a triangle along the edges, counted once in the corners
    assert 12000 - left.volume == pytest.approx(removed, rel=0.03)


def test_a_chamfer_of_a_hole(tmp_path):
    left, _ = cut(tmp_path, "difference(box(40, 30, 6), cylinder(8, 30))",
                  'type = "chamfer"\nwidth = 1\nbeyond = 0.4', V, stock(40, 30, -3, 3))
    # In a stock without the hole the tool cuts a groove of 2.8 x 1.4 mm around its axis, 7.6 mm from that of the hole.
    groove = 2 * math.pi * 7.6 * 1.4**2
    assert 7200 - left.volume == pytest.approx(0.5 * 140 - 4 / 3 + groove, rel=0.03)


def test_outlines_of_solids_are_as_exact_as_slices(tmp_path):
    """Without a slice the outline is the part's silhouette: arcs and lines, no stairs."""
    moves = {}
    for how in ("", "slice = 0\n"):
        path = job(tmp_path, job_text(PLATE, operation='type = "engrave"\n' + how, tool=FLAT.format(3),
                                        stock=stock(40, 30, -4, 4)), part_frep=PLATE)
        run("cam", path, "-o", tmp_path / "out.ngc")
        at, kinds, _ = rs274.moves_of_program(tmp_path / "out.ngc")
        cuts = at[at[:, 2] < 3.9]
        moves[how] = (len(cuts), cuts[:, 0].min(), cuts[:, 0].max(), kinds.count("ARC_FEED"))
    assert moves[""][0] <= moves["slice = 0\n"][0] + 4 and moves[""][3] >= 6
    assert moves[""][1:3] == pytest.approx(moves["slice = 0\n"][1:3], abs=1e-3)


def test_a_chamfer_wider_than_its_tool(tmp_path):
    path = job(tmp_path, job_text("", operation='type = "chamfer"\nwidth = 4', tool=V, stock=stock(40, 30, -5, 5)),
               part_frep="box(40, 30, 10)")
    assert "the tool's radius is 4 mm" in run("cam", path, "-o", tmp_path / "out.ngc", check=False).stderr


def test_engraving_follows_the_outline(tmp_path):
    left, _ = cut(tmp_path, "box(40, 30, 10)", 'type = "engrave"\ndepth = 1', V, stock(48, 38, -5, 5))
    assert 48 * 38 * 10 - left.volume == pytest.approx(140, rel=0.05)  # a V of 1 mm along the outline


@pytest.mark.parametrize("machine", ["linuxcnc", "mach3"])
@pytest.mark.parametrize("peck", ["", "peck = 2.1"])
def test_drilling_cycles_drill_what_single_moves_drill(tmp_path, machine, peck):
    programs, volumes, deepest = [], [], []
    for cycles in ("true", "false"):
        text = job_text(PLATE, operation=f'type = "drill"\n{peck}', tool=FLAT.format(3), stock=stock(40, 30, -4, 4))
        path = job(tmp_path, text.replace('"linuxcnc"', f'"{machine}"') + f"[setting]\ncycles = {cycles}\n",
                   part_frep=PLATE)
        run("cam", path, "-o", tmp_path / "out.ngc")
        told = run("simulate", tmp_path / "out.ngc", "--setup", path, "-o", tmp_path / "stock.stl").stdout
        assert "nothing is wrong" in told
        programs.append((tmp_path / "out.ngc").read_text())
        volumes.append(ff.Mesh.load(tmp_path / "stock.stl").volume)
        if machine == "linuxcnc":
            ends = rs274.moves_of_program(tmp_path / "out.ngc")[0]
            deepest.append(sorted({(round(x, 3), round(y, 3)) for x, y, z in ends[:, :3] if z < -3.9}))
    word = "G83" if peck else "G81"
    assert programs[0].count(f"G98 {word} ") == 3 and (" Q2 " in programs[0]) == bool(peck), programs[0]
    assert "G81" not in programs[1] and "G83" not in programs[1]
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-9)
    if deepest:
        assert deepest[0] == deepest[1] == [(-9, 5), (0, -8), (9, 5)]


def test_a_thread_is_a_helix(tmp_path):
    path = job(tmp_path, job_text("", operation='type = "thread"\npitch = 1\ndiameter = 6', tool=FLAT.format(3.6),
                                    stock=stock(40, 30, -4, 4)),
               part_frep="difference(box(40, 30, 8), move(cylinder(2.5, 30), 7, 4, 0), "
                         "move(cylinder(4, 30), -8, 0, 0))")
    run("cam", path, "-o", tmp_path / "out.ngc")
    program = (tmp_path / "out.ngc").read_text()
    arcs = re.findall(r"^(?:N\d+ )?G3 .*$|^X.*I.*$", program, re.M)
    assert len(arcs) >= 16, program
    xs = [float(x) for line in arcs for x in re.findall(r"X(-?[\d.]+)", line)]
    assert min(xs) == pytest.approx(7 - 1.2, abs=0.02) and max(xs) == pytest.approx(7 + 1.2, abs=0.02)
    path = job(tmp_path, job_text("", operation='type = "thread"\npitch = 1\ndiameter = 12', tool=FLAT.format(3.6),
                                    stock=stock(40, 30, -4, 4)),
               part_frep="difference(box(40, 30, 8), cylinder(2.5, 30))")
    assert "no " in run("cam", path, "-o", tmp_path / "out.ngc", check=False).stderr


def test_speeds_follow_from_the_chip_load_of_a_material(tmp_path):
    """Where neither job nor tool nor machine says anything else; a machine's own material is only what it says."""
    def words(material, tool, operation="", machine="linuxcnc", head=""):
        text = job_text("box(40, 30, 10)", operation='type = "face"\n' + operation, tool=tool,
                        stock=stock(46, 36, -5, 6)).replace('"linuxcnc"', f'"{machine}"\nmaterial = "{material}"')
        path = job(tmp_path, text, part_frep="box(40, 30, 10)")
        run("cam", path, "-o", tmp_path / "out.ngc")
        program = (tmp_path / "out.ngc").read_text()
        return (max(float(each) for each in re.findall(r"F([\d.]+)", program)),
                float(re.search(r"S([\d.]+)", program)[1]))

    tool = FLAT.format(6.35) + "\nflutes = 1"
    values = ff.cam.cutting_values("linuxcnc", "aluminium", 6.35, 1)
    feed, spindle = words("aluminium", tool)
    assert (feed, spindle) == (values["feed"], values["spindle"])
    assert abs(feed - spindle * 0.127) < 1 and 120 <= spindle * math.pi * 6.35e-3 <= 250
    feed, spindle = words("plywood", FLAT.format(12.7) + "\nflutes = 2")
    assert feed == 3000 and abs(spindle * math.pi * 12.7e-3 - 300) < 1, "LinuxCNC's mill feeds no faster"
    assert words("aluminium", tool + "\nspindle = 9000") == (int(9000 * 0.127), 9000)
    assert words("aluminium", tool, "feed = 400") == (400, values["spindle"])
    (tmp_path / "mine.toml").write_text(
        'name = "Mine"\nextension = ".ngc"\n[material.aluminium]\nfeed = 77\n[text]\nspindle_on = "M3 S{rpm}\\n"\n'
        'line = "G1[ X{x}][ Y{y}][ Z{z}][ F{f}]\\n"\nrapid = "G0[ X{x}][ Y{y}][ Z{z}]\\n"\n')
    assert words("aluminium", tool, machine="mine.toml") == (77, 10000), "its own feed, and no other value"
    assert ff.cam.cutting_values("epilog", "acrylic", 3) == {} == ff.cam.cutting_values("linuxcnc", "", 3)
    assert "aluminium" in ff.cam.machine("linuxcnc")["materials"]
    assert "hardwood" not in ff.cam.machine("epilog")["materials"]


SLOTTED = ("box(60, 40, 6) - box(30, 6, 20) - move(cylinder(3, 20), 15, 0, 0) - move(cylinder(3, 20), -15, 0, 0)"
           " - move(box(6, 16, 20), 20, 16, 0)")  # an obround slot, and one that is open at its end


def test_slots_as_wide_as_the_tool(tmp_path):
    """Nothing is left in them, and nothing else is cut. The open one is cut beyond the part's edge."""
    left, program = cut(tmp_path, SLOTTED, 'type = "slot"\ndepth = 6\nstepdown = 2', FLAT.format(6),
                        stock(60, 40, -3, 3))
    obround, notch = 30 * 6 + math.pi * 9, 6 * 12 - (18 - math.pi * 9 / 2)  # the notch's end is round
    assert left.volume == pytest.approx(6 * (60 * 40 - obround - notch), rel=2e-3)
    places, _, _ = rs274.moves(tmp_path / "out.ngc", tools=((1, 0, 6),))
    assert min(place[2] for place in places) == pytest.approx(-3)


def test_slots_that_do_not_fit_are_told(tmp_path):
    def told(tool, more=""):
        path = job(tmp_path, job_text(SLOTTED, operation='type = "slot"\ndepth = 6\n' + more, tool=FLAT.format(tool),
                                      stock=stock(60, 40, -3, 3)), part_frep=SLOTTED)
        return run("cam", path, "-o", tmp_path / "out.ngc", check=False)

    assert "no slot is between 5 and 5.25 mm wide" in told(5).stderr
    assert "no slot is between 8 and" in told(8).stderr
    wide = told(5, "widest = 6.2")
    assert wide.returncode == 0
    assert "is wider than the tool of 5 mm: its sides keep material" in wide.stderr + wide.stdout
