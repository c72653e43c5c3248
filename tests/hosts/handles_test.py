"""fieldfab.handles: where the numbers of a text move its surface, against closed forms."""

import math
import sys

import pytest

from conftest import BUILD

sys.path.insert(0, str(BUILD / "python"))
from fieldfab import Error, parse
from fieldfab.handles import handles, numbers, with_number, written


def of(text):
    return {text[h.number.offset:h.number.offset + h.number.length] + (h.number.name and f" {h.number.name}"): h
            for h in handles(text)}


def holds(handle, at, along, rate, near=0.9):
    assert math.dist(handle.at, at) < near, handle
    assert math.dist(handle.along, along) < 0.02, handle
    assert handle.rate == pytest.approx(rate, rel=0.02)


def test_sizes_are_on_faces():
    found = of("box(20, 30.5, 41)")
    holds(found["20"], (10, 0, 0), (1, 0, 0), 0.5)
    holds(found["30.5"], (0, 15.25, 0), (0, 1, 0), 0.5)
    holds(found["41"], (0, 0, 20.5), (0, 0, 1), 0.5)
    holds(of("sphere(5)")["5"], (5, 0, 0), (1, 0, 0), 1)


def test_moves_are_in_the_middle_of_what_they_move():
    found = of("box(60, 60, 2) | move(sphere(5), 10, -12, 30)")
    holds(found["10"], (10, -12, 30), (1, 0, 0), 1)
    holds(found["-12"], (10, -12, 30), (0, 1, 0), 1)
    holds(found["30"], (10, -12, 30), (0, 0, 1), 1)
    holds(found["5"], (15, -12, 30), (1, 0, 0), 1)


def test_turned_moves_go_where_they_lead():
    holds(of("rotate_z(move(box(4, 6, 8), 11, 0, 0), 90)")["11"], (0, 11, 0), (0, 1, 0), 1)
    turned = of("rotate_z(move(box(4, 6, 8), 11, 0, 0), 30)")["11"]
    holds(turned, (11 * math.cos(math.pi / 6), 11 * math.sin(math.pi / 6), 0),
          (math.cos(math.pi / 6), math.sin(math.pi / 6), 0), 1)


def test_a_hole_grows_away_from_its_axis():
    handle = of("difference(box(40, 40, 10), move(cylinder(4, 30), 9, 3, 0))")["4"]
    out = (handle.at[0] - 9, handle.at[1] - 3)
    assert math.hypot(*out) == pytest.approx(4, abs=0.2) and handle.rate == pytest.approx(1, rel=0.03)
    assert (out[0] * handle.along[0] + out[1] * handle.along[1]) / 4 > 0.9


def test_parameters_are_numbers_with_names():
    found = of("width = 24  # 5 to 40\nbox(width, 2 * width, 7)")
    holds(found["24 width"], (0, 24, 0), (0, 1, 0), 1)  # the face that moves fastest


def test_numbers_that_move_nothing_have_no_handle():
    found = of("spare = 3\nunion(sphere(5), move(sphere(1), 0.5, 0, 0))")
    assert "3 spare" not in found and "0.5" not in found and "5" in found


def test_numbers_of_a_text():
    text = 'a = -2.5  # 1 to 3\nmove(box(3, 4 - 1, 5), -1e1, a, 2)\nopen("scan.nii", threshold = 300) | sphere(ä = 1)'
    assert [n.value for n in numbers(text)] == [-2.5, 3, 4, 1, 5, -10, 2, 1]
    assert [n.name for n in numbers(text)][:2] == ["a", ""]
    data = text.encode()
    for n in numbers(text):
        assert float(data[n.offset:n.offset + n.length]) == n.value
    assert with_number("sphere(5) # ä", numbers("sphere(5)")[0], 6) == "sphere(6) # ä"
    assert (written(3.0), written(-0.25), written(0.1 + 0.2)) == ("3", "-0.25", "0.30000000000000004")


@pytest.mark.parametrize("text", ["x", "sphere(", "circle(3) + nonsense"])
def test_texts_without_a_solid_are_errors(text):
    with pytest.raises(Error):
        handles(text)


def test_every_handle_follows_the_surface():
    """The surface is at the end of each arrow after the number has changed."""
    text = ("length = 40  # 20 to 80\nplate = rounded_box(length, 24, 6, 2)\n"
            "boss = move(cylinder(5, 8), 0.3 * length, 0, 5)\n"
            "difference(plate | boss, move(cylinder(2.5, 40), 0.3 * length, 0, 0), move(box(8, 8, 20), -9, 3, 0))")
    found = handles(text)
    assert len(found) >= 10
    moved = 0
    for handle in found:
        grown = parse(with_number(text, handle.number, handle.number.value + 0.1))
        before, after = parse(text), handle.rate * 0.1
        there = [at + along * after for at, along in zip(handle.at, handle.along)]
        if abs(before.value(*handle.at)) < 0.05:  # on the surface, not in the middle of what moves
            assert abs(grown.value(*there)) < 0.08, handle
            moved += 1
    assert moved >= 5
