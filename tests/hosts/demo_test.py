"""The demo's page of static files, opened from a disk: coloured models rotated by mouse and keys and whole in any
window, a film, the table of checks."""

import re
import sys
import time

import numpy as np
import pytest
from bricks_test import read_glb
from conftest import BUILD, ROOT
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from simulate_report_test import read_png
from web_server import chromium, wait_until

sys.path.insert(0, str(ROOT / "packaging"))
import demo

MODELS = ("mtm_az", "cthead", "stock")
WIDE, NARROW = (1400, 900), (390, 844)
TUTORIAL = ROOT / "docs" / "tutorial.md"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    out = tmp_path_factory.mktemp("demo") / "out"
    assert demo.BUILD == BUILD
    assert demo.main(out, parts=2, cells=32, with_prospero=False, voxel=2, head_voxel=8,
                     job=ROOT / "examples" / "cam" / "text_vcarve.toml", frames=4, cell=0.5) == 0
    return out


@pytest.fixture(scope="module")
def page(folder):
    with chromium() as driver:
        driver.get(f"file://{folder}/index.html")
        yield driver


# A canvas's picture as text for comparison, and its number of coloured pixels.
PIXELS = """
    const canvas = arguments[0].querySelector("canvas"), copy = new OffscreenCanvas(canvas.width, canvas.height);
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const data = context.getImageData(0, 0, copy.width, copy.height).data;
    let seen = 0, coloured = 0, sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] > 200) ++seen;
      if (data[i + 3] > 200 && data[i] > data[i + 2] + 30) ++coloured;
      sum = (31 * sum + data[i]) % 1000000007;
    }
    return [seen, coloured, sum];"""


def shown(page, name):
    figure = page.find_element(By.CSS_SELECTOR, f"figure[data-model={name}]")
    page.execute_script("arguments[0].scrollIntoView({ block: 'center' })", figure)
    wait_until(lambda: figure.get_attribute("data-shown"), f"the model {name}")
    time.sleep(0.3)
    return figure.find_element(By.CSS_SELECTOR, ".scene")


def resize(page, window):
    """Sets the window's inner size; a window of the desktop cannot be as narrow as a phone's."""
    page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                         {"width": window[0], "height": window[1], "deviceScaleFactor": 1, "mobile": False})
    wait_until(lambda: page.execute_script("return [innerWidth, innerHeight]") == list(window), f"a window {window}")


def silhouette(page, host):
    """Returns the canvas's picture as an array of booleans, true where the model is."""
    width, height, rows = page.execute_script("""
        const canvas = arguments[0].querySelector("canvas"), copy = new OffscreenCanvas(canvas.width, canvas.height);
        const context = copy.getContext("2d");
        context.drawImage(canvas, 0, 0);
        const data = context.getImageData(0, 0, copy.width, copy.height).data, seen = [];
        for (let i = 3; i < data.length; i += 4) seen.push(data[i] ? "1" : "0");
        return [copy.width, copy.height, seen.join("")];""", host)
    return (np.frombuffer(rows.encode(), np.uint8) == ord("1")).reshape(height, width)


def box_of(seen):
    """Returns left, top, right, bottom of the true elements; right and bottom are past the last ones."""
    rows, columns = np.flatnonzero(seen.any(1)), np.flatnonzero(seen.any(0))
    return columns[0], rows[0], columns[-1] + 1, rows[-1] + 1


def is_whole(page, name, turned=False):
    """Asserts that a model lies within its canvas with margins, in the middle unless turned, and fills much of it."""
    host = shown(page, name)
    seen = silhouette(page, host)
    height, width = seen.shape
    assert [width, height] == page.execute_script("return [arguments[0].clientWidth, arguments[0].clientHeight]", host)
    assert height < page.execute_script("return innerHeight"), "the whole view is seen at once"
    left, top, right, bottom = box_of(seen)
    side = min(width, height)
    assert min(left, top, width - right, height - bottom) > 0.01 * side, "a margin on all sides"
    assert max(right - left, bottom - top) > 0.6 * side, "the model fills much of its view"
    if not turned:
        assert abs(left + right - width) < 0.1 * side and abs(top + bottom - height) < 0.1 * side, "it is in the middle"


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("windows", [(WIDE, NARROW), (NARROW, WIDE)], ids=["wide first", "narrow first"])
def test_models_are_whole_in_any_window(page, name, windows):
    """Loaded in one window, shown in the other, and turned there."""
    page.refresh()
    for window in windows:
        resize(page, window)
        is_whole(page, name)
    shown(page, name).send_keys(8 * (Keys.ARROW_LEFT + Keys.ARROW_UP))
    is_whole(page, name, turned=True)


@pytest.mark.parametrize("window", [WIDE, NARROW], ids=["wide", "narrow"])
def test_pictures_are_whole(page, folder, window):
    """Each picture has its own proportions or is fitted into its frame, also those of models on a page without
    scripts. The page is not wider than its window."""
    still = folder / "still.html"
    still.write_text((folder / "index.html").read_text().replace('<script src="demo.js"></script>', ""))
    page.get(f"file://{still}")
    resize(page, window)
    pictures = page.execute_script("""return [...document.images].map((each) => [each.src,
        getComputedStyle(each).objectFit, each.naturalWidth / each.naturalHeight,
        each.clientWidth / each.clientHeight])""")
    wide = page.execute_script("return [document.documentElement.scrollWidth, document.documentElement.clientWidth]")
    page.get(f"file://{folder}/index.html")
    assert len(pictures) == 5 and wide[0] == wide[1] and wide[1] <= window[0]
    for source, fit, own, drawn in pictures:
        assert own > 0 and (fit == "contain" or drawn == pytest.approx(own, rel=0.01)), source


def test_the_head_is_upright(page, folder):
    """The scan ends at the neck with a flat cut, which is the model's lower end; the crown is round. The still shows
    the head as the viewer does, and not upside down."""
    height = read_glb(folder / "cthead.glb")[0][:, 2]
    low, high = height.min(), height.max()
    near = 0.02 * (high - low)
    assert np.sum(height < low + near) > 3 * np.sum(height > high - near)
    page.refresh()
    resize(page, WIDE)
    still = read_png((folder / "cthead.png").read_bytes()).astype(int)
    still = abs(still - still[:, :1]).max(2) > 8
    shapes = []
    for seen in silhouette(page, shown(page, "cthead")), still:
        left, top, right, bottom = box_of(seen)
        seen = seen[top:bottom, left:right]
        shapes.append(seen[np.ix_(*(np.linspace(0, side - 1, 100).astype(int) for side in seen.shape))])
    assert np.sum(shapes[0] != shapes[1]) < 0.7 * np.sum(shapes[0] != shapes[1][::-1])


def test_the_drawing_has_all_cuts(folder):
    drawing = (folder / "cuts.svg").read_text()
    size = np.array(re.search(r'viewBox="0 0 (\S+) (\S+)"', drawing).groups(), float)
    points = np.array(re.findall(r"[ML](\S+) ([^LM\s\"]+)", drawing), float)
    assert len(points) > 1000 and (points > 0).all() and (points < size).all()
    assert (np.ptp(points, axis=0) / size).max() > 0.8 and "#e12828" not in drawing, "and no rapids"


@pytest.mark.parametrize("name", MODELS)
def test_models_are_turned(page, name):
    host = shown(page, name)
    seen, coloured, first = page.execute_script(PIXELS, host)
    assert seen > 20_000
    if name == "mtm_az":
        assert 1000 < coloured < seen, "parts in their colours"
    ActionChains(page).click_and_hold(host).move_by_offset(80, 30).release().perform()
    wait_until(lambda: page.execute_script(PIXELS, host)[2] != first, "another picture, after a drag")
    turned = page.execute_script(PIXELS, host)[2]
    host.send_keys(Keys.ARROW_LEFT)
    wait_until(lambda: page.execute_script(PIXELS, host)[2] != turned, "another picture, after a key")


def test_the_film_plays(page):
    film = page.find_element(By.CSS_SELECTOR, "figure[data-film]")
    page.execute_script("arguments[0].scrollIntoView({ block: 'center' })", film)
    image = film.find_element(By.TAG_NAME, "img")
    assert image.get_attribute("src").endswith("frame_0004.png")
    film.find_element(By.TAG_NAME, "button").click()
    wait_until(lambda: image.get_attribute("src").endswith("frame_0001.png")
               or image.get_attribute("src").endswith("frame_0002.png"), "the film's beginning")
    wait_until(lambda: image.get_attribute("src").endswith("frame_0004.png"), "the film's end")
    assert page.execute_script("return arguments[0].naturalWidth", image) > 400


def test_the_page_is_whole(page, folder):
    """All files that the page names exist, it loads no external resources, and there are no errors."""
    named = page.execute_script(
        "return [...document.querySelectorAll('[src], [href]')].map((each) => each.src || each.href)")
    named.remove(TUTORIAL.as_uri())
    assert TUTORIAL.is_file()
    assert len(named) > 10 and all(each.startswith(f"file://{folder}/") for each in named)
    assert all((folder / each.removeprefix(f"file://{folder}/")).is_file() for each in named)
    assert [each["message"] for each in page.get_log("browser") if each["level"] == "SEVERE"] == []


def test_it_begins_with_what_it_is_and_ends_with_what_is_next(page):
    assert page.find_element(By.CSS_SELECTOR, "h1 + p").text.startswith("Fieldfab makes solids")
    steps = [each.text for each in page.find_elements(By.CSS_SELECTOR, "h2:last-of-type + ul > li")]
    assert [step.split(" ")[0] for step in steps] == ["build/release/bin/fieldfab", "./dev", "The"]
    assert 'href="../../docs/tutorial.md"' in demo.next_steps(demo.OUT)


def test_the_checks_are_sums_and_a_folded_table(page):
    def rows(table):
        return [[cell.get_attribute("textContent") for cell in row.find_elements(By.TAG_NAME, "td")]
                for row in table.find_elements(By.TAG_NAME, "tr")[1:]]

    def numbers(row):
        return [float(cell.replace(",", "")) for cell in row[1:-1]]

    table, folded = page.find_elements(By.CSS_SELECTOR, "#checks ~ .table table, #checks ~ details table")
    [total], parts = rows(table), rows(folded)
    visible = "return [...arguments].map((each) => each.checkVisibility())"
    assert page.execute_script(visible, table, folded) == [True, False]
    page.find_element(By.TAG_NAME, "summary").click()
    assert page.execute_script(visible, table, folded) == [True, True]
    assert [row[0] for row in parts] == ["part 00", "part 01"] and total[0] == "2 parts"
    assert np.sum([numbers(row) for row in parts], axis=0) == pytest.approx(numbers(total), abs=0.0101)
    assert [row[-1] for row in [total, *parts]] == ["✓"] * 3
