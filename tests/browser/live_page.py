#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tries the page of --serve in a real browser: live_page.py PROGRAM [FOLDER]

Needs Chromium, so that it is no part of the suite. Waits for a pass, compares a pixel's values on the page
with those that the program serves, looks through tones and layers, zooms, saves, stops, and looks for what
the browser complains of. Pictures of the page go to FOLDER.
"""
import re
import struct
import subprocess
import sys
import tempfile
import urllib.request
from pathlib import Path

from browser import Browser

ROOT = Path(__file__).resolve().parents[2]


def expect(condition, text):
    if not condition:
        sys.exit(f"live_page.py: {text}")


def start(program, picture, *options):
    """A render that takes hours, and where its page is."""
    render = subprocess.Popen(
        [program, "render", ROOT / "scenes" / "still-life.pbrt", "-r", "400", "300", "-s", "400000", "-q",
         "-o", picture, "--serve=0", *options], stderr=subprocess.PIPE, text=True)
    return render, re.search(r"http://\S+", render.stderr.readline())[0]


def stop(browser):
    browser.value("$('stop').click()")
    browser.wait("isGone")


def check_tiles(browser, program, folder):
    """Tiles, of several passes, make the picture that is saved."""
    render, address = start(program, f"{folder}/tiles.pfm")
    try:
        browser.open(address)
        browser.wait("document.readyState === 'complete' && picture?.version > 2000")
        stop(browser)
        expect(render.wait(20) == 130, "the program did not end as after Ctrl-C")
        shown = browser.value("[...picture.values]")
        size = 400 * 300 * 3
        rows = Path(f"{folder}/tiles_partial.pfm").read_bytes()[-4 * size:]
        saved = struct.unpack(f"<{size}f", rows)
        saved = [value for y in reversed(range(300)) for value in saved[1200 * y:1200 * (y + 1)]]
        expect(shown == saved, "the page does not show what is saved")
    finally:
        render.kill()


def served(address, width, x, y):
    """The colour of a pixel, and the version of the picture that it is of."""
    with urllib.request.urlopen(f"{address}picture") as answer:
        color = struct.unpack_from("<3f", answer.read(), 12 * (y * width + x))
        return color, answer.headers["Picture-Version"]


def check_pixel(browser, address):
    """What stands below the picture is what the program has, where no pass comes between."""
    for _ in range(50):
        browser.point(640, 420)
        values, version = served(address, 400, *browser.value("(({x, y}) => [x, y])(pixelAt(pointer))"))
        shown = browser.value("showPixel(), [picture.version, $('pixel').textContent]")
        if str(shown[0]) == version:
            break
    numbers = [float(word) for word in re.findall(r"[RGB] (\S+)", shown[1])]
    expect(len(numbers) == 3 and all(abs(a - b) <= 1e-4 * abs(b) for a, b in zip(numbers, values)),
           f"the page shows {shown[1]}, the program has {values}")


def choose(browser, layer):
    browser.value(f"$('layer').value = '{layer}', $('layer').dispatchEvent(new Event('change'))")
    browser.wait(f"picture.layer === '{layer}'")


def check(browser, address, shoot):
    browser.open(address)
    browser.wait("document.readyState === 'complete' && picture?.version > 0")
    shoot("first")
    check_pixel(browser, address)
    browser.value("$('tone').value = 'false-color', expose(2)")
    shoot("false-colour")
    browser.value("$('tone').value = 'color', expose(0)")
    for layer in browser.value("state.layers.map(layer => layer.name)"):
        choose(browser, layer)
        shoot(layer)
    choose(browser, "beauty")
    before = browser.value("view.zoom")
    browser.point(640, 420, "mouseWheel", deltaX=0, deltaY=-1000)
    browser.wait(f"view.zoom > 10 * {before}")
    shoot("zoomed")
    browser.value("act('f')")
    browser.value("window.make = URL.createObjectURL;"
                  "URL.createObjectURL = blob => make(window.saved = blob)")
    browser.value("$('save').click()")
    size = len("PF\n400 300\n-1.0\n") + 12 * 400 * 300
    expect(browser.value("saved.size") == size, "the saved file has another size")
    stop(browser)
    shoot("stopped")
    expect("was stopped" in browser.value("$('message').textContent"), "the page does not say how it ended")
    faults = [fault for fault in browser.faults() if "ERR_CONNECTION" not in fault]
    expect(not faults, f"the browser complains: {faults}")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    pictures = Path(sys.argv[2]) if len(sys.argv) == 3 else None
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        check_tiles(browser, sys.argv[1], folder)
        render, address = start(sys.argv[1], f"{folder}/still-life.exr", "--layers=all")
        try:
            check(browser, address, lambda name: pictures and browser.screenshot(pictures / f"{name}.png"))
            expect(render.wait(20) == 130, "the program did not end as after Ctrl-C")
            expect(Path(f"{folder}/still-life_partial.exr").exists(), "the picture is not there")
        finally:
            render.kill()
    print("the page does what it should")


if __name__ == "__main__":
    main()
