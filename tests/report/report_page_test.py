"""Opens the page of `patina snapshot --report` in a browser: its pictures are seen, the slider moves, both themes can be
read, and it asks for no other file. Usage: report_page_test.py PATINA"""
import math
import os
import subprocess
import sys
import tempfile
import unittest

import browser

PATINA = ""

# A ball of one colour, without light: what its pixels are follows from the transfer function of sRGB.
GREY, GREY_BYTES = "0.5", (188, 188, 188)  # 255 (1.055 0.5^(1 / 2.4) - 0.055) = 187.5
RED, RED_BYTES = "[1, 0, 0]", (255, 0, 0)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def ball(color):
    return '{ "patina": 1, "workflow": "unlit", "surface": { "color": %s } }' % color


def snapshot(*arguments):
    return subprocess.run([PATINA, "snapshot", "art", *arguments], capture_output=True, text=True, check=False)


def luminance(color):
    linear = [c / 255 / 12.92 if c / 255 <= 0.04045 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in color]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    """WCAG 2.1: 4.5 is the least for text."""
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)
        for name in ("changed", "same", "new"):
            write(f"art/{name}.graph.json", ball(GREY))
        write("art/changed.snapshot.json", '{ "patina": 1, "size": 32, "text": true }')
        write("art/<b>broken.graph.json", ball(GREY))
        assert snapshot("--update").returncode == 0
        os.remove("art/new.reference.png")
        write("art/changed.graph.json", ball(RED))
        write("art/<b>broken.graph.json", ball('"<script>alert(1)</script>"'))
        cls.result = snapshot("--report", "report.html")
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.open("file://" + os.path.abspath("report.html"))

    def test_the_run_fails_and_the_page_is_there(self):
        self.assertEqual(self.result.returncode, 1, self.result.stderr)
        self.assertIn("1 passed, 2 failed, 1 missing", self.result.stdout)

    def test_every_picture_is_seen_and_no_other_file_is_asked_for(self):
        pictures = self.browser.run("""
            for (const each of document.images) each.loading = "eager";
            return Promise.all([...document.images].map(each => each.decode())).then(() =>
                [...document.images].map(each => [each.closest("[data-case]").dataset.case, each.naturalWidth]))""")
        # Of the changed one: both in the slider, reference, received, difference. One of the new and of the same.
        self.assertEqual(sorted(pictures), [["failed", 32]] * 5 + [["missing", 128], ["passed", 128]])
        asked = self.browser.run("return performance.getEntriesByType('resource').map(each => each.name)")
        self.assertEqual([each for each in asked if not each.startswith("data:")], [])
        self.assertEqual(self.browser.errors(), [])

    def test_the_slider_moves_between_both_pictures(self):
        slider = self.browser.find(".slider")
        width = self.browser.run("return arguments[0].getBoundingClientRect().width", slider)
        before = self.browser.picture(slider)
        self.assertEqual(before.at(0.3, 0.5), GREY_BYTES)
        self.assertEqual(before.at(0.7, 0.5), RED_BYTES)
        self.browser.drag(slider, 0, 0.35 * width)  # to 85 %
        right = self.browser.picture(slider)
        self.assertEqual([right.at(0.3, 0.5), right.at(0.7, 0.5)], [GREY_BYTES] * 2)
        self.browser.drag(slider, 0.35 * width, -0.35 * width)  # to 15 %
        left = self.browser.picture(slider)
        self.assertEqual([left.at(0.3, 0.5), left.at(0.7, 0.5)], [RED_BYTES] * 2)

    def test_the_difference_is_red_where_the_pictures_differ_and_black_elsewhere(self):
        difference = self.browser.picture(self.browser.find("figure:nth-of-type(4) .picture"))
        self.assertEqual(difference.at(0.5, 0.5), (255, 0, 0))
        self.assertEqual(difference.at(0.02, 0.02), (0, 0, 0))

    def test_figures_cost_and_the_text_that_changed_are_shown(self):
        card = self.browser.run("return document.querySelector('[id=changed]').innerText")
        for each in ("share", "average", "tile", "perceptual", "bytes of SPIR-V", "changed lines", "0.1 %"):
            self.assertIn(each, card)
        added, removed = self.browser.run("""
            return [".added", ".removed"].map(css => [...document.querySelectorAll(css)].map(e => e.innerText).join())""")
        self.assertIn("vec4(1.0, 0.0, 0.0, 1.0)", added)
        self.assertIn("0.5", removed)
        self.assertEqual(self.browser.run("return document.querySelectorAll('tr.over').length"), 4)

    def test_bars_are_as_long_as_their_figures(self):
        rows = self.browser.run("""
            return [...document.querySelectorAll("[id=changed] tbody tr")].map(row =>
                [row.cells[3].innerText, row.querySelector(".meter i").style.width])""")
        self.assertEqual(len(rows), 4)
        for figure, width in rows:
            wanted = min(max(50 + 25 * math.log10(float(figure)), 0), 100)
            self.assertAlmostEqual(float(width.rstrip("%")), wanted, delta=1.5, msg=figure)
        self.assertGreater(len({width for _, width in rows}), 1, rows)

    def test_the_title_names_the_folder(self):
        self.assertEqual(self.browser.run("return document.title"), "Snapshots of art")
        result = subprocess.run([PATINA, "snapshot", ".", "--report", "../here.html"], cwd="art", capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.browser.open("file://" + os.path.abspath("here.html"))
        self.assertEqual(self.browser.run("return document.querySelector('h1').innerText"), "Snapshots of art")

    def test_names_and_messages_are_text(self):
        self.assertEqual(self.browser.run("return document.querySelectorAll('main script, h2 b').length"), 0)
        self.assertIn("<script>alert(1)</script>", self.browser.run("return document.body.innerText"))

    def test_buttons_show_one_kind_of_case(self):
        shown = "return [...document.querySelectorAll('[data-case]')].filter(e => !e.hidden).map(e => e.dataset.case)"
        self.assertEqual(len(self.browser.run(shown)), 4)
        missing = self.browser.find("button[data-state=missing]")
        self.browser.click(missing)
        self.assertEqual(self.browser.run(shown), ["missing"])
        self.browser.click(missing)
        self.assertEqual(len(self.browser.run(shown)), 4)

    def test_both_themes_can_be_read(self):
        colors = """
            const rgb = (each, key) => getComputedStyle(each)[key].match(/[0-9.]+/g).slice(0, 3).map(Number);
            const card = rgb(document.querySelector(".card"), "backgroundColor");
            return ["h2", ".file", ".state.failed", ".state.missing", ".message", "td.note", "figcaption", "h3",
                    "tr.over td.number"].map(css => [css, rgb(document.querySelector(css), "color"), card])"""
        grounds = []
        for _ in range(2):
            grounds.append(self.browser.run("""
                return getComputedStyle(document.body).backgroundColor.match(/[0-9]+/g).map(Number)"""))
            for css, text, ground in self.browser.run(colors):
                self.assertGreaterEqual(contrast(text, ground), 4.5, f"{css} on {ground}")
            self.browser.click(self.browser.find("#theme"))
        self.assertGreater(contrast(*grounds), 10, "a dark and a light page")

    def test_a_narrow_page_does_not_scroll_sideways(self):
        self.browser.call("POST", "/window/rect", {"width": 500, "height": 900})
        width, room = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.browser.call("POST", "/window/rect", {"width": 1200, "height": 900})
        self.assertLessEqual(width, room)


if __name__ == "__main__":
    if (program := browser.missing()) is not None:
        print(f"skipped: there is no {program}; scripts/setup installs it")
        sys.exit(0)
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
