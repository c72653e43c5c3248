"""fabserver's page for people who use it by keys, a screen reader, or with little sight: axe-core finds nothing serious
in any of its states, in either theme."""

import numpy as np
import pytest
from conftest import BUILD
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from web_page import CIRCLE, POINT, browser, folder, page, server, set_value, sheet

import fieldfab as ff

AXE = BUILD / "web" / "npm" / "node_modules" / "axe-core" / "axe.min.js"


@pytest.fixture
def documents(folder):
    (folder / "part.frep").write_text("r = 5  # 1 to 9, radius\npin_x = 0  # -9 to 9\npin_y = 0  # -9 to 9\n"
                                      "circle(r) - move(circle(1), pin_x, pin_y)\n")
    (folder / "typed.frep").write_text("circle(3)\n")
    (folder / "plate.frep").write_text("rounded_rectangle(30, 20, 3) - circle(5)\n")
    (folder / "solid.frep").write_text('part(box(20, 12, 6), "body", "red")\n')
    (folder / "wrong.frep").write_text("circlee(5)\n")
    for name in ("nodes.json", "group.json"):
        (folder / name).write_text(sheet(("Centre", 0, 0, POINT, []), ("Circle", 16, 12, CIRCLE, [1]),
                                         ("Broken", 30, 0, "throw new Error('no shape');", [])))
    at = np.indices((16, 16, 16)) - 7.5
    ball = np.clip(100 + 40 * (5 - np.sqrt((at**2).sum(axis=0))), 0, 200).astype(np.float32)
    ff.Volume(ball).save(folder / "ball.nii")
    (folder / "scan.frep").write_text('level = 100  # 0 to 200, threshold\nopen("ball.nii", threshold = level)\n')


def settled(page, name):
    page.open(name)
    page.settled()


def the_gallery(page):
    page.open()
    page.until(lambda: page.find("#examples .card").is_displayed(), "the gallery")


def a_document_in_the_gallery(page):
    the_gallery(page)
    page.find(".entry[data-name='part.frep'] .more").click()
    page.until(lambda: page.find(".menu-list").is_displayed(), "the document's menu")


def a_text(page):
    settled(page, "part.frep")


def a_mistake(page):
    page.open("wrong.frep")
    page.until(lambda: "Line 1, column 1" in page.text("#message"), "the mistake")


def completion(page):
    page.open("typed.frep")
    page.until(lambda: page.text("#name") == "typed.frep", "the document")
    page.type("#editor", Keys.CONTROL + "a", "rounded_r")
    page.until(lambda: "rounded_rectangle" in page.text(".cm-tooltip-autocomplete"), "the offer")


def a_sheet(page, name="nodes.json"):
    page.open(name)
    page.until(lambda: page.text("#sheet-message"), "the sheet and its mistake")


def a_node_and_the_text(page):
    a_sheet(page)
    page.choose("Circle")
    page.until(lambda: page.find("#inspector .code").is_displayed(), "the node's code")
    page.find("#show-text").click()
    page.until(lambda: page.find("#made .cm-editor").is_displayed(), "the text")


def a_group(page):
    a_sheet(page, "group.json")
    page.find("#sheet").click()
    page.find("#sheet").send_keys(Keys.CONTROL + "a")
    page.find("#sheet").send_keys(Keys.CONTROL + "g")
    page.until(lambda: page.node("Group 1"), "the group")
    page.find("#groups").click()
    page.until(lambda: page.find(".menu-list").is_displayed(), "its menu")


def kinds_of_nodes(page):
    a_sheet(page)
    page.find("#add-node").click()
    page.until(lambda: page.browser.find_elements(By.CSS_SELECTOR, "#nodes button"), "the kinds of nodes")


def formats(page):
    settled(page, "solid.frep")
    page.find("#download").click()
    page.until(lambda: page.find(".menu-list").is_displayed(), "the formats")


def keys(page):
    settled(page, "solid.frep")
    page.find("#help").click()
    page.until(lambda: page.find("#keys").is_displayed(), "the keys")


def a_section_and_a_distance(page):
    settled(page, "solid.frep")
    page.find("#section option[value=z]").click()
    page.until(lambda: page.find("#section-number").is_displayed(), "the plane")
    page.find("#picture").send_keys("m", "c", Keys.ENTER)
    page.settled()


def a_question(page):
    the_gallery(page)
    page.act(".entry[data-name='ball.nii'] .more", "Delete")
    page.until(lambda: page.find("#question").is_displayed(), "the question")


def a_scan(page):
    page.open("scan.frep")
    page.until(lambda: page.find("#histogram svg").is_displayed(), "the histogram")
    page.settled()


def a_job(page):
    settled(page, "plate.frep")
    page.find("#machine").click()
    page.until(lambda: page.find("#panels [data-setting=diameter]").is_displayed(), "the panels")


def a_refused_job(page):
    a_job(page)
    set_value(page, "[data-setting=type]", "v_carve")  # by a tool that is no V
    page.find("#plan").click()
    page.until(lambda: page.text("#job-message"), "what is wrong")


def a_simulation(page):
    a_job(page)
    set_value(page, "[data-setting=type]", "profile")
    page.find("#simulate").click()
    page.until(lambda: page.find("#stage").get_attribute("data-shown") or page.text("#job-message"),
               "a simulation", 200)
    assert page.text("#job-message") == ""


STATES = (the_gallery, a_document_in_the_gallery, a_text, a_mistake, completion, a_sheet, a_node_and_the_text,
          a_group, kinds_of_nodes, formats, keys, a_section_and_a_distance, a_scan, a_job, a_refused_job,
          a_simulation, a_question)


def serious(page):
    """Returns what axe-core finds in the page as it is now: rules, and the elements that break them."""
    moving = "return document.getAnimations().filter((each) => each.effect.getTiming().iterations < Infinity).length"
    page.until(lambda: page.script(moving) == 0, "colours at rest")  # a cursor blinks for ever
    page.script(AXE.read_text())
    found = page.browser.execute_async_script(
        "const done = arguments[0]; axe.run({ resultTypes: ['violations'] }).then((r) => done(r.violations))")
    return [(each["id"], [node["html"][:160] for node in each["nodes"]][:4])
            for each in found if each["impact"] in ("serious", "critical")]


def test_axe_finds_nothing_serious(page, documents):
    page.open()
    page.script("localStorage.setItem('fabserver theme', 'light')")
    found = {}
    for state in STATES:
        state(page)
        assert page.script("return document.documentElement.dataset.theme") == "light"
        for theme in ("light", "dark"):
            page.script("document.documentElement.dataset.theme = arguments[0]", theme)
            page.shot(f"web_{state.__name__}_{theme}")
            found[f"{state.__name__}, {theme}"] = serious(page)
        page.script("document.documentElement.dataset.theme = 'light'")
    page.script("localStorage.setItem('fabserver theme', 'dark')")
    page.open()
    assert page.script("return document.documentElement.dataset.theme") == "dark"
    page.script("localStorage.removeItem('fabserver theme')")
    assert {state: what for state, what in found.items() if what} == {}


def test_axe_finds_nothing_serious_on_a_phone(page, documents):
    screen = {"width": 390, "height": 800, "deviceScaleFactor": 2, "mobile": True}
    page.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
    try:
        for state in (the_gallery, a_text, a_sheet, a_job):
            state(page)
            assert serious(page) == [], state.__name__
    finally:
        page.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
