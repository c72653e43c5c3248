"""fabserver's page for tests: a browser, a server with a folder of documents, and the actions of a user."""

import contextlib
import json
import os
import time

import pytest
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from web_server import Server, chromium

SECONDS = 200  # time limit of each step on a busy machine
SHOTS = os.environ.get("FIELDFAB_SHOTS")  # a folder for pictures of the page


@pytest.fixture(scope="module")
def browser():
    with chromium() as driver:
        yield driver


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("documents")


@pytest.fixture(scope="module")
def server(folder):
    running = [Server(folder)]
    yield running  # a list, since a test kills it and starts another one
    running[0].end()


class Page:
    """Actions of a user on the page, and its visible state."""

    def __init__(self, browser, server):
        self.browser, self.server = browser, server

    def open(self, name=""):
        self.browser.get("about:blank")
        self.browser.get(f"{self.server[0].address}#{name}")

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def until(self, condition, what, seconds=SECONDS):
        end, now = time.monotonic() + seconds, None
        while time.monotonic() < end:
            with contextlib.suppress(Exception):  # elements may be replaced meanwhile
                if now := condition():
                    return now
            time.sleep(0.05)
        shot = f"/tmp/fabserver-{os.getpid()}.png"
        self.browser.save_screenshot(shot)
        raise AssertionError(f"{what}: not within {seconds} s ({shot}); "
                             f"{self.text('#message')} {self.text('#sheet-message')} {self.text('#away')}")

    def click(self, selector):
        """Clicks on an element that may not be there yet, or be replaced meanwhile, as the gallery's cards are."""
        self.until(lambda: self.find(selector).click() or True, selector)

    def text(self, selector):
        return self.script("return document.querySelector(arguments[0])?.textContent ?? ''", selector)

    def settled(self, host="#picture"):
        """Waits until the last requested picture is shown in full resolution."""
        is_settled = ("const d = document.querySelector(arguments[0]).dataset; "
                      "return d.asked > 0 && d.shown === d.asked && d.quality === 'smooth'")
        time.sleep(0.05)
        self.until(lambda: self.script(is_settled, host), f"the picture in {host}")

    def coloured(self, host="#picture"):
        """Returns the area in the colour of flat models, mm2."""
        count = """
            const host = document.querySelector(arguments[0]), canvas = host.querySelector('canvas');
            const flat = getComputedStyle(document.documentElement).getPropertyValue('--flat');
            const [r, g, b] = flat.split(',').map(Number), near = (a, b) => Math.abs(a - b) < 8;
            const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            let count = 0;
            for (let i = 0; i < data.length; i += 4)
              if (near(data[i], r) && near(data[i + 1], g) && near(data[i + 2], b) && data[i + 3] > 200) ++count;
            return count * Number(host.dataset.scale) ** 2;"""
        return self.script(count, host)

    def picture(self):
        """Returns the pixels of the picture as text for comparison."""
        return self.script("return document.querySelector('#picture canvas').toDataURL()")

    def type(self, selector, *keys):
        editor = self.find(f"{selector} .cm-content")
        editor.click()
        for each in keys:  # separately, since a modifier lasts until the end of a call
            editor.send_keys(each)

    def saved(self, state="saved"):
        self.until(lambda: self.script("return document.getElementById('saved').dataset.state") == state,
                   f"the state '{state}'")

    def node(self, name):
        return next(each for each in self.browser.find_elements(By.CSS_SELECTOR, ".node")
                    if each.get_attribute("title") == name)

    def choose(self, name):
        ActionChains(self.browser).click(self.node(name).find_element(By.CSS_SELECTOR, ".dot")).perform()

    def drag(self, name, dx, dy):
        ActionChains(self.browser).click_and_hold(self.node(name).find_element(By.CSS_SELECTOR, ".dot")).move_by_offset(
            dx // 2, dy // 2).move_by_offset(dx - dx // 2, dy - dy // 2).release().perform()

    def add(self, kind):
        self.find("#add-node").click()
        self.find("#find-node").send_keys(kind)
        self.until(lambda: [b.click() or 1 for b in self.browser.find_elements(By.CSS_SELECTOR, "#nodes button")
                            if b.text == kind][:1], f"the kind of node {kind}")

    def press(self, selector, words):
        """Clicks the first of the elements that has the words in its first line. Returns whether there is one."""
        for each in self.browser.find_elements(By.CSS_SELECTOR, selector):
            if each.text.split("\n")[0] == words:
                each.click()
                return True
        return False

    def act(self, button, words):
        """Opens a menu and chooses an action."""
        self.find(button).click()
        self.until(lambda: self.press(".menu-list button", words), f"the action {words}")

    def answer(self, words, answer):
        """Answers a question of the page."""
        self.until(lambda: words in self.text("#question-words") and self.find("#question").is_displayed(), words)
        self.until(lambda: self.press("#question button", answer), f"the answer {answer}")

    def shot(self, name):
        if SHOTS:
            self.browser.save_screenshot(os.path.join(SHOTS, f"{name}.png"))


@pytest.fixture
def page(browser, server):
    made = Page(browser, server)
    yield made
    errors = [entry["message"] for entry in browser.get_log("browser")
              if entry["level"] == "SEVERE" and "favicon" not in entry["message"]]
    # "inline style": from Chromium, when typing replaces coloured text in an editable element; the policy blocks it.
    known = ("ERR_CONNECTION_REFUSED", "400 (Bad Request)", "413", "422", "409", "WebSocket connection",
             "Failed to fetch", "Applying inline style")
    unknown = [each for each in errors if not any(word in each for word in known)]
    assert not unknown, unknown


def sheet(*nodes, **more):
    made = [{"id": i + 1, "name": name, "x": x, "y": y, "code": code, "values": {}, "parents": parents}
            for i, (name, x, y, code, parents) in enumerate(nodes)]
    return json.dumps({"format": "fieldfab sheet", "version": 1, "snap": 1, "nodes": made, "text": "", **more})


POINT = "return { x, y };"
CIRCLE = ("const [centre] = parents;\n"
          "return `move(circle(${mm(distance(centre, { x, y }))}), ${mm(centre.x)}, ${mm(centre.y)})`;")


def nodes_of(file):
    return {node["name"]: node for node in json.loads(file.read_text())["nodes"]}


def set_value(page, selector, value):
    page.script("const e = document.querySelector(arguments[0]); e.value = arguments[1]; "
                "e.dispatchEvent(new Event('change'))", selector, str(value))
