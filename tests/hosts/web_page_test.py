"""fabserver's page in a real browser: typing, dragging nodes, changing their code, undo, reloading, and a server that
is killed."""

import json
import math
import re
import socket
import time

import numpy as np
import pytest
from documents import DOCUMENTS
from rs274 import moves
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from volume_test import dicom
from web_page import CIRCLE, POINT, browser, folder, nodes_of, page, server, set_value, sheet
from web_server import Server

import fieldfab as ff


def test_text_and_picture(page, folder):
    """Typing updates the picture at once. An error is marked at its position, and the last picture stays. A slider
    changes the text."""
    (folder / "part.frep").write_text("r = 5  # 1 to 9, radius\ncircle(r)\n")
    page.open("part.frep")
    page.settled()
    page.script("localStorage.setItem('fabserver hint', 'seen')")
    assert abs(page.coloured() - math.pi * 25) < 2
    page.type("#editor", Keys.CONTROL + Keys.END, Keys.BACKSPACE * 3, "r) - circlee(2)")
    page.until(lambda: "Line 2, column 13: unknown function 'circlee'; did you mean 'circle'?" in page.text("#message"),
               "the mistake")
    page.until(lambda: page.find(".cm-lintRange-error").text == "circlee", "the mark at the mistake")
    assert page.coloured() > 50, "the last picture stays"
    page.shot("web_error")
    page.type("#editor", Keys.CONTROL + "a", "r = 5  # 1 to 9, radius\ncircle(r) - circle(2)")
    page.until(lambda: not page.find("#message").is_displayed(), "no mistake")
    page.settled()
    assert abs(page.coloured() - math.pi * 21) < 2
    page.script(
        "const bar = document.querySelector('#sliders input'); bar.value = 4; bar.dispatchEvent(new Event('input'))")
    page.until(lambda: abs(page.coloured() - math.pi * 12) < 1, "the slider's picture")
    page.saved()
    assert (folder / "part.frep").read_text() == "r = 4  # 1 to 9, radius\ncircle(r) - circle(2)"


def test_turning_and_zooming(page, folder):
    """The visible window is requested anew, to the pixel; zooming keeps the point below the pointer."""
    (folder / "solid.frep").write_text("box(20, 12, 6) - move(cylinder(2, 20), 5)\n")
    page.open("solid.frep")
    page.settled()
    first = page.picture()
    host = page.find("#picture")
    ActionChains(page.browser).click_and_hold(host).move_by_offset(60, 20).release().perform()
    page.settled()
    turned = page.picture()
    assert turned != first
    host.send_keys("2")
    page.settled()
    box = page.script("const b = document.querySelector('#picture').getBoundingClientRect(); "
                      "return [b.left, b.top, b.width, b.height]")
    wheel = ("document.querySelector('#picture').dispatchEvent(new WheelEvent('wheel', { deltaY: arguments[2], "
             "clientX: arguments[0], clientY: arguments[1], cancelable: true }))")
    scale = float(host.get_attribute("data-scale"))
    page.script(wheel, box[0] + box[2] / 4, box[1] + box[3] / 4, -400)
    page.settled()
    assert float(host.get_attribute("data-scale")) < 0.6 * scale
    host.send_keys("f")
    page.settled()
    assert abs(float(host.get_attribute("data-scale")) / scale - 1) < 0.01
    page.find("#mode option[value=bitmap]").click()
    page.settled()
    assert abs(page.coloured() - (240 - math.pi * 4)) < 4
    bar = "const e = document.querySelector('#section-at'); e.value = arguments[0]; e.dispatchEvent(new Event('input'))"
    page.script(bar, 1000)  # above the box
    page.until(lambda: page.coloured() == 0, "an empty slice")
    page.script(bar, 700)
    page.until(lambda: page.coloured() > 200, "a slice near the top")


def test_a_point_of_the_model_is_dragged(page, folder):
    """Parameters NAME_x and NAME_y make a handle: in a flat model, in the plane of a solid, by keys; undone."""
    file = folder / "hole.frep"
    text = ("hole_x = 0  # -15 to 15, the hole\nhole_y = 0  # -8 to 8\n"
            "rectangle(40, 20) - move(circle(3), hole_x, hole_y)\n")
    file.write_text(text)
    page.open("hole.frep")
    page.settled()
    assert abs(page.coloured() - (800 - math.pi * 9)) < 9
    scale = float(page.find("#picture").get_attribute("data-scale"))

    def values():
        return [float(each) for each in re.findall(r"= (-?[\d.]+)", file.read_text())]

    def drag(dx, dy):
        ActionChains(page.browser).click_and_hold(page.find(".handle")).move_by_offset(dx // 2, dy // 2).move_by_offset(
            dx - dx // 2, dy - dy // 2).release().perform()

    drag(round(10 / scale), round(-5 / scale))
    page.until(lambda: np.allclose(values(), (10, 5), atol=scale), "the hole's place")
    page.settled()
    assert abs(page.coloured() - (800 - math.pi * 9)) < 9
    page.shot("web_handle")
    drag(round(8 / scale), 0)
    page.until(lambda: values()[0] == 15, "the end of its range")
    page.find(".handle").send_keys(Keys.ARROW_DOWN)
    page.until(lambda: values()[1] < 5 - scale, "a move by a key")
    for _ in range(12):  # moves within half a second are one step
        page.find("#undo").click()
    page.until(lambda: file.read_text() == text, "all undone")

    page.type("#editor", Keys.CONTROL + "a", "pin_x = 4  # -9 to 9\npin_y = 2  # -9 to 9\npin_z = 3  # 0 to 9\n"
              "box(20, 20, 1) | move(sphere(2), pin_x, pin_y, pin_z)")
    page.until(lambda: page.find(".handle").get_attribute("title") == "pin: drag it", "the pin's handle")
    page.find("#picture").send_keys("3")  # from the front: x to the right, z up
    page.settled()
    scale = float(page.find("#picture").get_attribute("data-scale"))
    drag(round(-6 / scale), round(-4 / scale))
    page.until(lambda: np.allclose(values(), (-2, 2, 7), atol=1.1 * scale), "x and z, not y")
    page.find("#perspective").click()
    page.settled()
    page.find("#picture").send_keys("1")
    page.settled()
    assert page.find(".handle").is_displayed()
    x, y, _ = values()
    drag(40, 0)
    page.until(lambda: abs(values()[0] - x) > scale, "the pin, moved in a perspective view")
    page.settled()
    centre = ("const h = document.querySelector('.handle').getBoundingClientRect(), "
              "c = document.querySelector('#picture').getBoundingClientRect(); "
              "return [h.left + h.width / 2 - c.left - c.width / 2, h.top + h.height / 2 - c.top - c.height / 2]")
    at = [round(each) for each in page.script(centre)]
    page.script("document.querySelector('.handles').hidden = true")
    ActionChains(page.browser).move_to_element_with_offset(page.find("#picture"), *at).click().perform()
    page.until(lambda: page.text("#picture .told").endswith("mm"), "the point below the handle")
    seen = [float(each) for each in page.text("#picture .told").removesuffix(" mm").split(", ")]
    assert math.dist(seen, values()) < 2.3, "the handle is over its ball, whose radius is 2 mm"


def test_measuring_sections_parts_and_files(page, folder, tmp_path):
    """Two clicks measure; a section plane shows the inside; a click names a part, in its colour; a file is written."""
    (folder / "parts.frep").write_text('part(move(box(20, 20, 20), -12), "left", "red")\n'
                                       'part(move(box(20, 20, 20), 12), "right", "blue")\n')
    page.open("parts.frep")
    page.settled()
    host = page.find("#picture")
    host.send_keys("2")
    page.settled()
    scale = float(host.get_attribute("data-scale"))

    def click(x, y):
        to = round(x / scale), round(-y / scale)
        ActionChains(page.browser).move_to_element_with_offset(host, *to).click().perform()

    click(-10, 5)
    page.until(lambda: page.text("#picture .told").startswith("left: -1"), "the left part")
    click(10, 5)
    page.until(lambda: page.text("#picture .told").startswith("right: "), "the right part")
    colour = page.script("const c = document.querySelector('#picture canvas'); "
                         "return [...c.getContext('2d').getImageData(c.width / 2 - 30, c.height / 2, 1, 1).data]")
    assert colour[0] > 1.5 * colour[2], "red"
    host.send_keys("m")
    click(-10, -5)
    page.until(lambda: page.text("#picture .told"), "the first point")
    click(10, 5)
    page.until(lambda: " mm (" in page.text("#picture .told"), "a distance")
    distance = float(page.text("#picture .told").split()[0])
    assert abs(distance - math.hypot(20, 10)) < 3 * scale
    page.shot("web_measure")
    host.send_keys("m")
    before = page.picture()
    page.find("#section option[value=z]").click()
    page.until(lambda: page.find("#section-at").is_displayed(), "the plane's slider")
    page.settled()
    assert page.picture() != before
    page.find("#section-at").send_keys(Keys.ARROW_LEFT)
    page.settled()

    page.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(tmp_path)})
    page.act("#download", "stl")
    page.until(lambda: (tmp_path / "parts.stl").exists(), "the file, with the document's name")
    page.until(lambda: abs(ff.Mesh.load(tmp_path / "parts.stl").volume - 16_000) < 20, "its volume")


def test_phones(page, folder):
    """A narrow page stacks its panes; nothing is wider than the screen; a finger turns the model, two zoom."""
    (folder / "phone.frep").write_text("box(20, 12, 6) - move(cylinder(2, 20), 5)\n")
    screen = {"width": 390, "height": 800, "deviceScaleFactor": 2, "mobile": True}
    page.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
    page.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
    try:
        page.open("phone.frep")
        page.settled()
        assert page.script("return document.documentElement.scrollWidth") <= 390
        picture, text = page.find("#picture").rect, page.find("#editor").rect
        assert picture["height"] > 200 and picture["width"] >= 380 and text["height"] > 80
        assert picture["y"] < text["y"], "the picture is above"
        before = page.picture()

        def touch(kind, *points):
            page.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": kind, "touchPoints": [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})

        x, y = picture["x"] + picture["width"] / 2, picture["y"] + picture["height"] / 2
        touch("touchStart", (x, y))
        for step in range(1, 6):
            touch("touchMove", (x + 12 * step, y))
        touch("touchEnd")
        page.settled()
        assert page.picture() != before, "turned"
        scale = float(page.find("#picture").get_attribute("data-scale"))
        touch("touchStart", (x - 20, y), (x + 20, y))
        for step in range(1, 6):
            touch("touchMove", (x - 20 - 10 * step, y), (x + 20 + 10 * step, y))
        touch("touchEnd")
        page.settled()
        assert float(page.find("#picture").get_attribute("data-scale")) < 0.6 * scale, "zoomed"
        page.shot("web_phone")
    finally:
        page.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        page.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def test_a_sheet_from_nothing(page, folder):
    """fabserver's own example: a circle node takes the place of another node and computes a radius from it."""
    page.open()
    page.until(lambda: page.find("#new-sheet").is_displayed(), "the gallery")
    page.find("#new-sheet").click()
    page.until(lambda: page.find("#sheet").is_displayed(), "the sheet")
    page.add("Point")
    page.drag("Point", -60, 30)
    page.add("Circle through")
    page.until(lambda: "circle(" in (folder / "sheet.json").read_text(), "the text")
    page.settled()
    page.saved()
    point, circle = json.loads((folder / "sheet.json").read_text())["nodes"]
    assert circle["parents"] == [point["id"]]
    assert circle["code"].strip() in [block.text for document in DOCUMENTS
                                      for block in document.blocks], "docs/web.md shows it"
    r = math.hypot(circle["x"] - point["x"], circle["y"] - point["y"])
    assert abs(page.coloured() / (math.pi * r * r) - 1) < 0.02


def test_nodes(page, folder, server):
    """Dragging, links, code, undo, a reload, a killed server, an endless loop: the picture is updated, and no change is
    lost."""
    (folder / "nodes.json").write_text(sheet(("Centre", 0, 0, "return { x, y };", []), ("Circle", 16, 12, CIRCLE, [1])))
    file = folder / "nodes.json"
    page.open("nodes.json")
    page.settled()
    assert abs(page.coloured("#picture") / (math.pi * 400) - 1) < 0.01

    scale = float(page.find("#sheet").get_attribute("data-scale"))
    page.drag("Circle", round(-8 / scale), 0)
    page.until(lambda: [n["x"] for n in json.loads(file.read_text())["nodes"]] == [0, 8],
               "the node's place in the file")
    page.settled()
    assert abs(page.coloured() / (math.pi * (64 + 144)) - 1) < 0.01

    page.choose("Circle")
    page.until(lambda: "const [centre]" in page.text(".code"), "the node's code")
    page.type(".code", Keys.CONTROL + "a", "const [centre] = parents;\n"
              "return `move(circle(${mm(value('r', 5, 1, 9))}), ${mm(centre.x)}, ${mm(centre.y)})`;")
    page.until(lambda: abs(page.coloured() / (math.pi * 25) - 1) < 0.02, "the picture of the new code")
    page.until(lambda: page.find(".numbers input[type=range]").get_attribute("value") == "5", "the code's slider")
    page.shot("web_code")

    page.type(".code", Keys.CONTROL + Keys.HOME, "while (true) {} ")
    page.until(lambda: "Circle was stopped: it ran longer than a second" in page.text("#sheet-message"),
               "the end of the endless loop")
    for _ in range(12):  # continuous typing is one undo step
        page.find("#undo").click()
        page.until(lambda: page.text(".code"), "the code")
        if "distance(centre" in page.text(".code") and "while" not in page.text(".code"):
            break
    page.until(lambda: abs(page.coloured() / (math.pi * (64 + 144)) - 1) < 0.01, "the picture after undo")
    page.saved()

    page.browser.refresh()
    page.settled()
    assert abs(page.coloured() / (math.pi * (64 + 144)) - 1) < 0.01, "as it was, after a reload"

    port = server[0].port
    server[0].kill()
    page.until(lambda: "The server is away" in page.text("#away"), "the notice")
    page.choose("Circle")
    page.find("#sheet").send_keys(Keys.ARROW_RIGHT * 8)
    page.saved("away")
    assert [n["x"] for n in json.loads(file.read_text())["nodes"]] == [0, 8]
    server[0] = Server(folder, port=port)
    page.saved()
    assert [n["x"] for n in json.loads(file.read_text())["nodes"]] == [0, 16]
    page.find("#fit").click()
    page.until(lambda: abs(page.coloured() / (math.pi * 400) - 1) < 0.01, "the picture after all this")


def test_a_browser_that_is_closed_while_the_server_is_away_loses_nothing(page, folder, server):
    (folder / "kept.frep").write_text("circle(3)\n")
    page.open("kept.frep")
    page.settled()
    port = server[0].port
    server[0].kill()
    page.type("#editor", Keys.CONTROL + "a", "circle(7)")
    page.saved("away")
    page.browser.get("about:blank")
    server[0] = Server(folder, port=port)
    page.open("kept.frep")
    page.until(lambda: (folder / "kept.frep").read_text() == "circle(7)", "what was typed, in the file")


PLATE = "return `extrude(${parents.map((each) => each.shape).join(' | ')}, ${mm(value('thickness', 5, 1, 9))})`;"
FRAMED = (("Centre", -40, 0, POINT, []), ("Circle", 0, 10, CIRCLE, [1]), ("Edge", 0, -20, CIRCLE, [1]),
          ("Plate", 40, 0, PLATE, [2, 3]))


def test_groups_of_nodes(page, folder):
    """Chosen by Shift clicks, grouped by keys, moved as one, expanded, collapsed, renamed, ungrouped; each undone."""
    file = folder / "groups.json"
    file.write_text(sheet(*FRAMED))
    page.open("groups.json")
    page.settled()
    before = page.picture()
    page.choose("Circle")
    edge = page.node("Edge").find_element(By.CSS_SELECTOR, ".dot")
    ActionChains(page.browser).key_down(Keys.SHIFT).click(edge).key_up(Keys.SHIFT).perform()
    page.find("#sheet").send_keys(Keys.CONTROL + "g")
    page.until(lambda: [each["name"] for each in json.loads(file.read_text())["groups"]] == ["Group 1"], "the group")
    group = page.node("Group 1")
    titles = [each.get_attribute("title") for each in group.find_elements(By.CSS_SELECTOR, ".port")]
    assert titles == ["Input of Circle", "Input of Edge", "Output of Circle: drag it to a node",
                      "Output of Edge: drag it to a node"]
    shown = [each.get_attribute("title") for each in page.browser.find_elements(By.CSS_SELECTOR, ".node")]
    assert shown == ["Centre", "Plate", "Group 1"]
    assert len(page.browser.find_elements(By.CSS_SELECTOR, ".links .link")) == 4
    page.settled()
    assert page.picture() == before, "a group changes no model"
    page.shot("web_group")
    assert "Inputs: Circle, Edge. Outputs: Circle, Edge. 2 nodes." in page.text("#inspector")

    scale = float(page.find("#sheet").get_attribute("data-scale"))
    page.drag("Group 1", 0, round(-10 / scale))
    page.until(lambda: [nodes_of(file)[each]["y"] for each in ("Centre", "Circle", "Edge", "Plate")] == [0, 20, -10, 0],
               "the places of its members")
    page.find("#undo").click()
    page.until(lambda: [nodes_of(file)[each]["y"] for each in ("Circle", "Edge")] == [10, -20], "the move undone")
    page.choose("Group 1")
    page.find("#sheet").send_keys(Keys.ARROW_UP)
    page.until(lambda: [nodes_of(file)[each]["y"] for each in ("Circle", "Edge")] == [11, -19], "the move by a key")

    page.find("#sheet").send_keys("e")
    page.until(lambda: page.node("Circle") and page.find(".frame-title").text == "Group 1", "the group, expanded")
    assert len(page.browser.find_elements(By.CSS_SELECTOR, ".node")) == 4
    page.shot("web_group_open")
    page.find("#inspector input.title").send_keys(Keys.CONTROL + "a")
    page.find("#inspector input.title").send_keys("Rings", Keys.ENTER)
    page.until(lambda: page.find(".frame-title").text == "Rings", "the new name")
    ActionChains(page.browser).double_click(page.find(".frame-title")).perform()
    page.until(lambda: page.node("Rings"), "the group, collapsed")
    page.saved()  # a reload while a document is being saved asks whose changes are to be kept
    page.browser.refresh()
    page.until(lambda: page.node("Rings"), "the group, after a reload")
    page.settled()

    page.choose("Rings")
    page.find("#sheet").send_keys(Keys.CONTROL + Keys.SHIFT + "g")
    page.until(lambda: json.loads(file.read_text())["groups"] == [], "no group")
    assert "group" not in nodes_of(file)["Circle"]
    page.find("#undo").click()
    page.until(lambda: page.node("Rings"), "the group, after undo")
    page.find("#redo").click()
    page.until(lambda: page.node("Circle"), "the nodes, after redo")


def test_groups_by_menu_rectangle_and_copies(page, folder):
    """A rectangle chooses nodes. A copy of a group is one group with its members and links. Groups are within groups;
    an output is dragged to an input."""
    file = folder / "copies.json"
    file.write_text(sheet(*FRAMED))
    page.open("copies.json")
    page.settled()
    scale, host = float(page.find("#sheet").get_attribute("data-scale")), page.find("#sheet")
    centre = page.node("Circle").find_element(By.CSS_SELECTOR, ".dot")
    actions = ActionChains(page.browser).key_down(Keys.SHIFT).move_to_element_with_offset(centre, -50, -40)
    actions.click_and_hold().move_by_offset(60, 40).move_by_offset(40, round(30 / scale) + 30).release()
    actions.key_up(Keys.SHIFT).perform()
    page.until(lambda: "2 nodes" in page.text("#inspector"), "two chosen nodes")
    page.act("#groups", "Group the chosen nodes")
    page.until(lambda: page.node("Group 1"), "the group")
    host.send_keys(Keys.CONTROL + "c")
    host.send_keys(Keys.CONTROL + "v")
    page.until(lambda: len(json.loads(file.read_text())["groups"]) == 2, "the copy")
    made = json.loads(file.read_text())
    first, second = made["groups"]
    assert [node["name"] for node in made["nodes"]] == ["Centre", "Circle", "Edge", "Plate", "Circle", "Edge"]
    groups = [node.get("group") for node in made["nodes"][1:3] + made["nodes"][4:]]
    assert groups == [first["id"]] * 2 + [second["id"]] * 2
    assert made["nodes"][4]["parents"] == [1], "its link from outside is copied"

    # From the copy's first output to the plate.
    away = next(each for each in page.browser.find_elements(By.CSS_SELECTOR, ".node")
                if each.get_attribute("data-id") == str(second["id"]))
    port = away.find_element(By.CSS_SELECTOR, ".port.out")
    target = page.node("Plate").find_element(By.CSS_SELECTOR, ".dot")
    ActionChains(page.browser).click_and_hold(port).move_to_element(target).release().perform()
    page.until(lambda: made["nodes"][4]["id"] in nodes_of(file)["Plate"]["parents"], "the link from a group")

    host.send_keys(Keys.CONTROL + "a")
    host.send_keys(Keys.CONTROL + "g")
    page.until(lambda: len(page.browser.find_elements(By.CSS_SELECTOR, ".node")) == 1, "a group of groups")
    page.act("#groups", "Expand or collapse")
    page.until(lambda: len(page.browser.find_elements(By.CSS_SELECTOR, ".node")) == 4, "the outer group, expanded")
    page.until(lambda: len(json.loads(file.read_text())["groups"]) == 3, "the group of groups, saved")
    page.find("#fit-sheet").click()
    page.shot("web_groups_in_groups")
    host.send_keys(Keys.DELETE)
    page.until(lambda: json.loads(file.read_text())["nodes"] == [] == json.loads(file.read_text())["groups"],
               "all removed")
    page.find("#undo").click()
    page.until(lambda: len(nodes_of(file)) == 4 and len(json.loads(file.read_text())["groups"]) == 3, "all back")


def test_a_sheet_by_keys(page, folder):
    """Nodes are chosen, linked, cut and grouped without a mouse."""
    file = folder / "keys.json"
    file.write_text(sheet(("Centre", 0, 0, POINT, []), ("Circle", 16, 12, CIRCLE, []), ("Other", 5, 0, POINT, [])))
    page.open("keys.json")
    page.until(lambda: "Circle: " in page.text("#sheet-message"), "the circle that lacks a centre")
    host = page.find("#sheet")
    host.send_keys(Keys.TAB)
    page.until(lambda: page.node("Centre").get_attribute("class").split()[-1] == "chosen", "the first node")
    host.send_keys("l")
    page.until(lambda: "is to take “Centre”" in page.text("#sheet-message"), "what to do next")
    host.send_keys(Keys.TAB, "l")
    page.until(lambda: nodes_of(file)["Circle"]["parents"] == [1], "the link")
    page.settled()
    assert abs(page.coloured() / (math.pi * 400) - 1) < 0.01
    host.send_keys(Keys.ESCAPE)
    host.send_keys(Keys.TAB, "l", Keys.TAB, "l")
    page.until(lambda: nodes_of(file)["Circle"]["parents"] == [], "the link, cut")
    host.send_keys(Keys.ESCAPE)
    host.send_keys(Keys.TAB, " ", Keys.TAB)
    page.until(lambda: "2 nodes" in page.text("#inspector"), "two chosen nodes")
    host.send_keys(Keys.CONTROL + "g")
    page.until(lambda: [each.get("group") for each in nodes_of(file).values()] == [4, 4, None], "the group")


def test_a_mistake_in_a_closed_group_is_found(page, folder):
    made = json.loads(sheet(*FRAMED))
    made["groups"] = [{"id": 9, "name": "Rings", "x": 0, "y": 0, "open": False}]
    for node in made["nodes"][1:3]:
        node["group"] = 9
    made["nodes"][2]["code"] = "throw new Error('no edge');"
    (folder / "hidden.json").write_text(json.dumps(made))
    page.open("hidden.json")
    page.until(lambda: page.node("Rings").get_attribute("class").split()[-1] == "wrong", "the mark at the group")
    page.find("#sheet-message").click()
    page.until(lambda: "no edge" in page.text(".code"), "the node's code")
    for change in ({"group": 9}, {"open": 1}, {"id": 1}):
        bad = json.loads(json.dumps(made))
        bad["groups"][0].update(change)
        (folder / "bad.json").write_text(json.dumps(bad))
        page.open("bad.json")
        page.until(lambda: "group of this sheet is within itself" in page.text("#message")
                   or "A group of this sheet has no number" in page.text("#message"), f"what is wrong with {change}")
        assert json.loads((folder / "bad.json").read_text()) == bad


def test_undo_survives_reloads_and_servers(page, folder, server):
    """Build, reload, undo; kill the server, undo and reload; a file that changed meanwhile wins, with a line."""
    file = folder / "past.frep"
    file.write_text("circle(3)\n")
    page.open("past.frep")
    page.settled()
    for text in ("circle(4)", "circle(5)"):
        page.type("#editor", Keys.CONTROL + "a", text)
        page.saved()
        time.sleep(0.6)  # typing without a pause is one step
    page.browser.refresh()
    page.settled()
    page.find("#undo").click()
    page.until(lambda: file.read_text() == "circle(4)", "a step back, after the reload")
    page.find("#redo").click()
    page.until(lambda: file.read_text() == "circle(5)", "a step forward")
    page.find("#undo").click()
    page.saved()
    port = server[0].port
    server[0].kill()
    page.find("#undo").click()
    page.saved("away")
    server[0] = Server(folder, port=port)
    page.open("past.frep")
    page.until(lambda: file.read_text() == "circle(3)\n", "what was undone without a server")
    page.find("#redo").click()
    page.until(lambda: file.read_text() == "circle(4)", "forward again")
    page.saved()
    assert not page.find("#notice").is_displayed()

    file.write_text("circle(9)\n")
    page.open("past.frep")
    page.until(lambda: "changed elsewhere: this is the newer version" in page.text("#notice"), "the line")
    page.settled()
    assert abs(page.coloured() / (math.pi * 81) - 1) < 0.02 and file.read_text() == "circle(9)\n"
    page.find("#undo").click()
    page.until(lambda: file.read_text() == "circle(4)", "this browser's version")
    page.find("#undo").click()
    page.until(lambda: file.read_text() == "circle(3)\n", "and what was before it")


def test_undo_of_a_sheet_survives_a_reload(page, folder, server):
    file = folder / "past.json"
    file.write_text(sheet(("Centre", 0, 0, POINT, []), ("Circle", 16, 12, CIRCLE, [1])))
    page.open("past.json")
    page.settled()
    page.choose("Circle")
    page.find("#sheet").send_keys(Keys.ARROW_RIGHT)
    page.find("#sheet").send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: nodes_of(file)["Circle"]["x"] == 18, "the moves")
    page.add("Point")
    page.saved()
    page.browser.refresh()
    page.settled()
    page.find("#undo").click()
    page.until(lambda: len(nodes_of(file)) == 2, "no third node")
    port = server[0].port
    server[0].kill()
    page.find("#undo").click()
    page.saved("away")
    page.browser.execute_script("window.left = true")
    server[0] = Server(folder, port=port)
    page.until(lambda: nodes_of(file)["Circle"]["x"] == 17, "the move undone, when the server is back")
    page.browser.refresh()
    page.settled()
    page.find("#undo").click()
    page.until(lambda: nodes_of(file)["Circle"]["x"] == 16, "the first move undone")
    for _ in range(3):
        page.find("#redo").click()
    page.until(lambda: len(nodes_of(file)) == 3, "all again")


def test_code_of_nodes_reaches_nothing(page, folder):
    """No network, no storage, no page: a sheet from a stranger can only compute."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        place = f"127.0.0.1:{listener.getsockname()[1]}"
        tries = {
            "script": f"importScripts('http://{place}/'); return {{}};",
            "storage": "return { text: 'circle(' + localStorage.length + ')' };",
            "page": "return { text: parent.document.title };",
            "requests": f"fetch('http://{place}/'); new WebSocket('ws://{place}/'); "
            f"new EventSource('http://{place}/'); import('http://{place}/'); return {{}};",
            "answer": "postMessage({ run: 1, results: [] }); return {};",
        }
        nodes = [(name, 20 * i, 0, code, []) for i, (name, code) in enumerate(tries.items())]
        (folder / "stranger.json").write_text(sheet(*nodes, ("Circle", 0, 20, "return 'circle(5)';", [])))
        page.open("stranger.json")
        page.settled()
        assert abs(page.coloured() / (math.pi * 25) - 1) < 0.02
        assert {each.get_attribute("title") for each in page.browser.find_elements(By.CSS_SELECTOR, ".node.wrong")} >= {
            "script", "storage", "page"}
        listener.settimeout(1)
        with pytest.raises(TimeoutError):
            listener.accept()
    page.browser.get_log("browser")  # the policy's complaints


def test_names_and_texts_never_become_html(page, folder):
    (folder / "evil.json").write_text(sheet(("<img src=x onerror=document.title='evil'>", 0, 0,
                                             "throw new Error('<b id=bold>bold</b>');", [])))
    page.open("evil.json")
    page.until(lambda: "<b id=bold>" in page.text("#sheet-message"), "the mistake, as text")
    page.choose("<img src=x onerror=document.title='evil'>")
    assert page.script("return document.querySelector('#bold, .node img, #inspector img')") is None
    assert "evil.json" in page.browser.title


def test_a_scan_by_upload(page, folder, tmp_path):
    """A scan becomes a model; a slider next to the histogram sets its threshold and updates the picture."""
    at = np.indices((32, 32, 32)) - 15.5
    ff.Volume(np.clip(100 + 40 * (8 - np.sqrt((at**2).sum(axis=0))), 0, 200).astype(np.float32),
              origin=(-15.5, -15.5, -15.5)).save(tmp_path / "ball.nii.gz")
    page.open()
    page.until(lambda: page.find("#new-scan").is_displayed(), "the gallery")
    page.find("#scan-file").send_keys(str(tmp_path / "ball.nii.gz"))
    page.until(lambda: page.find("#histogram svg").is_displayed(), "the histogram")
    page.settled()
    page.find("#mode option[value=bitmap]").click()
    page.settled()
    area = page.coloured()
    level = float(page.find("#sliders input[type=number]").get_attribute("value"))
    assert abs(area / (math.pi * (8 + (100 - level) / 40) ** 2) - 1) < 0.05
    bar = page.find("#histogram svg")
    ActionChains(page.browser).move_to_element_with_offset(bar, round(-0.3 * bar.size["width"]), 0).click().perform()
    page.until(lambda: f'{float(page.find("#sliders input[type=number]").get_attribute("value")):g}'
               in (folder / "ball.frep").read_text() and page.coloured() > 1.1 * area, "a lower threshold")
    page.shot("web_scan")
    assert (folder / "ball.nii.gz").read_bytes() == (tmp_path / "ball.nii.gz").read_bytes()


def test_a_series_of_slices_by_upload(page, folder, tmp_path):
    """All slices are chosen at once; they become one scan. What is wrong with others is told."""
    at = np.indices((24, 24, 24)) - 11.5
    ball = np.clip(1000 + 400 * (8 - np.sqrt((at**2).sum(axis=0))), 0, 2000).astype("u2")
    for k in range(24):
        (tmp_path / f"IM{k:04d}").write_bytes(dicom(k, rows=ball[k], z=k, spacing=(1, 1, 1)))
    page.open()
    page.until(lambda: page.find("#new-scan").is_displayed(), "the gallery")
    page.find("#scan-file").send_keys(str(tmp_path / "IM0000"))
    page.answer("", "OK")  # what is wrong with one slice
    page.find("#scan-file").send_keys("\n".join(str(tmp_path / f"IM{k:04d}") for k in range(24)))
    page.until(lambda: page.find("#histogram svg").is_displayed(), "the histogram")
    page.settled()
    page.find("#mode option[value=bitmap]").click()
    page.settled()
    [name] = re.findall(r'open\("(.+\.nii)"', page.text("#editor"))
    assert ff.Volume.open(folder / name).size == [24, 24, 24]
    assert page.text("#histogram").startswith("24 × 24 × 24 samples, 1 × 1 × 1 mm apart")


def program_of(page, server, path):
    """Downloads the linked program."""
    link = next(each for each in page.browser.find_elements(By.CSS_SELECTOR, "#job-result a") if each.text == "Program")
    status, _, data = server[0].ask("GET", link.get_attribute("href").split(str(server[0].port))[1])
    assert status == 200
    path.write_bytes(data)
    return link.get_attribute("download")


def plan(page, button="#simulate"):
    shown = page.find("#stage").get_attribute("data-shown") or "0"
    page.find(button).click()
    page.until(lambda: (page.find("#stage").get_attribute("data-shown") or "0") != shown or page.text("#job-message"),
               "a plan", 200)
    assert page.text("#job-message") == ""


def test_a_scan_becomes_a_simulated_program(page, folder, server, tmp_path):
    """Keeter 6: from a scan to a machine, in stacked panels; the program is read by LinuxCNC."""
    page.open("ball.frep")  # the scan that was uploaded above
    page.until(lambda: page.find("#picture").get_attribute("data-shown"), "the picture")
    page.find("#machine").click()
    page.until(lambda: page.find("#panels [data-setting=diameter]").is_displayed(), "the panels")
    set_value(page, "#panels [data-setting=diameter]", 4)
    page.until(lambda: json.loads((folder / "ball.job").read_text())["tools"][0]["diameter"] == 4, "the job's file")
    plan(page)
    page.shot("web_machine")
    assert "The simulation found" in page.text("#job-result") and "s" in page.text("#job-time")
    page.find("#panels [data-setting=adjust_feeds]").click()
    page.until(lambda: json.loads((folder / "ball.job").read_text())["adjust_feeds"], "the job's file")
    plan(page)
    assert "with the planned feeds" in page.text("#job-result")
    assert program_of(page, server, tmp_path / "program.ngc") == "ball.ngc"
    places, kinds, _ = moves(tmp_path / "program.ngc", tools=((1, 40, 4),))
    assert len(places) > 100 and {"STRAIGHT_TRAVERSE", "STRAIGHT_FEED"} <= set(kinds)

    view = "return document.querySelector('#stage canvas').toDataURL()"
    end = page.script(view)
    page.script(
        "const bar = document.querySelector('#stage input'); bar.value = 300; bar.dispatchEvent(new Event('input'))")
    page.until(lambda: page.script(view) != end, "the stock at an earlier time")
    middle, still = page.script(view), page.find("#stage").get_attribute("data-still")
    ActionChains(page.browser).click_and_hold(page.find("#stage .scene")).move_by_offset(70, 20).release().perform()
    page.until(lambda: page.script(view) != middle, "the stock, turned")
    page.find("#stage .film button").click()
    page.until(lambda: int(page.find("#stage").get_attribute("data-still")) > int(still) + 1, "the film")
    page.find("#stage .film button").click()


def test_panels_of_a_job(page, folder, server, tmp_path):
    """Operations are added, ordered and removed. Irrelevant settings are hidden. Errors are reported. A reload keeps
    all settings."""
    (folder / "plate.frep").write_text("rounded_rectangle(30, 20, 3) - circle(5)\n")
    page.open("plate.frep")
    page.settled()
    page.find("#machine").click()
    page.until(lambda: page.find("#panels [data-setting=type]").get_attribute("value") == "profile",
               "a profile, for a flat model")
    assert not page.browser.find_elements(By.CSS_SELECTOR, "[data-setting=tab_width]")
    set_value(page, "[data-setting=tabs]", 2)
    page.until(lambda: page.find("[data-setting=tab_width]").is_displayed(), "the tabs' width")
    page.find("button[aria-label='Add to operations']").click()
    page.until(lambda: len(page.browser.find_elements(By.CSS_SELECTOR, "[data-setting=type]")) == 2,
               "another operation")
    page.script("const e = document.querySelectorAll('[data-setting=type]')[1]; e.value = 'pocket'; "
                "e.dispatchEvent(new Event('change'))")
    page.until(lambda: [each["type"] for each in json.loads((folder / "plate.job").read_text())["operations"]]
               == ["profile", "pocket"], "the job's file")
    page.script("document.querySelectorAll('button[aria-label=Earlier]')[2].click()")
    page.until(lambda: [each["type"] for each in json.loads((folder / "plate.job").read_text())["operations"]]
               == ["pocket", "profile"], "the other order")
    plan(page, "#plan")
    program_of(page, server, tmp_path / "program.ngc")
    assert len(moves(tmp_path / "program.ngc", tools=((1, 40, 3),))[0]) > 20
    set_value(page, "[data-setting=machine]", "epilog")
    page.until(lambda: json.loads((folder / "plate.job").read_text())["machine"] == "epilog", "another machine")
    assert (page.browser.find_elements(By.CSS_SELECTOR, "[data-setting=material]")
            or page.browser.find_elements(By.CSS_SELECTOR, "[data-setting=power]"))
    page.browser.refresh()
    page.settled()
    page.find("#machine").click()
    page.until(lambda: page.find("[data-setting=machine]").get_attribute("value") == "epilog",
               "the job, after a reload")
    set_value(page, "[data-setting=machine]", "linuxcnc")
    page.until(lambda: page.find("[data-setting=material] option[value=aluminium]"), "its materials")
    set_value(page, "[data-setting=material]", "aluminium")
    speeds = ("return [...document.querySelectorAll('[data-setting=feed]')].map((each) => each.placeholder)")
    page.until(lambda: page.script(speeds)[-1] == "by material", "feeds that follow from its chip load")
    set_value(page, "[data-setting=feed]", 432)  # the first is the tool's
    page.find("button[aria-label='Add to operations']").click()
    page.until(lambda: page.script(speeds)[-1] == "432", "the tool's feed as the default of operations")
    set_value(page, "[data-setting=diameter]", 0)
    page.find("#plan").click()
    page.until(lambda: page.text("#job-message"), "what is wrong with a tool without a diameter")


def test_documents_that_cannot_be_shown_are_left_as_they_are(page, folder):
    newer = sheet(version=2)
    (folder / "newer.json").write_text(newer)
    page.open("newer.json")
    page.until(lambda: "version 2" in page.text("#message"), "what is wrong")
    page.type("#editor", "x")
    (folder / "long.frep").write_text("# " + "x" * 1_200_000 + "\nsphere(1)\n")
    page.open("long.frep")
    page.until(lambda: "texts with more than 1 MB are not shown" in page.text("#message"), "what is wrong")
    assert (folder / "newer.json").read_text() == newer


def test_a_link_holds_a_model(page, folder, server):
    link = page.script("""return (async () => {
      const blob = new Blob([JSON.stringify({ name: 'shared.frep', text: 'circle(6)' })]);
      const stream = blob.stream().pipeThrough(new CompressionStream('deflate-raw'));
      const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
      return btoa(String.fromCharCode(...bytes)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    })()""")
    page.open(f"share={link}")
    page.answer("“shared.frep”", "Leave it")
    page.until(lambda: page.find("#examples").is_displayed(), "the gallery")
    assert not (folder / "shared.frep").exists()
    page.open(f"share={link}")
    page.answer("“shared.frep”", "Add it")
    page.settled()
    assert abs(page.coloured() / (math.pi * 36) - 1) < 0.02
    assert (folder / "shared.frep").read_text() == "circle(6)"
