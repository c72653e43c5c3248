"""The demo's page of static files, opened from a disk: coloured models rotated by mouse and keys, a film, the table of
checks."""

import sys
import time

import pytest
from conftest import BUILD, ROOT
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from web_server import chromium, wait_until

sys.path.insert(0, str(ROOT / "packaging"))
import demo


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


@pytest.mark.parametrize("name", ["mtm_az", "cthead", "stock"])
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
    """All files that the page names exist, it loads no external resources, and it shows the checks."""
    named = page.execute_script(
        "return [...document.querySelectorAll('[src], [href]')].map((each) => each.src || each.href)")
    assert len(named) > 10 and all(each.startswith(f"file://{folder}/") for each in named)
    assert all((folder / each.removeprefix(f"file://{folder}/")).is_file() for each in named)
    assert [row.text.split()[1]
            for row in page.find_elements(By.CSS_SELECTOR, "#checks ~ table tr")[1:]] == ["00", "01"]
    assert len(page.find_elements(By.CSS_SELECTOR, "#checks ~ table .pass")) == 2
    assert [each["message"] for each in page.get_log("browser") if each["level"] == "SEVERE"] == []
