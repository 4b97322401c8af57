#!/usr/bin/env python3
"""The page of `patina watch --render` in a browser, opened as a file: it shows the picture, follows each change by
itself, and says what is wrong.

    live_page_test.py PATINA     PATINA: the program
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import browser

GRAPH = '{{ "patina": 1, "workflow": "unlit", "surface": {{ "color": {} }} }}\n'
RED, GREEN = "[1, 0, 0]", "[0, 1, 0]"
SHOWN = """
    const image = document.querySelector("img");
    return { title: document.title, wrong: document.body.className === "wrong", text: document.querySelector("pre").innerText,
             width: image.complete ? image.naturalWidth : 0, source: image.getAttribute("src") };"""


class LivePage(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)
        self.graph = self.folder / "a b.graph.json"

    def watch(self, size):
        command = [PATINA, "watch", self.graph.name, "-o", "out", "--render", "look #1.png", "--size", str(size), "--samples", "1",
                   "--via", "cpu"]
        watching = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

        def end():
            watching.terminate()
            watching.wait()
        self.addCleanup(end)
        return end

    def shows(self, page, wanted):
        """Waits until the page is as wanted; then what it shows."""
        end = time.monotonic() + 60
        while not wanted(now := page.run(SHOWN)):
            self.assertLess(time.monotonic(), end, f"the page shows {now}")
            time.sleep(0.2)
        return now

    def color(self, page):
        return page.picture(page.find("img")).at(0.5, 0.5)

    def test_the_page_follows_what_is_watched(self):
        self.graph.write_text(GRAPH.format(RED))
        end = self.watch(48)
        while not (self.folder / "look #1.js").exists():
            time.sleep(0.1)
        with browser.Browser() as page:
            page.open((self.folder / "look #1.html").as_uri())
            first = self.shows(page, lambda now: now["width"] == 48)
            self.assertEqual((first["title"], first["wrong"]), (self.graph.name, False))
            self.assertEqual(self.color(page), (255, 0, 0))

            self.graph.write_text(GRAPH.format(GREEN))
            second = self.shows(page, lambda now: now["source"] != first["source"])
            self.assertIn("compiled", second["text"])
            self.assertIn("instructions", second["text"])
            self.assertEqual(self.color(page), (0, 255, 0))

            self.graph.write_text(GRAPH.format('"nothing"'))
            wrong = self.shows(page, lambda now: now["wrong"])
            self.assertIn(self.graph.name + ":1:", wrong["text"])
            self.assertEqual(wrong["source"], second["source"])
            self.graph.write_text(GRAPH.format(RED))
            self.shows(page, lambda now: not now["wrong"] and now["source"] != second["source"])

            # A page that is open goes on with the next run.
            end()
            self.watch(64)
            self.shows(page, lambda now: now["width"] == 64)
            self.assertEqual(page.errors(), [])


if __name__ == "__main__":
    if (program := browser.missing()) is not None:
        print(f"skipped: there is no {program}; scripts/setup installs it")
        sys.exit(0)
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
