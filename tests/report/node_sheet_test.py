"""Opens the page of `patina nodes --sheet` in a browser: every node of the library is there in its category, with a picture
or its formula; a search chooses. Usage: node_sheet_test.py PATINA"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import browser

PATINA = ""


def patina(*arguments):
    return subprocess.run([PATINA, *arguments], capture_output=True, text=True, check=False)


class NodeSheet(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)
        cls.result = patina("nodes", "--sheet", "nodes.html")
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.open("file://" + os.path.abspath("nodes.html"))

    def test_every_node_is_in_its_category(self):
        self.assertEqual((self.result.returncode, self.result.stderr), (0, ""))
        known = {}
        for node in json.loads(patina("nodes", "--json").stdout):
            known.setdefault(node["category"], []).append(node["name"])
        shown = self.browser.run("""
            return [...document.querySelectorAll("section")].map(each => [each.querySelector("h2").textContent,
                [...each.querySelectorAll("figure")].map(figure => figure.id)])""")
        self.assertEqual(shown, [[category, names] for category, names in known.items()])

    def test_every_node_shows_something(self):
        tiles = self.browser.run("""
            for (const each of document.images) each.loading = "eager";
            return Promise.all([...document.images].map(each => each.decode())).then(() =>
                [...document.querySelectorAll("figure")].map(each => [each.id, each.querySelectorAll("img").length,
                    each.querySelectorAll("svg polyline").length, each.querySelector("pre")?.textContent.trim() ?? ""]))""")
        kinds = {name: ("picture" if images else "plot" if lines else "text") for name, images, lines, _ in tiles}
        self.assertEqual([name for name, images, lines, text in tiles if not images and not lines and not text], [])
        self.assertEqual([kinds[name] for name in ("Checker", "BlendColors", "Normal", "LambertBrdf", "Sine", "Color")],
                         ["picture", "picture", "picture", "plot", "plot", "text"])
        self.assertGreater(sum(kind != "text" for kind in kinds.values()), len(kinds) * 0.7)
        asked = self.browser.run("return performance.getEntriesByType('resource').map(each => each.name)")
        self.assertEqual([each for each in asked if not each.startswith("data:")], [])
        self.assertEqual(self.browser.errors(), [])
        ids = self.browser.run("return [...document.querySelectorAll('[id]')].map(each => each.id)")
        self.assertEqual(len(ids), len(set(ids)))

    def test_pictures_and_plots_show_the_values(self):
        # albedo / pi, over albedo
        words = self.browser.run("""
            return [...document.querySelectorAll("#LambertBrdf svg text")].map(each => each.textContent)""")
        self.assertEqual(words, ["0.318", "0", "0", "1", "albedo"])
        points = self.browser.run("""
            return document.querySelector("#LambertBrdf polyline").getAttribute("points").split(" ").map(each =>
                each.split(",").map(Number))""")
        (left, low), (middle, half), (right, high) = points[0], points[len(points) // 2], points[-1]
        self.assertLess(high, low, "it rises")
        self.assertAlmostEqual((left + right) / 2, middle, delta=0.2)
        self.assertAlmostEqual((low + high) / 2, half, delta=0.2)
        # A normal that points to the camera is (0, 0, 1): 0.5, 0.5 and 1 in the range -1 to 1. The numbers stand as they are.
        image = self.browser.run("return document.querySelector('#Normal img')")
        self.browser.run("arguments[0].scrollIntoView()", image)
        for value, expected in zip(self.browser.picture(image).at(0.5, 0.5), (128, 128, 255)):
            self.assertAlmostEqual(value, expected, delta=6)

    def test_a_node_that_changes_colours_shows_them_before_and_after(self):
        texts = self.browser.run("return [...document.querySelectorAll('figure:has(pre)')].map(each => each.id)")
        for name in ("ChannelMask", "ChannelMixer", "ColorspaceConversion", "DetailAlbedo", "LinearToOkLab", "LinearToSrgb",
                     "Luminance", "RgbToHsv", "SrgbToLinear"):
            self.assertNotIn(name, texts)
        def at(name, *places):
            image = self.browser.run(f"return document.querySelector('#{name} img')")
            self.browser.run("arguments[0].scrollIntoView()", image)
            picture = self.browser.picture(image)
            return [picture.at(*place)[:3] for place in places]
        # The left half is a red, a green and a blue; the right one has their luminances.
        (red, green, blue, *greys) = at("Luminance", (0.02, 0.3), (0.17, 0.3), (0.33, 0.3), (0.52, 0.3), (0.67, 0.3), (0.83, 0.3))
        for color, most in ((red, 0), (green, 1), (blue, 2)):
            self.assertEqual(max(range(3), key=lambda i: color[i]), most)
        for grey in greys:
            self.assertLess(max(grey) - min(grey), 6)
        self.assertGreater(sum(greys[1]), sum(greys[0]))
        self.assertGreater(sum(greys[0]), sum(greys[2]))
        # What a node keeps with its defaults it changes in the picture.
        for name in ("ChannelMask", "ChannelMixer", "ColorspaceConversion", "DetailAlbedo"):
            (red, green, *after) = at(name, (0.02, 0.3), (0.17, 0.3), (0.52, 0.3), (0.67, 0.3))
            self.assertGreater(max(abs(a - b) for a, b in zip(red + green, after[0] + after[1])), 20, name)

    def test_a_tile_has_the_names_and_the_first_sentence(self):
        text = self.browser.run("return document.querySelector('#Lerp figcaption').innerText")
        self.assertEqual(text.split("\n"), ["Lerp", "Mix", "Interpolates linearly between two values"])

    def test_a_search_on_the_page_hides_what_it_does_not_find(self):
        shown = self.browser.run("""
            const search = document.querySelector("input[type=search]");
            search.value = "voronoi";
            search.dispatchEvent(new Event("input"));
            return [[...document.querySelectorAll("figure")].filter(each => each.checkVisibility()).map(each => each.id),
                    [...document.querySelectorAll("h2")].filter(each => each.checkVisibility()).map(each => each.innerText)]""")
        self.assertIn("Voronoi", shown[0])
        self.assertNotIn("Lerp", shown[0])
        self.assertIn("Procedural/Noise", shown[1])
        self.assertNotIn("Logic", shown[1])

    def test_words_and_a_category_limit_the_page(self):
        for arguments, names in ((["--search", "round corners"], ["RoundedRectangle"]), (["-c", "logic"], ["And", "Xor"])):
            made = patina("nodes", *arguments, "--sheet", "some.html")
            self.assertEqual((made.returncode, made.stderr), (0, ""))
            found = patina("nodes", *arguments, "--json")
            self.browser.open("file://" + os.path.abspath("some.html"))
            shown = self.browser.run("return [...document.querySelectorAll('figure')].map(each => each.id)")
            self.assertEqual(sorted(shown), sorted(each["name"] for each in json.loads(found.stdout)))
            for name in names:
                self.assertIn(name, shown)

    def test_a_narrow_page_does_not_scroll_sideways(self):
        self.browser.call("POST", "/window/rect", {"width": 500, "height": 900})
        width, room = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.browser.call("POST", "/window/rect", {"width": 1200, "height": 900})
        self.assertLessEqual(width, room)

    def test_mistakes(self):
        for arguments, code, message in ((["--sheet", "page.png"], 2, "'page.png' is not an .html file"),
                                         (["--sheet", "a.html", "--json"], 2, "--sheet"),
                                         (["--sheet", "a.html", "-s", "elephant"], 1, "none has these words")):
            made = patina("nodes", *arguments)
            self.assertEqual(made.returncode, code, made.stderr)
            self.assertIn(message, made.stderr)
        self.assertIn("nodes --sheet nodes.html", patina("nodes", "--help").stdout)


if __name__ == "__main__":
    if (program := browser.missing()) is not None:
        print(f"skipped: there is no {program}; scripts/setup installs it")
        sys.exit(0)
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
