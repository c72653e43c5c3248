"""Playback of simulations from Python: stock, tool and axes at any time, surfaces for drawing."""

import math

import numpy as np
import pytest

import fieldfab as ff

SETUP = """machine = "{machine}"
cell = 0.25
[stock]
lower = [-20, -15, -30]
upper = [20, 15, 0]
[[tool]]
number = 1
shape = "flat"
diameter = 6
flute = 12
length = 30
shank = 6
holder_diameter = 20
holder_length = 25
"""
THREE_AXES = "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-12 Y0 Z5\nG1 Z-3 F600\nG1 X12 F600\nG3 X-12 I-12 J0\nG0 Z5\nM2\n"


@pytest.fixture
def simulated(tmp_path):
    def make(machine="linuxcnc", program=THREE_AXES):
        (tmp_path / "set_up.toml").write_text(SETUP.format(machine=machine))
        (tmp_path / "part.ngc").write_text(program)
        return ff.stock.Simulation(tmp_path / "set_up.toml", tmp_path / "part.ngc", remember=True)

    return make


def test_the_middle_of_a_move_has_half_of_its_slot(simulated):
    simulation = simulated()
    playback, whole = simulation.playback, 40 * 30 * 30
    end = playback.seconds[playback.done_after_line(6) - 1]
    for share in (0.0, 0.25, 0.5, 1.0):
        moment = playback.at(end - 2.4 * (1 - share) - 1e-9)
        x = -12 + 24 * share
        assert (moment["tip"] == pytest.approx([x, 0, -3], abs=1e-6)
                and moment["axes"][:3] == pytest.approx([x, 0, -3], abs=1e-6))
        assert moment["line"] == (6 if share else 5) and moment["tool"] == 1 and not moment["rapid"]
        gone = whole - playback.stock_at(end - 2.4 * (1 - share)).mesh().volume
        assert gone == pytest.approx(3 * (math.pi * 9 + 6 * 24 * share), rel=2e-3)
    # After half of an arc's time tool and axes are at its top.
    top = playback.at((end + playback.seconds[playback.done_after_line(7) - 1]) / 2)
    assert top["tip"] == pytest.approx([0, 12, -3], abs=0.01) and top["axes"][:3] == pytest.approx(top["tip"], abs=1e-6)


def test_the_tool_has_its_parts(simulated):
    playback = simulated().playback
    cutter, shank, holder = (playback.tool_mesh(3, role) for role in ("cutting", "shank", "holder"))
    for mesh, low, high, radius in ((cutter, 0, 12, 3), (shank, 12, 30, 3), (holder, 30, 55, 10)):
        assert mesh.vertices[:, 2].min() == low and mesh.vertices[:, 2].max() == high
        assert np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1]).max() == pytest.approx(radius, rel=1e-5)
    with pytest.raises(ff.Error, match="cutting, shank or holder"):
        playback.tool_mesh(3, "handle")


def test_tables_turn_the_work_below_an_upright_tool(simulated):
    simulation = simulated("five_axis_ac", "G21 G90\nT1 M6\nS5000 M3\nG0 X0 Y0 Z30\nG0 A30 C40\nG1 Z25 F500\nM2\n")
    moment = simulation.playback.at(1e9)
    assert (simulation.axes == "XYZAC" and moment["axes"][3] == pytest.approx(30)
            and moment["axes"][5] == pytest.approx(40))
    turn = simulation.turn_of_work(moment["axes"])
    assert turn[:3, :3] @ moment["axis"] == pytest.approx([0, 0, 1], abs=1e-12)
    assert (turn @ [*moment["tip"], 1])[:3] == pytest.approx([0, 0, 25], abs=1e-9)
    assert simulation.turn_of_work([5, 6, 7, 0, 0, 0, 0, 0, 0]) == pytest.approx(np.eye(4))


@pytest.mark.parametrize("coarse", [1, 2, 3])
def test_drawn_pieces_meet_without_gaps_and_have_fewer_triangles(simulated, coarse):
    simulation = simulated()
    surface, mesh = ff.stock.Surface(), simulation.mesh
    pieces = surface.to_draw(surface.update(simulation.stock), coarse)
    assert len(pieces) == len(surface) > 4
    corners, start, places = [], 0, []
    for vertices, normals, triangles, cuts in pieces:
        assert (len(vertices) == len(normals) == len(cuts) and (triangles[:, 3] == -1).all()
                and np.linalg.norm(normals, axis=1) == pytest.approx(1, abs=1e-4))
        corners.append(triangles[:, :3] + start)
        places.append(vertices)
        start += len(vertices)
    places, same = np.unique(np.concatenate(places), axis=0, return_inverse=True)
    corners = same.reshape(-1)[np.concatenate(corners)]
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    there, back = (np.sort(edges[:, i].astype(np.int64) * len(places) + edges[:, 1 - i]) for i in (0, 1))
    assert (there == back).all(), "each edge is passed as often in both directions"
    a, b, c = (places[corners[:, k]].astype(float) for k in range(3))
    volume = (a * np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(mesh.volume, rel=1e-4 if coarse == 1 else 5e-3)
    assert len(corners) < sum(len(surface.piece(i).triangles)
                              for i in range(len(surface))) * {1: 0.35, 2: 0.2, 3: 0.15}[coarse]


def test_cuts_tell_their_lines_and_tools(simulated):
    simulation = simulated()
    surface = ff.stock.Surface()
    for vertices, _, _, cuts in surface.to_draw(surface.update(simulation.stock)):
        lines, tools = simulation.lines_of_cuts[cuts], simulation.tools_of_cuts[cuts]
        assert ((lines == 0) == (tools == 0)).all() and (lines[vertices[:, 2] < -3.1] == 0).all()
        floor = (vertices[:, 2] == -3) & (np.abs(vertices[:, 1]) < 2.5) & (np.abs(vertices[:, 0]) < 8)
        assert (lines[floor] == 6).all()
    assert set(simulation.colours_of_tools) == {0, 1} and simulation.deviation_scale is None


def test_stock_and_target_may_be_given(tmp_path, simulated):
    simulated()
    half = ff.Solid(ff.shapes.box(40, 30, 30)).translate(20, 0, -15)
    simulation = ff.stock.Simulation(tmp_path / "set_up.toml", tmp_path / "part.ngc", stock=half, target=half, cell=0.5)
    assert simulation.mesh.vertices[:, 0].min() == pytest.approx(0, abs=0.01)
    scale = simulation.deviation_scale
    assert 0 < scale["gouge"] < scale["full"] and simulation.stock_box == (-20, -15, -30, 20, 15, 0)
    red, grey, blue = (simulation.colour_of_deviation(d) for d in (-scale["full"], 0, scale["full"]))
    assert red[0] > red[2] and blue[2] > blue[0] and len(set(grey)) <= 2
