"""Measures how soon the page of `fieldfab serve` is usable in Chromium: from opening its address with a document to the
first picture, with an empty cache and with a filled one. Prints percentiles, and the compressed size of the page.

    PYTHONPATH=build/release/python python3 tests/bench/web_page.py [TIMES]
"""

import pathlib
import shutil
import sys
import tempfile
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "hosts"))
from conftest import BUILD
from web_server import Server, chromium

SHOWN = "return document.querySelector('#picture')?.dataset.shown ? performance.now() : 0"


def first_picture(driver, address):
    """Returns the time from the start of the navigation to the first picture, ms."""
    driver.get("about:blank")
    driver.get(address)
    while not (now := driver.execute_script(SHOWN)):
        time.sleep(0.005)
    return now


def main():
    times = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    folder = BUILD / "python" / "fieldfab" / "serve" / "page"
    sizes = {path.name: len(zlib.compress(path.read_bytes(), 9)) for path in folder.iterdir()
             if path.suffix != ".gz"}
    print(f"{sum(sizes.values()) / 1000:.0f} kB compressed: "
          + ", ".join(f"{name} {size / 1000:.0f}" for name, size in sorted(sizes.items(), key=lambda each: -each[1])))
    with tempfile.TemporaryDirectory() as documents, chromium() as driver:
        shutil.copy(ROOT / "examples" / "bracket.frep", documents)
        server = Server(documents)
        try:
            for cache in ("empty", "filled"):
                found = []
                for _ in range(times):
                    if cache == "empty":
                        driver.execute_cdp_cmd("Network.clearBrowserCache", {})
                    found.append(first_picture(driver, f"{server.address}#bracket.frep"))
                found.sort()
                shares = {name: found[min(times - 1, int(share * times))]
                          for name, share in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99))}
                print(f"{cache} cache: first picture after "
                      + ", ".join(f"{each:.0f} ms ({name})" for name, each in shares.items()))
        finally:
            server.end()


if __name__ == "__main__":
    main()
