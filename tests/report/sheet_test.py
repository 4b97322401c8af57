"""Opens the page of `patina sheet` in a browser: each graph has its picture, its nodes with a picture in each, its
properties, costs and shaders; what is wrong is said; a search and buttons choose. Usage: sheet_test.py PATINA"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import browser

PATINA = ""

# Without light: what the pixels are follows from the transfer function of sRGB.
GREY_BYTES = (188, 188, 188)  # of 0.5: 255 (1.055 0.5^(1 / 2.4) - 0.055) = 187.5
RED_BYTES = (255, 0, 0)

GREY = """{ "patina": 1, "workflow": "unlit",
  "properties": [ { "name": "_Tint", "type": "color", "default": [1, 0, 0], "help": "Of <b>paint</b>" },
                  { "name": "_Amount", "type": "float", "default": 0.25, "range": [0, 2] },
                  { "name": "_Kind", "type": "enum", "values": ["Wet", "Dry"], "default": "Dry" },
                  { "name": "_Mask", "type": "texture2d", "usage": "data" } ],
  "nodes": [ { "id": "tint", "expr": "$_Tint.rgb" },
             { "id": "mask", "node": "SampleTexture2D", "in": { "texture": "$_Mask" } },
             { "id": "high", "expr": "3 + 9 * @uv0.x" }, { "id": "facing", "expr": "0 - @normalWS" },
             { "id": "bright", "expr": "float3(2, 0.5, 0)" },
             { "id": "mixed", "node": "Lerp", "in": { "from": 0.5, "to": "tint", "t": "= 0 * ($_Amount + mask.r + high + facing.x + bright.x) + ($_Kind == Dry ? 0 : 1)" } } ],
  "surface": { "color": "mixed" } }"""
SUBGRAPH = """{ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "a", "type": "float" } ],
  "nodes": [ { "id": "half", "expr": "$a * 0 + 0.5" } ], "outputs": { "out": "half" } }"""
LIGHTING = """{ "patina": 1, "kind": "lighting", "nodes": [ { "id": "ndotl", "node": "NdotL" } ],
  "direct": "= ndotl * @light.radiance * @surface.baseColor" }"""
SCENE = """{ "patina": 1, "kind": "scene", "camera": { "position": [0, 0, 4], "target": [0, 0, 0], "fov": 35 },
  "materials": [ { "name": "grey", "graph": "grey.graph.json" } ],
  "objects": [ { "id": "ball", "mesh": "sphere", "material": "grey" } ] }"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def patina(*arguments):
    return subprocess.run([PATINA, *arguments], capture_output=True, text=True, check=False)


class SheetPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)
        write("art/grey.graph.json", GREY)
        write("art/grey.scene.json", SCENE)
        write("art/parts/half.subgraph.json", SUBGRAPH)
        write("art/own.lighting.json", LIGHTING)
        write("art/<b>wrong.graph.json", GREY.replace("Lerp", "<i>Lrp"))
        write("art/.old/hidden.graph.json", GREY)
        patina("sheet", "art", "--size", "64", "--no-node-pictures")
        cls.without_pictures = os.path.getsize("index.html") if os.path.exists("index.html") else 0
        cls.result = patina("sheet", "art", "--size", "64", "--segments", "80", "--light", "directional direction=0,0,1")
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.open("file://" + os.path.abspath("index.html"))

    def test_a_wrong_graph_fails_the_command_and_the_page_is_there(self):
        self.assertEqual(self.result.returncode, 1, self.result.stderr)
        self.assertIn("art/<b>wrong.graph.json:10:", self.result.stderr)
        self.assertIn("there is no node '<i>Lrp'", self.result.stderr)
        self.assertIn("index.html", self.result.stdout)
        self.assertLess(self.without_pictures, os.path.getsize("index.html"))

    def test_every_file_has_a_card_of_its_kind(self):
        cards = self.browser.run("""
            return [...document.querySelectorAll("section.card[data-case]")].map(each => [each.id, each.dataset.case])""")
        self.assertEqual(cards, [["<b>wrong", "material"], ["grey (material)", "material"], ["grey (scene)", "scene"],
                                 ["own", "lighting graph"], ["parts/half", "sub-graph"]])
        wrong = self.browser.run("return document.getElementById('<b>wrong').innerText")
        self.assertIn("there is no node '<i>Lrp'", wrong)
        self.assertEqual(self.browser.run("return document.querySelectorAll('main b, main i').length"), 0)

    def test_values_above_1_and_below_0_have_a_range(self):
        card = self.browser.run("return document.getElementById('grey (material)').innerText")
        shown = re.search(r"Not 0 to 1, so numbers are in false colours: high 0 to (\S+), facing -1 to 1\n", card)
        self.assertTrue(shown, card)
        # 3 + 9 u, of the half of the ball that is seen: the u of its right edge is above a half, and below 1.
        self.assertGreater(float(shown[1]), 7.5)
        self.assertLess(float(shown[1]), 12)

    def picture(self, card, selector):
        return self.browser.picture(self.browser.run(
            "return document.getElementById(arguments[0]).querySelector(arguments[1])", card, selector))

    def test_pictures_show_the_graphs(self):
        for card in ("grey (material)", "grey (scene)", "parts/half"):
            self.assertEqual(self.picture(card, "img").at(0.5, 0.5), GREY_BYTES, card)
        lit = self.picture("own", "img").at(0.6, 0.4)
        self.assertGreater(min(lit), 40, "a ball in light")
        loaded = self.browser.run("""
            for (const each of document.images) each.loading = "eager";
            return Promise.all([...document.images].map(each => each.decode())).then(() => document.images.length)""")
        self.assertEqual(loaded, 8, "four pictures, each small in the overview and large in its card")
        asked = self.browser.run("return performance.getEntriesByType('resource').map(each => each.name)")
        self.assertEqual([each for each in asked if not each.startswith("data:")], [])
        self.assertEqual(self.browser.errors(), [])

    def test_each_node_has_its_picture_in_its_box(self):
        where = """
            const card = document.getElementById("grey (material)");
            return [...card.querySelectorAll(".drawing g.node")].map(node => {
                const image = node.querySelector("image"), box = node.getBoundingClientRect();
                const at = image?.getBoundingClientRect();
                return [node.querySelector("text").textContent.trim(), !!image && at.width > 60 && Math.abs(at.width - at.height) < 0.1 &&
                        at.left >= box.left && at.right <= box.right && at.top >= box.top && at.bottom <= box.bottom];
            })"""
        self.assertEqual(dict(self.browser.run(where)), {
            "tint": True, "mask": True, "high": True, "facing": True, "bright": True, "mixed": True, "surface": False})
        for name, color in {"tint": RED_BYTES, "mask": (255, 255, 255), "mixed": GREY_BYTES}.items():
            node = self.browser.run("""
                return [...document.getElementById("grey (material)").querySelectorAll(".drawing g.node")].find(node =>
                    node.querySelector("text").textContent.trim() === arguments[0]).querySelector("image")""", name)
            self.browser.run("arguments[0].scrollIntoView()", node)
            self.assertEqual(self.browser.picture(node).at(0.5, 0.5), color)
        ids = self.browser.run("return [...document.querySelectorAll('[id]')].map(each => each.id)")
        self.assertEqual(len(ids), len(set(ids)))

    def test_properties_costs_and_shaders(self):
        rows = self.browser.run("""
            return [...document.getElementById("grey (material)").querySelectorAll(".shown tr")].map(row =>
                [...row.children].map(each => each.innerText))""")
        self.assertIn(["_Tint", "color", "1, 0, 0, 1", "", "Of <b>paint</b>"], rows)
        self.assertIn(["_Amount", "float", "0.25", "0 to 2", ""], rows)
        self.assertIn(["_Kind", "enum", "Dry", "Wet, Dry", ""], rows)
        self.assertEqual([row for row in rows if row[0] == "_Mask"], [["_Mask", "texture2d", "white", "data", ""]])
        self.assertEqual(self.browser.run("""
            return getComputedStyle(document.querySelector(".swatch")).backgroundColor"""), "rgb(255, 0, 0)")
        made = patina("compile", "art/grey.graph.json", "-t", "glsl", "-o", "out")
        self.assertEqual(made.returncode, 0, made.stderr)
        texts = self.browser.run("""
            return [...document.getElementById("grey (material)").querySelectorAll("details details")].map(each =>
                [each.querySelector("summary").textContent.split(":")[0], each.querySelector("pre").textContent])""")
        for name, text in texts:
            with open(os.path.join("out", name), encoding="utf-8") as file:
                self.assertEqual(text, file.read())
        self.assertEqual(len(texts), 2)
        # The same figures as those of 'patina cost'.
        forward = json.loads(patina("cost", "art/grey.graph.json", "--json").stdout)["graphs"][0]["passes"][0]
        def shown(counts, *others):
            return [str(count) if count else "\u2013" for count in [*counts.values(), *others]]
        vertex, pixel = forward["vertex"], forward["fragment"]
        at = rows.index(["forward", "vertex", *shown(vertex["once"], vertex["varyings"], vertex["registers"], 0)])
        self.assertEqual(rows[at + 1], ["", "pixel", *shown(pixel["once"], pixel["varyings"], pixel["registers"],
                                                            forward["uniformBytes"])])
        self.assertNotEqual(rows[at + 2][1], "light", "no loop")
        for share in pixel["shares"]:
            self.assertIn([share.get("node", share["part"]), *shown(share["once"], share["perLight"]["instructions"])],
                          rows)
        lit = self.browser.run("""
            return [...document.getElementById("own").querySelectorAll(".shown tr")].map(row =>
                [...row.children].map(each => each.innerText))""")
        light = [row for row in lit if row[:2] == ["", "light"]]
        self.assertEqual(len(light), 1)
        self.assertGreater(int(light[0][2]), 5, "the loop over lights")

    def test_a_search_and_buttons_choose(self):
        shown = """
            return [...document.querySelectorAll("section.card[data-case]")].filter(each => !each.hidden).map(each => each.id)"""
        search = """
            const search = document.querySelector("input[type=search]");
            search.value = arguments[0];
            search.dispatchEvent(new Event("input"));"""
        for words, found in {"ndotl": ["own"], "_amount GREY": ["grey (material)"], "nothing": []}.items():
            self.browser.run(search, words)
            self.assertEqual(self.browser.run(shown), found)
        self.browser.run(search, "grey")
        self.browser.click(self.browser.find("button[data-state=scene]"))
        self.assertEqual(self.browser.run(shown), ["grey (scene)"])

    def test_a_narrow_page_does_not_scroll_sideways(self):
        self.browser.call("POST", "/window/rect", {"width": 500, "height": 900})
        width, room = self.browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        self.browser.call("POST", "/window/rect", {"width": 1200, "height": 900})
        self.assertLessEqual(width, room)

    def test_mistakes(self):
        os.makedirs("empty", exist_ok=True)
        for arguments, code, message in ((["empty"], 1, "there is no graph and no scene in 'empty'"),
                                         (["nowhere"], 1, "cannot read the folder 'nowhere'"),
                                         (["art", "-o", "page.png"], 2, "'page.png' is not an .html file")):
            made = patina("sheet", *arguments)
            self.assertEqual(made.returncode, code)
            self.assertIn(message, made.stderr)


if __name__ == "__main__":
    if (program := browser.missing()) is not None:
        print(f"skipped: there is no {program}; scripts/setup installs it")
        sys.exit(0)
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
