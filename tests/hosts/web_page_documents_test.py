"""Documents in fabserver's page: conflicts, documents that are only shown, texts that are too long, results that are no
longer those of the model, the gallery, links, downloads and their refusals."""

import contextlib
import json
import math
import os
import signal
import time

import numpy as np
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from web_page import Page, browser, folder, page, server, set_value, sheet
from web_server import Server, chromium

import fieldfab as ff

PLATE = "rounded_rectangle(30, 20, 3) - circle(5)\n"


def cards(page, host="#documents"):
    return [each.get_attribute("data-name") for each in page.browser.find_elements(By.CSS_SELECTOR, f"{host} .entry")]


def open_gallery(page, name):
    """Opens the gallery without a document, when it shows an entry."""
    page.open()
    page.until(lambda: name in cards(page) + cards(page, "#scans"), f"{name} in the gallery")


def act_on(page, name, words):
    page.act(f".entry[data-name='{name}'] .more", words)


def open_machine(page):
    page.settled()
    page.find("#machine").click()
    page.until(lambda: page.find("#panels [data-setting=diameter]").is_displayed(), "the panels")


def plan(page, button="#plan"):
    page.find(button).click()
    page.until(lambda: page.find("#job-time").is_displayed() or page.text("#job-message"), "a plan", 200)
    assert page.text("#job-message") == ""


def test_a_conflict_is_decided_by_buttons(page, folder):
    """Each version can be kept; until then, neither is lost."""
    file = folder / "conflict.frep"
    for answer, kept in (("Keep mine", "circle(4)"), ("Take theirs", "circle(8)\n")):
        file.write_text("circle(3)\n")
        page.open("conflict.frep")
        page.settled()
        file.write_text("circle(8)\n")
        page.type("#editor", Keys.CONTROL + "a", "circle(4)")
        page.saved("conflict")
        time.sleep(1)
        assert file.read_text() == "circle(8)\n" and "circle(4)" in page.text("#editor")
        page.press("#saved button", answer)
        page.saved()
        page.until(lambda: file.read_text() == kept and kept.strip() in page.text("#editor"), "the chosen version")


def test_a_job_that_changed_elsewhere_is_not_written_over(page, folder):
    """As with documents, the page asks whose version to keep."""
    (folder / "jobs.frep").write_text(PLATE)
    file = folder / "jobs.job"
    page.open("jobs.frep")
    open_machine(page)
    set_value(page, "#panels [data-setting=diameter]", 4)
    page.until(lambda: json.loads(file.read_text())["tools"][0]["diameter"] == 4, "the job's file")
    for answer, diameter in (("Keep mine", 2), ("Take theirs", 9)):
        theirs = json.loads(file.read_text())
        theirs["tools"][0]["diameter"] = 9
        file.write_text(json.dumps(theirs))
        set_value(page, "#panels [data-setting=diameter]", 2 if answer == "Keep mine" else 3)
        page.until(lambda: "The job was changed elsewhere" in page.text("#job-state"), "the question")
        time.sleep(1)
        assert json.loads(file.read_text()) == theirs, "it is not written over"
        page.shot("web_job_conflict")
        page.press("#job-state button", answer)
        page.until(lambda: page.text("#job-state") == "" and json.loads(file.read_text())["tools"][0]["diameter"]
                   == diameter == float(page.find("#panels [data-setting=diameter]").get_attribute("value")),
                   f"{answer}: the diameter")


def test_results_of_an_earlier_state_are_marked(page, folder):
    """After a change of the job or of the model there is no program to mill; after undo there is one again."""
    file = folder / "old.frep"
    file.write_text(PLATE)
    page.open("old.frep")
    open_machine(page)
    plan(page, "#simulate")
    assert page.find(".links-of-job").is_displayed() and "The simulation found" in page.find("#job-result").text
    set_value(page, "#panels [data-setting=diameter]", 2.5)
    page.until(lambda: "These results are of an earlier state" in page.find("#job-result").text, "the mark")
    assert not page.find(".links-of-job").is_displayed(), "no program"
    assert "The simulation found" not in page.find("#job-result").text, "no verdict"
    page.shot("web_old_results")
    set_value(page, "#panels [data-setting=diameter]", 3)
    page.until(lambda: page.find(".links-of-job").is_displayed(), "the program, as the job is what it was")
    assert "earlier state" not in page.find("#job-result").text
    page.find("#machine").click()
    page.type("#editor", Keys.CONTROL + "a", "circle(9)")
    page.saved()
    page.find("#machine").click()
    page.until(lambda: "These results are of an earlier state" in page.find("#job-result").text, "the other model")
    assert not page.find(".links-of-job").is_displayed()
    plan(page)
    page.until(lambda: page.find(".links-of-job").is_displayed(), "the program of the new model")


def test_a_document_of_a_newer_version_is_only_shown(page, folder):
    """No key changes it, its message stays, and nothing acts on it."""
    newer = sheet(version=2)
    (folder / "newer.json").write_text(newer)
    page.open("newer.json")
    page.until(lambda: "version 2" in page.text("#message"), "what is wrong")
    assert page.text("#saved") == "Not saved"
    page.type("#editor", "x", Keys.ENTER)
    time.sleep(1)
    assert "version 2" in page.text("#message") and "x" not in page.text("#editor .cm-line").split('"')[0]
    assert page.text("#saved") == "Not saved" and (folder / "newer.json").read_text() == newer
    assert [page.find(f"#{each}").is_enabled() for each in ("machine", "share", "download", "undo")] == [False] * 4
    page.shot("web_newer")
    (folder / "after.frep").write_text("circle(3)\n")
    page.script("location.hash = ''")
    page.open("after.frep")
    page.settled()
    page.type("#editor", Keys.CONTROL + "a", "circle(4)")
    page.until(lambda: (folder / "after.frep").read_text() == "circle(4)", "another document, which can be changed")


def test_a_job_of_a_newer_version_is_left_as_it_is(page, folder):
    """It is neither written nor planned; the job of the document before is not planned in its place."""
    (folder / "first.frep").write_text(PLATE)
    (folder / "second.frep").write_text(PLATE)
    for text, words in (('{"format": "fieldfab job", "version": 2}', "is of version 2; this page knows version 1"),
                        ("{", "second.job is not a job: "), ('{"format": "other"}', "is not a job of fabserver"),
                        ('{"format": "fieldfab job", "version": 1, "tools": 5}', "are not tables")):
        (folder / "second.job").write_text(text)
        page.open("first.frep")
        open_machine(page)
        page.find("#open").click()
        page.click(".card[data-name='second.frep']")
        page.settled()
        page.find("#machine").click()
        page.until(lambda: words in page.text("#job-message"), words)
        assert page.text("#job-state") == "The job is not saved"
        assert not page.find("#plan").is_enabled() and not page.find("#simulate").is_enabled()
        assert (folder / "second.job").read_text() == text


def paste(page, length):
    """Pastes a long comment at the end of the text."""
    page.script("""
      const editor = document.querySelector('#editor .cm-content'), data = new DataTransfer();
      editor.focus();
      data.setData('text/plain', ('# ' + 'x'.repeat(97) + '\\n').repeat(arguments[0] / 100));
      editor.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
    """, length)


def test_a_text_of_five_megabytes(page, folder, server):
    """The page says that it is not saved. What neither file nor browser takes is not left without a question."""
    file = folder / "heavy.frep"
    file.write_text("circle(5)\n")
    page.open("heavy.frep")
    page.settled()
    page.type("#editor", Keys.CONTROL + Keys.END)
    paste(page, 2_000_000)
    page.until(lambda: "The text has 2 MB: texts with more than 1 MB are not shown" in page.text("#message"), "2 MB")
    page.saved()
    page.until(lambda: file.stat().st_size > 2_000_000, "2 MB in the file")
    paste(page, 5_000_000)
    page.until(lambda: "documents with more than 4 MB are not saved" in page.text("#message"), "7 MB")
    page.saved("refused")
    assert "4,000,000 are possible" in page.text("#saved")
    assert "closing this page loses the changes" in page.text("#saved"), "the browser's storage has no space for it"
    assert file.stat().st_size < 2_100_000
    page.shot("web_heavy")
    (folder / "light.frep").write_text("circle(5)\n")
    page.find("#open").click()
    page.click(".card[data-name='light.frep']")
    page.answer("“heavy.frep” are not saved, and would be lost", "Stay")
    page.find("#close-gallery").click()
    page.find("#undo").click()
    page.saved()
    page.until(lambda: "documents with more" not in page.text("#message"), "the text before")
    port = server[0].port
    server[0].kill()
    paste(page, 5_000_000)
    page.saved("lost")
    assert "keep this page open" in page.text("#saved")
    server[0] = Server(folder, port=port)
    page.saved("refused")
    page.find("#undo").click()
    page.saved()


def test_documents_are_renamed_copied_and_deleted(page, folder):
    """With their jobs and undo histories; a deletion can be undone."""
    file, job = folder / "old name.frep", '{"format": "fieldfab job", "version": 1}'
    file.write_text("circle(3)\n")
    (folder / "old name.job").write_text(job)
    page.open("old%20name.frep")
    page.settled()
    page.type("#editor", Keys.CONTROL + "a", "circle(4)")
    page.saved()
    page.find("#open").click()
    page.until(lambda: "old name.frep" in cards(page), "the gallery")
    act_on(page, "old name.frep", "Rename …")
    page.until(lambda: page.find("#question-text").is_displayed(), "the question for a name")
    page.find("#question-text").send_keys(Keys.CONTROL + "a")
    page.find("#question-text").send_keys("../evil", Keys.ENTER)
    page.until(lambda: "cannot be the name of a document" in page.text("#gallery-told"), "a bad name")
    assert file.read_text() == "circle(4)"
    act_on(page, "old name.frep", "Rename …")
    page.until(lambda: page.find("#question-text").is_displayed(), "the question for a name")
    page.find("#question-text").send_keys(Keys.CONTROL + "a")
    page.find("#question-text").send_keys("new name", Keys.ENTER)
    page.until(lambda: page.text("#name") == "new name.frep", "the new name")
    assert not file.exists() and (folder / "new name.frep").read_text() == "circle(4)"
    assert not (folder / "old name.job").exists() and (folder / "new name.job").read_text() == job
    page.find("#undo").click()
    page.until(lambda: (folder / "new name.frep").read_text() == "circle(3)\n", "its undo history")
    page.saved()

    page.find("#open").click()
    page.until(lambda: "new name.frep" in cards(page), "the gallery")
    act_on(page, "new name.frep", "Duplicate")
    page.until(lambda: "new name 2.frep" in cards(page), "the copy")
    assert (folder / "new name 2.frep").read_text() == "circle(3)\n" and (folder / "new name 2.job").read_text() == job
    page.shot("web_gallery")
    act_on(page, "new name 2.frep", "Delete")
    page.until(lambda: "“new name 2.frep” is deleted, and its job" in page.text("#gallery-told"), "the deletion")
    assert "new name 2.frep" not in cards(page) and not (folder / "new name 2.frep").exists()
    assert not (folder / "new name 2.job").exists()
    page.find("#gallery-told button").click()
    page.until(lambda: "new name 2.frep" in cards(page), "it is back")
    assert (folder / "new name 2.frep").read_text() == "circle(3)\n" and (folder / "new name 2.job").read_text() == job


def test_without_a_document_nothing_acts_on_one(page, folder):
    """Also after the open document was deleted."""
    (folder / "gone.frep").write_text("circle(3)\n")
    buttons = ("machine", "share", "download", "undo", "redo")
    open_gallery(page, "gone.frep")
    page.find("#close-gallery").click()
    page.until(lambda: page.find("#empty").is_displayed(), "a line that says so")
    assert [page.find(f"#{each}").is_enabled() for each in buttons] == [False] * 5
    page.find("#open-empty").click()
    page.click(".card[data-name='gone.frep']")
    page.settled()
    assert [page.find(f"#{each}").is_enabled() for each in buttons] == [True] * 5 and not page.find(
        "#empty").is_displayed()
    page.find("#open").click()
    page.until(lambda: "gone.frep" in cards(page), "the gallery")
    act_on(page, "gone.frep", "Delete")
    page.until(lambda: "is deleted" in page.text("#gallery-told"), "the deletion")
    page.find("#close-gallery").click()
    page.until(lambda: page.find("#empty").is_displayed(), "no document")
    assert [page.find(f"#{each}").is_enabled() for each in buttons] == [False] * 5
    time.sleep(1)
    assert not (folder / "gone.frep").exists()


def test_scans_of_the_folder_are_in_the_gallery(page, folder):
    """One becomes a text; one is deleted after a question."""
    at = np.indices((16, 16, 16)) - 7.5
    ball = ff.Volume(np.clip(100 + 40 * (5 - np.sqrt((at**2).sum(axis=0))), 0, 200).astype(np.float32))
    ball.save(folder / "there.nii.gz")
    ball.save(folder / "other.nii.gz")
    open_gallery(page, "there.nii.gz")
    act_on(page, "other.nii.gz", "Delete")
    page.answer("cannot be brought back", "Keep it")
    act_on(page, "other.nii.gz", "Delete")
    page.answer("cannot be brought back", "Delete")
    page.until(lambda: "other.nii.gz" not in cards(page, "#scans"), "one scan less")
    assert not (folder / "other.nii.gz").exists()
    page.find(".entry[data-name='there.nii.gz'] .card").click()
    page.until(lambda: page.find("#histogram svg").is_displayed(), "the histogram")
    assert 'open("there.nii.gz", threshold = level)' in (folder / "there.frep").read_text()


def test_an_upload_is_cancelled(page, folder, tmp_path):
    """The page's own button ends it; nothing stays of it."""
    with open(tmp_path / "huge.nii", "wb") as file:
        file.truncate(900_000_000)
    page.open()
    page.until(lambda: page.find("#new-scan").is_displayed(), "the gallery")
    page.browser.execute_cdp_cmd("Network.enable", {})
    page.browser.execute_cdp_cmd("Network.emulateNetworkConditions", {
        "offline": False, "latency": 0, "downloadThroughput": -1, "uploadThroughput": 2_000_000})
    try:
        page.find("#scan-file").send_keys(str(tmp_path / "huge.nii"))
        page.until(lambda: "%" in page.text("#gallery-told"), "its progress")
        page.find("#gallery-told button").click()
        page.until(lambda: page.find("#new-scan").is_enabled() and not page.find("#gallery-told").is_displayed(),
                   "the end of it")
        page.until(lambda: not [each for each in os.listdir(folder) if each.startswith((".upload", "huge"))],
                   "no rest of it")
    finally:
        page.browser.execute_cdp_cmd("Network.emulateNetworkConditions", {
            "offline": False, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1})


def test_downloads_are_cancelled_or_say_what_is_wrong(page, folder):
    (folder / "slow.frep").write_text("# empty\n")
    page.open("slow.frep")
    page.until(lambda: page.text("#name") == "slow.frep", "the document")
    page.type("#editor", Keys.CONTROL + "a", Keys.DELETE)
    page.saved()
    page.act("#download", "stl")
    page.until(lambda: "There is nothing to download as stl" in page.text("#notice"), "what is wrong")
    page.type("#editor", "spheree(5)")
    page.saved()
    page.act("#download", "stl")
    page.until(lambda: page.text("#notice-words").startswith("No stl file: ") and len(page.text("#notice-words")) > 20,
               "the mistake")
    # Minutes of work, if it is not ended.
    page.type("#editor", Keys.CONTROL + "a", "gyroid(1) & box(120, 120, 120)")
    page.saved()
    page.act("#download", "stl")
    page.until(lambda: page.find("#stop-download").is_displayed(), "the button that ends it")
    page.shot("web_download")
    page.find("#stop-download").click()
    page.until(lambda: not page.find("#download-running").is_displayed(), "the end of it")
    assert "No stl file" not in page.text("#notice")


def test_share_copies_a_link_and_tells_where_it_leads(page, folder):
    (folder / "given.frep").write_text("circle(6)\n")
    page.open("given.frep")
    page.settled()
    page.browser.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite"]})
    page.find("#share").click()
    told = lambda: page.text("#notice") + page.text("#question-words")
    page.until(lambda: "A link that holds this model" in told(), "the link")
    assert "It names this machine (127.0.0.1:" in told()
    link = (page.find("#question-text").get_attribute("value") if page.find("#question").is_displayed()
            else page.browser.execute_async_script("navigator.clipboard.readText().then(arguments[0])"))
    (folder / "given.frep").unlink()
    page.browser.get("about:blank")
    page.browser.get(link)
    page.answer("“given.frep”", "Add it")
    page.settled()
    assert abs(page.coloured() / (math.pi * 36) - 1) < 0.02
    assert (folder / "given.frep").read_text() == "circle(6)\n"
    page.open("share=garbage")
    page.answer("This link holds no model", "OK")


def test_a_plan_whose_server_goes_away(page, folder, server):
    """The page says so; the next plan is made when the server is back."""
    (folder / "away.frep").write_text(PLATE)
    page.open("away.frep")
    open_machine(page)
    page.script("window.kept = window.fetch; window.fetch = (path, ...rest) => "
                "(String(path).startsWith('/api/jobs/') ? new Promise((_, no) => setTimeout(() => "
                "no(new TypeError('gone')), 3000)) : window.kept(path, ...rest))")
    port = server[0].port
    page.find("#plan").click()
    page.until(lambda: page.find("#job-running").is_displayed(), "the plan")
    time.sleep(0.5)
    server[0].kill()
    page.until(lambda: "The server went away during the plan" in page.text("#job-message"), "what happened")
    assert page.find("#plan").is_enabled()
    server[0] = Server(folder, port=port)
    page.script("window.fetch = window.kept")
    page.until(lambda: not page.find("#away").is_displayed(), "the server")
    plan(page)


def test_a_stopped_plan_is_no_mistake(page, folder):
    (folder / "long.frep").write_text("gyroid(6) & box(60, 60, 30)\n")
    page.open("long.frep")
    open_machine(page)
    page.find("#simulate").click()
    page.until(lambda: page.find("#stop-job").is_displayed(), "the button")
    page.find("#stop-job").click()
    page.until(lambda: "You stopped the plan." in page.text("#job-result"), "a line")
    assert page.text("#job-message") == ""


def test_a_program_is_downloaded_by_a_click(page, folder, tmp_path):
    (folder / "clicked.frep").write_text(PLATE)
    page.open("clicked.frep")
    open_machine(page)
    plan(page)
    page.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(tmp_path)})
    page.press("#job-result a", "Program")
    page.until(lambda: (tmp_path / "clicked.ngc").exists() and "G1" in (tmp_path / "clicked.ngc").read_text(),
               "the program")


def test_names_and_comments_of_others_never_become_html(page, folder):
    """Names of documents, parts and parameters, comments, and texts of jobs."""
    evil = "<img src=x onerror=document.title='evil'><b id=bold>"
    (folder / "evil.frep").write_text(f'r = 5  # 1 to 9, {evil}\npart(sphere(r), "{evil}", "red")\n'
                                      'part(move(sphere(1), 9), "small")\n')
    (folder / "evil.job").write_text(json.dumps({
        "format": "fieldfab job", "version": 1, "machine": evil, "material": evil, "zero": evil,
        "tools": [{"number": 1, "shape": evil, "diameter": 3, "name": evil}],
        "operations": [{"type": evil, "tool": 1, "direction": evil}]}))
    page.open("evil.frep")
    page.settled()
    page.find("#picture").send_keys("2")
    page.settled()
    ActionChains(page.browser).move_to_element_with_offset(page.find("#picture"), -60, 0).click().perform()
    page.until(lambda: evil in page.text("#picture .told"), "the part's name, as text")
    assert evil in page.find("#sliders label").get_attribute("title")
    page.find("#machine").click()
    page.until(lambda: page.find("#panels select").is_displayed(), "the panels")
    page.find("#plan").click()
    page.until(lambda: page.text("#job-message"), "what is wrong")
    page.find("#open").click()
    page.until(lambda: "evil.frep" in cards(page), "the gallery")
    found = page.script("return [...document.querySelectorAll('#bold, img')].map((e) => e.outerHTML)"
                        ".filter((e) => e.includes('bold') || e.includes('onerror'))")
    assert found == [] and "evil.frep" in page.browser.title


def test_each_example_opens_without_a_mistake(page, folder):
    open_examples = "#examples .card"
    page.open()
    page.until(lambda: page.find(open_examples).is_displayed(), "the examples")
    names = [each.get_attribute("data-name") for each in page.browser.find_elements(By.CSS_SELECTOR, open_examples)]
    assert len(names) > 5
    for name in names:
        if not page.find("#gallery").is_displayed():
            page.find("#open").click()
        page.until(lambda: page.find(open_examples).is_displayed(), "the examples")
        page.script("document.querySelector(`#examples .card[data-name='${arguments[0]}']`).click()", name)
        page.until(lambda: page.text("#name").split(".")[0].split(" ")[0] == name.split(".")[0].split(" ")[0], name)
        page.until(lambda: not page.find("#gallery").is_displayed(), "the document")
        time.sleep(0.3)  # the code of nodes runs first
        page.settled()
        assert page.text("#message") == "" == page.text("#sheet-message"), name
        assert not page.browser.find_elements(By.CSS_SELECTOR, ".node.wrong"), name


def test_late_results_of_a_sheet_do_not_reach_the_next_document(page, folder):
    """The code of nodes may take a second; by then another document may be open."""
    slow = "const end = Date.now() + 700; while (Date.now() < end); return 'circle(5)';"
    (folder / "late.json").write_text(sheet(("Slow", 0, 0, slow, [])))
    (folder / "next.frep").write_text("circle(8)\n")
    page.open("next.frep")
    page.settled()
    page.find("#open").click()
    page.until(lambda: {"late.json", "next.frep"} <= set(cards(page)), "the gallery")
    page.script("""
      const open = (name) => document.querySelector(`#documents .card[data-name='${name}']`).click();
      open('late.json');
      const seen = setInterval(() => {
        if (document.getElementById('name').textContent !== 'late.json') return;
        clearInterval(seen);
        open('next.frep');
      }, 1);""")
    page.until(lambda: page.script("return document.getElementById('name').textContent") == "next.frep"
               and page.text("#editor .cm-content").startswith("circle(8)"), "the next document")
    time.sleep(2)
    page.settled()
    assert abs(page.coloured() / (math.pi * 64) - 1) < 0.02
    assert (folder / "next.frep").read_text() == "circle(8)\n"


def test_a_browser_that_is_killed_loses_nothing_that_is_told_to_be_saved(folder, server, tmp_path):
    """SIGKILL of the browser: with a server, what was typed is in the file; without one, in the browser's storage,
    which Chromium writes some seconds later, and the page writes it to the file when both are back."""
    file = folder / "killed.frep"
    file.write_text("circle(3)\n")

    def type_and_kill(text, wait):
        with chromium(tmp_path / "profile") as driver:
            page = Page(driver, server)
            page.open("killed.frep")
            page.settled()
            if wait == "away":
                server[0].kill()
            page.type("#editor", Keys.CONTROL + "a", text)
            page.saved(wait)
            if wait == "away":
                time.sleep(10)
            for process in browsers(tmp_path / "profile"):
                os.kill(process, signal.SIGKILL)
            with contextlib.suppress(Exception):  # the driver's, which finds no browser
                driver.quit()

    type_and_kill("circle(4)", "saved")
    assert file.read_text() == "circle(4)"
    port = server[0].port
    type_and_kill("circle(6)", "away")
    assert file.read_text() == "circle(4)"
    server[0] = Server(folder, port=port)
    with chromium(tmp_path / "profile") as driver:
        page = Page(driver, server)
        page.open("killed.frep")
        page.until(lambda: file.read_text() == "circle(6)", "what was typed without a server")


def browsers(profile):
    """Returns the processes of the browsers that use a profile."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            words = open(f"/proc/{name}/cmdline").read().split("\0")
            if f"--user-data-dir={profile}" in words and "chromedriver" not in words[0]:
                found.append(int(name))
    return found
