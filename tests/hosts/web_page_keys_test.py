"""fabserver's page by keys, and what its views show: mistakes, menus, the crosshair, perspective, sections, the text of
a sheet beside its nodes, and the last good picture."""

import json
import math
import time

import numpy as np
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from web_page import CIRCLE, POINT, browser, folder, nodes_of, page, server, set_value, sheet


def focused(page):
    """Returns tag, class and label of the element that has the focus."""
    return page.script("const e = document.activeElement; "
                       "return [e.tagName, e.className, e.getAttribute('aria-label') ?? '']")


def press(page, *keys):
    """Presses keys where the focus is."""
    for each in keys:
        ActionChains(page.browser).send_keys(each).perform()


def test_enter_leads_to_a_nodes_name_and_code_and_escape_back(page, folder):
    file = folder / "enter.json"
    file.write_text(sheet(("Centre", 0, 0, POINT, []), ("Circle", 16, 12, CIRCLE, [1])))
    page.open("enter.json")
    page.settled()
    page.find("#sheet").send_keys(Keys.TAB, Keys.TAB)
    press(page, Keys.ENTER)
    page.until(lambda: focused(page)[2] == "Name of the node", "the name")
    press(page, "Ring", Keys.ENTER)
    page.until(lambda: "Ring" in nodes_of(file), "the new name")
    press(page, Keys.ESCAPE)
    assert page.script("return document.activeElement.id") == "sheet"
    press(page, Keys.ENTER, Keys.TAB, Keys.TAB)
    page.until(lambda: "cm-content" in focused(page)[1], "the code")
    press(page, Keys.CONTROL + Keys.HOME, "// by keys\n")
    page.until(lambda: nodes_of(file)["Ring"]["code"].startswith("// by keys"), "the changed code")
    press(page, Keys.ESCAPE, Keys.TAB)
    assert "cm-content" not in focused(page)[1], "Escape, then Tab leaves the editor"
    assert "\t" not in nodes_of(file)["Ring"]["code"]


def test_f8_goes_to_the_next_mistake(page, folder):
    (folder / "wrong.frep").write_text("circlee(1) |\ncircle(2) |\nrectanglee(3, 4)\n")
    page.open("wrong.frep")
    page.until(lambda: "Line 1, column 1" in page.text("#message"), "the mistakes")
    line = "return document.querySelector('.cm-activeLine')?.textContent"
    page.find("#message button").send_keys(Keys.ENTER)
    page.until(lambda: "cm-content" in focused(page)[1] and page.script(line).startswith("circlee"), "the first")
    for start in ("rectanglee", "circlee"):  # there may be a mistake about both, between them
        for _ in range(3):
            press(page, Keys.F8)
            if page.script(line).startswith(start):
                break
        assert page.script(line).startswith(start)
    (folder / "wrong.json").write_text(sheet(("One", -20, 0, "throw new Error('first');", []),
                                             ("Two", 0, 0, "return 'circle(3)';", []),
                                             ("Three", 20, 0, "throw new Error('second');", [])))
    page.open("wrong.json")
    page.until(lambda: "first" in page.text("#sheet-message"), "the mistake")
    page.find("#sheet").click()
    for name in ("One", "Three", "One"):
        press(page, Keys.F8)
        page.until(lambda: "chosen" in page.node(name).get_attribute("class"), name)
    page.find("#sheet-message button").send_keys(Keys.ENTER)
    page.until(lambda: "first" in page.text(".code"), "the node's code")


def test_menus_by_keys(page, folder):
    """They act on Enter, not on a change of the choice; Escape closes them."""
    (folder / "menu.json").write_text(sheet(("A", -20, 0, "return 'circle(3)';", []),
                                            ("B", 20, 0, "return 'circle(3)';", [])))
    page.open("menu.json")
    page.settled()
    page.find("#sheet").send_keys(Keys.CONTROL + "a")
    page.find("#groups").send_keys(Keys.ENTER)
    page.until(lambda: focused(page)[0] == "BUTTON" and page.script(
        "return document.activeElement.getAttribute('role')") == "menuitem", "the first action")
    assert page.find("#groups").get_attribute("aria-expanded") == "true"
    press(page, Keys.ARROW_DOWN, Keys.ARROW_UP, Keys.END)
    assert page.script("return document.activeElement.textContent").startswith("Ungroup")
    assert not page.browser.find_elements(By.CSS_SELECTOR, ".node.closed"), "nothing was done yet"
    press(page, Keys.ESCAPE)
    assert page.script("return document.activeElement.id") == "groups"
    assert not page.browser.find_elements(By.CSS_SELECTOR, ".menu-list")
    press(page, Keys.ARROW_DOWN, Keys.ENTER)
    page.until(lambda: page.browser.find_elements(By.CSS_SELECTOR, ".node.closed"), "the group")
    page.find("#download").click()
    page.until(lambda: page.find(".menu-list").is_displayed(), "the formats")
    press(page, "3")
    assert page.script("return document.activeElement.textContent") == "3mf"
    page.shot("web_menu")
    page.find("#picture").click()
    page.until(lambda: not page.browser.find_elements(By.CSS_SELECTOR, ".menu-list"), "a click elsewhere closes it")


def test_measuring_by_keys(page, folder):
    """A crosshair is moved by arrows; Enter takes the point below it."""
    (folder / "aim.frep").write_text("box(40, 40, 10)\n")
    page.open("aim.frep")
    page.settled()
    host = page.find("#picture")
    host.send_keys("2")
    page.settled()
    scale = float(host.get_attribute("data-scale"))
    host.send_keys("m", "c")
    host.send_keys(Keys.ARROW_LEFT * 5, Keys.ENTER)
    page.until(lambda: page.text("#picture .told").endswith(" mm"), "the first point")
    host.send_keys(Keys.SHIFT + Keys.ARROW_RIGHT)
    host.send_keys(Keys.ENTER)
    page.until(lambda: " mm (" in page.text("#picture .told"), "the distance")
    page.shot("web_crosshair")
    assert abs(float(page.text("#picture .told").split()[0]) - 40 * scale) < 0.02
    host.send_keys(Keys.ESCAPE)
    assert host.get_attribute("data-crosshair") == "false"


def test_picking_in_perspective(page, folder):
    """A pick is on the surface, and the point is seen where it was clicked: the far edge of a box is found where the
    picture has it."""
    (folder / "deep.frep").write_text("box(20, 20, 60)\n")
    page.open("deep.frep")
    page.settled()
    host = page.find("#picture")
    host.send_keys("p", "2")  # from above
    page.settled()

    def pick(dx, dy):
        page.script("document.querySelector('#picture .told').textContent = ''")
        ActionChains(page.browser).move_to_element_with_offset(host, dx, dy).click().perform()
        page.until(lambda: page.text("#picture .told"), "a point")
        return page.text("#picture .told")

    edge = page.script("""
      const c = document.querySelector('#picture canvas'), row = c.height / 2;
      const data = c.getContext('2d').getImageData(0, row, c.width, 1).data;
      let x = c.width - 1;
      while (data[4 * x + 3] < 200) --x;
      return x - c.width / 2;""")
    inside = [float(each) for each in pick(round(edge - 3), 0).removesuffix(" mm").split(", ")]
    scale = float(host.get_attribute("data-scale"))
    assert abs(inside[2] - 30) < 0.01, "on the top, which is nearest"
    assert abs(inside[0] - 10) < 4 * scale + 0.1, "beside its edge"
    assert edge * scale > 10.5, "nearer than the middle, it is seen larger than it is"
    assert pick(round(edge + 4), 0) == "Nothing is there"
    host.send_keys("m")
    pick(round(0.9 * edge), 0)
    ActionChains(page.browser).move_to_element_with_offset(host, round(-0.9 * edge), 0).click().perform()
    page.until(lambda: " mm (" in page.text("#picture .told"), "the distance")
    assert abs(float(page.text("#picture .told").split()[0]) - 18) < 0.5
    page.shot("web_perspective")


def test_a_section_has_a_side_and_a_number(page, folder):
    (folder / "half.frep").write_text("move(box(20, 20, 20), 0, 0, 10)\n")
    page.open("half.frep")
    page.settled()
    page.find("#section option[value=z]").click()
    page.until(lambda: page.find("#section-number").is_displayed(), "the plane")
    set_value(page, "#section-number", 5)
    page.settled()
    host = page.find("#picture")
    host.send_keys("2")
    page.settled()

    def height():
        page.script("document.querySelector('#picture .told').textContent = ''")
        host.click()
        page.until(lambda: page.text("#picture .told"), "the point in the middle")
        return float(page.text("#picture .told").removesuffix(" mm").split(", ")[2])

    assert abs(height() - 5) < 0.01, "the part below 5 mm"
    page.find("#section-flip").click()
    page.settled()
    assert abs(height() - 20) < 0.01, "the part above 5 mm"
    page.shot("web_section")
    (folder / "whole.frep").write_text("box(10, 10, 10)\n")
    page.find("#mode option[value=normals]").click()
    page.find("#open").click()
    page.click(".card[data-name='whole.frep']")
    page.until(lambda: page.text("#name") == "whole.frep", "another document")
    page.settled()
    assert page.find("#mode").get_attribute("value") == "shaded" and page.find("#section").get_attribute("value") == ""
    assert not page.find("#section-place").is_displayed()


def test_the_last_good_picture_becomes_fine(page, folder):
    """A mistake that is typed during a coarse picture does not leave it coarse; the view of it can be turned."""
    (folder / "good.frep").write_text("gyroid(6) & box(30, 30, 30)")
    page.open("good.frep")
    page.settled()
    page.type("#editor", Keys.CONTROL + Keys.END)
    page.script("""
      const editor = document.querySelector('#editor .cm-content');
      const paste = (text) => {
        const data = new DataTransfer();
        data.setData('text/plain', text);
        editor.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
      };
      paste('| sphere(17)');
      const seen = setInterval(() => {
        if (document.querySelector('#picture').dataset.quality !== 'coarse') return;
        clearInterval(seen);
        paste(' | nothing(');
      }, 1);
    """)
    page.until(lambda: "Line 1, column " in page.text("#message"), "the mistake")
    page.settled()
    assert page.text("#message"), "it stays told"
    before = page.picture()
    page.find("#picture").send_keys(Keys.ARROW_LEFT * 4)
    page.settled()
    assert page.picture() != before and page.text("#message")
    page.type("#editor", Keys.BACKSPACE * 11)
    page.until(lambda: not page.text("#message"), "no mistake")
    page.settled()


def test_a_sheet_and_its_text_side_by_side(page, folder):
    """The text follows each change, in colours, with the mistakes in it; it cannot be changed."""
    (folder / "beside.json").write_text(sheet(("Centre", 0, 0, POINT, []), ("Circle", 16, 12, CIRCLE, [1])))
    page.open("beside.json")
    page.settled()
    page.choose("Circle")
    page.find("#show-text").click()
    page.until(lambda: "move(circle(20), 0, 0)" in page.text("#made"), "the text")
    assert page.find("#inspector .code").is_displayed() and page.find("#made .cm-editor").is_displayed()
    left, right = page.find("#inspector").rect, page.find("#made").rect
    assert left["x"] + left["width"] <= right["x"] + 1 and abs(left["y"] - right["y"]) < 2, "side by side"
    colour = "return getComputedStyle(arguments[0]).color"
    spans = page.browser.find_elements(By.CSS_SELECTOR, "#made .cm-line span")
    assert len({page.script(colour, each) for each in spans}) > 2, "colours"
    page.find("#sheet").send_keys(Keys.ARROW_RIGHT * 5)
    page.until(lambda: f"circle({math.hypot(21, 12):.4f}".rstrip("0") in page.text("#made"), "the text after a move")
    before = page.text("#made .cm-content")
    page.type("#made", "x")
    assert page.text("#made .cm-content") == before
    page.shot("web_beside")
    page.type(".code", Keys.CONTROL + "a", "return 'circlee(3)';")
    page.until(lambda: page.find("#made .cm-lintRange-error").text == "circlee", "the mistake in the text")


def test_kinds_of_nodes_are_saved_as_own(page, folder):
    (folder / "own.json").write_text(sheet(("My disc", 0, 0, "return `circle(${mm(value('r', 7, 1, 9))})`;", [])))
    page.open("own.json")
    page.settled()
    page.choose("My disc")
    page.press("#inspector button", "Save as my own")
    (folder / "other.json").write_text(sheet())
    page.open("other.json")
    page.until(lambda: page.text("#name") == "other.json", "another sheet")
    page.add("My disc")
    page.settled()
    assert abs(page.coloured() / (math.pi * 49) - 1) < 0.02
    page.until(lambda: json.loads((folder / "other.json").read_text())["nodes"][0]["name"] == "My disc", "the file")
    page.script("localStorage.removeItem('fabserver nodes')")
    page.find("#add-node").click()
    page.until(lambda: page.find("#close-palette").is_displayed(), "the palette")
    page.find("#close-palette").click()
    page.until(lambda: not page.find("#palette").is_displayed(), "the palette, closed by its button")


def test_completion_offers_names(page, folder):
    (folder / "words.frep").write_text("\n")
    page.open("words.frep")
    page.until(lambda: page.text("#name") == "words.frep", "the document")
    page.type("#editor", "rounded_r")
    page.until(lambda: "rounded_rectangle" in page.text(".cm-tooltip-autocomplete"), "the offer")
    time.sleep(0.2)  # a popup that appears just now takes no Enter
    press(page, Keys.ENTER)
    page.until(lambda: page.text("#editor .cm-content").startswith("rounded_rectangle("), "the completed name")
    press(page, "20, 10, 2")
    page.find("#fit").click()
    page.until(lambda: abs(page.coloured() / (200 - (4 - math.pi) * 4) - 1) < 0.02, "its picture")


def test_zooming_keeps_the_point_below_the_pointer(page, folder):
    (folder / "corner.frep").write_text("move(circle(2), 12, 7) | rectangle(40, 30) - rectangle(38, 28)\n")
    page.open("corner.frep")
    page.settled()
    host = page.find("#picture")
    scale = float(host.get_attribute("data-scale"))
    box = page.script("const b = document.querySelector('#picture').getBoundingClientRect(); "
                      "return [b.left, b.top, b.width, b.height]")
    dx, dy = 12 / scale, -7 / scale  # of the disc's centre from the middle, pixels
    page.script("document.querySelector('#picture').dispatchEvent(new WheelEvent('wheel', { deltaY: -600, "
                "clientX: arguments[0], clientY: arguments[1], cancelable: true }))",
                box[0] + box[2] / 2 + dx, box[1] + box[3] / 2 + dy)
    page.settled()
    found = page.script("""
      const c = document.querySelector('#picture canvas'), data = c.getContext('2d').getImageData(
        arguments[0] - 60, arguments[1] - 60, 120, 120).data;
      const flat = getComputedStyle(document.documentElement).getPropertyValue('--flat').split(',').map(Number);
      let n = 0, x = 0, y = 0;
      for (let i = 0; i < data.length; i += 4)
        if (Math.abs(data[i] - flat[0]) < 8 && Math.abs(data[i + 1] - flat[1]) < 8 && data[i + 3] > 200) {
          ++n; x += (i / 4) % 120; y += Math.floor(i / 480); }
      return [n, x / n - 60, y / n - 60];""", round(box[2] / 2 + dx), round(box[3] / 2 + dy))
    assert float(host.get_attribute("data-scale")) < 0.5 * scale and found[0] > 200
    assert np.abs(found[1:]).max() < 1.5, "the disc is still below the pointer"


def test_the_hint_of_the_first_visit(page, folder):
    (folder / "hint.frep").write_text("box(10, 10, 10)\n")
    page.open("hint.frep")
    page.script("localStorage.removeItem('fabserver hint')")
    page.browser.refresh()
    page.until(lambda: "Drag turns" in page.text("#hint"), "the hint")
    page.settled()
    page.shot("web_hint")
    page.find("#hint button").click()
    page.until(lambda: not page.browser.find_elements(By.CSS_SELECTOR, "#hint"), "it is closed")
    page.browser.refresh()
    page.settled()
    assert not page.browser.find_elements(By.CSS_SELECTOR, "#hint")


def test_what_is_not_a_number_is_told_or_ignored(page, folder):
    """NaN from a node's code; a slider's box that is empty."""
    (folder / "nan.json").write_text(sheet(("Disc", 0, 0, "return `circle(${mm(0 / 0)})`;", [])))
    page.open("nan.json")
    page.until(lambda: "Disc: " in page.text("#sheet-message"), "the mistake")
    assert "wrong" in page.node("Disc").get_attribute("class")
    (folder / "nan.frep").write_text("r = 5  # 1 to 9\ncircle(r)\n")
    page.open("nan.frep")
    page.settled()
    page.find("#sliders input[type=number]").clear()
    page.find("#sliders input[type=number]").send_keys("e")
    time.sleep(0.6)
    assert (folder / "nan.frep").read_text() == "r = 5  # 1 to 9\ncircle(r)\n"
    page.find("#mode option[value=bitmap]").click()
    page.settled()
    assert abs(page.coloured() / (math.pi * 25) - 1) < 0.02


def test_a_node_of_each_kind(page, folder, server):
    """Each kind of the library makes a shape that can be shown, from one or two discs, balls or places."""
    file = folder / "kinds.json"
    file.write_text(sheet(("Disc", 0, 0, "return 'move(circle(5), -3)';", []),
                          ("Other", 30, 0, "return 'move(circle(4), 3)';", [])))
    page.open("kinds.json")
    page.settled()
    page.find("#add-node").click()
    names = [each.text for each in page.browser.find_elements(By.CSS_SELECTOR, "#nodes button")]
    page.find("#close-palette").click()
    assert len(names) > 80
    add = """
      const host = document.querySelector('#sheet');
      for (const name of arguments[0]) {
        host.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));
        host.dispatchEvent(new KeyboardEvent('keydown', { key: 'Tab', bubbles: true }));
        host.dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true }));
        host.dispatchEvent(new KeyboardEvent('keydown', { key: 'Tab', bubbles: true }));
        document.querySelector('#add-node').click();
        [...document.querySelectorAll('#nodes button')].find((each) => each.textContent === name).click();
      }"""
    for start in range(0, len(names), 20):  # a second is what the code of a sheet may take
        page.script(add, names[start : start + 20])
    page.until(lambda: len(json.loads(file.read_text())["nodes"]) == len(names) + 2, "all nodes", 120)
    page.saved()
    wrong = page.script("return [...document.querySelectorAll('.node.wrong')].map((each) => each.title)")
    made = json.loads(file.read_text())
    lines = made["text"].strip().split("\n")[:-1]
    discs, shapes, bad = lines[:2], lines[2:], {}
    balls = [line.replace("circle", "sphere") for line in discs]
    for line in shapes:
        for parents in (discs, balls):  # what is bent or repeated along z needs a solid
            status, _, data = server[0].ask("POST", "/api/picture", {
                "text": "\n".join([*parents, line, line.split(" = ")[0]]), "width": 48, "height": 48})
            if status == 200:
                break
        else:
            bad[line] = json.loads(data)["error"]["message"]
    assert "\n".join(wrong) == "" == "\n".join(f"{line}: {message}" for line, message in bad.items())
    assert len(shapes) > 70
