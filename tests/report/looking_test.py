"""Pictures that compare: sweeps, lighting models and their options on the command line. Usage: looking_test.py PATINA"""
import os
import subprocess
import sys
import tempfile
import unittest

import browser

PATINA = ""
SMALL = ["--size", "32", "--samples", "1", "--via", "cpu"]

FLAT = """{ "patina": 1, "workflow": "unlit", "properties": [
  { "name": "_C", "type": "float", "default": 0.2 }, { "name": "_D", "type": "float", "default": 1 } ],
  "surface": { "color": "= float3($_C, $_C, $_C) * $_D" } }"""
LIT = """{ "patina": 1, "workflow": "metallic-roughness", %s
  "surface": { "baseColor": [0.6, 0.5, 0.4], "roughness": 0.4 } }"""
DOT = """{ "patina": 1, "workflow": "unlit", "nodes": [
  { "id": "dot", "expr": "distance(@uv0, float2(0.5, 0.5)) < 0.03 ? 100.0 : 0.2" } ], "surface": { "color": "dot" } }"""
OWN = """{ "patina": 1, "kind": "lighting", "direct": "= @surface.diffuseColor * @light.radiance" }"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def render(*arguments):
    return subprocess.run([PATINA, "render", *arguments, *SMALL], capture_output=True, text=True, check=False)


def picture(path):
    return browser.Picture(read(path))


def runs(image, y, least):
    """The reds of a row of pixels, each run of at least so many equal ones once."""
    row = image.rows[y][::image.channels]
    found, begin = [], 0
    for x in range(1, image.width + 1):
        if x < image.width and row[x] == row[begin]:
            continue
        if x - begin >= least:
            found.append(row[begin])
        begin = x
    return found


def without_paper(values, image):
    return [each for each in values if each != image.rows[0][0]]


class Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.chdir(folder.name)
        write("flat.graph.json", FLAT)
        write("lit.graph.json", LIT % "")

    def expect(self, code, text, *arguments):
        result = render(*arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn(text, result.stdout + result.stderr)

    def test_a_sweep_is_a_row(self):
        self.expect(0, "row.png", "flat.graph.json", "--sweep", "_C=0..1:3", "--background", "none", "-o", "row.png")
        image = picture("row.png")
        # 255 (1.055 0.5^(1 / 2.4) - 0.055) = 187.5
        self.assertEqual([each for each in runs(image, image.height - 20, 15) if each in (0, 188, 255)], [0, 188, 255])

    def test_two_sweeps_are_a_grid(self):
        self.expect(0, "", "flat.graph.json", "--sweep", "_D=0,1", "--sweep", "_C=0.5,1", "-o", "grid.png")
        image = picture("grid.png")
        rows = {tuple(each for each in runs(image, y, 15) if each in (0, 188, 255)) for y in range(image.height)}
        self.assertIn((0, 0), rows)
        self.assertIn((188, 255), rows)

    def test_a_lighting_model_takes_the_place_of_the_graphs(self):
        write("own.lighting.json", OWN)
        for word, lighting in (("lambert", '"lambert"'), ("own.lighting.json", '"./own.lighting.json"')):
            write("said.graph.json", LIT % f'"lighting": {lighting},')
            self.expect(0, "", "lit.graph.json", "--lighting", word, "-o", "option.png")
            self.expect(0, "", "said.graph.json", "-o", "said.png")
            self.expect(0, "", "lit.graph.json", "-o", "default.png")
            self.assertEqual(read("option.png"), read("said.png"))
            self.assertNotEqual(read("option.png"), read("default.png"))

    def test_options_of_a_lighting_model(self):
        write("said.graph.json", LIT % '"lighting": { "use": "blinn-phong", "in": { "_Normalization": "Classic" } },')
        self.expect(0, "", "said.graph.json", "-o", "said.png")
        model = ["lit.graph.json", "--lighting", "blinn-phong"]
        for option in ("-D", "--set"):
            self.expect(0, "", *model, option, "_Normalization=Classic", "-o", "option.png")
            self.assertEqual(read("option.png"), read("said.png"), option)
            self.expect(1, "did you mean 'Classic'?", *model, option, "_Normalization=Clasic")
        self.expect(0, "", *model, "-o", "default.png")
        self.assertNotEqual(read("default.png"), read("said.png"))
        self.expect(0, "", "said.graph.json", "-D", "_Normalization=Normalized", "-o", "changed.png")
        self.assertEqual(read("changed.png"), read("default.png"))
        self.expect(0, "", *model, "--sweep", "_Normalization=Normalized,Classic", "-o", "options.png")
        self.expect(1, "did you mean '_Normalization'?", *model, "-D", "_Normalisation=Classic")

    def test_all_models_that_fit(self):
        self.expect(0, "", "lit.graph.json", "--lighting", "all", "-o", "all.png")
        write("own.graph.json", LIT.replace('"roughness": 0.4', '"exponent": 20') % '"lighting": "blinn-phong",')
        result = render("own.graph.json", "--lighting", "all", "-o", "few.png")
        self.assertEqual(result.returncode, 0, result.stderr)
        # One reason, one remark, which is folded.
        self.assertLessEqual(max(len(each) for each in result.stderr.splitlines()), 100, result.stderr)
        remarks = result.stderr.replace("\n  ", " ").splitlines()
        lines = [each for each in remarks if " not fit: " in each]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("cl-pbr-specular, "), lines)
        self.assertTrue(lines[0].endswith(" do not fit: the workflow 'metallic-roughness' and the lighting model have no "
                                          "surface input 'exponent'"), lines)
        # All that is missing is said.
        write("two.graph.json", LIT.replace('"roughness": 0.4', '"clearcoat": 1, "sheenRoughness": 0.5') %
              '"lighting": "gltf",')
        two = render("two.graph.json", "--lighting", "all", "-o", "two.png")
        self.assertIn("have no surface input 'clearcoat', 'sheenRoughness'", two.stderr.replace("\n  ", " "))
        # These draw the metal, but without what makes it one.
        write("metal.graph.json", LIT.replace('"roughness"', '"metallic": 1, "roughness"') % "")
        metal = render("metal.graph.json", "--lighting", "all", "-o", "metal.png").stderr.replace("\n  ", " ")
        self.assertIn("half-lambert *, lambert * do not read 'roughness', which the graph sets", metal)
        self.assertIn("merl *, unlit * do not read 'baseColor', 'metallic', 'roughness', which the graph sets", metal)
        for model in ("gltf *", "phong *", "unity-brdf1 *", "disney-principled *"):
            self.assertNotIn(model, metal)
        few, every = picture("few.png"), picture("all.png")
        self.assertLess(few.width * few.height, every.width * every.height)

    def test_light_that_clips(self):
        # Everything is at 4: two stops less shows all. A bright dot of one in a thousand and more is a highlight.
        self.expect(0, "100.0 % of the pixels are brighter than white and clip: --exposure -2.00 shows all, and "
                    "so does --tonemap khronos-neutral",
                    "flat.graph.json", "--set", "_C=4", "--mesh", "plane", "--camera", "position=0,0,1 target=0,0,0",
                    "-o", "bright.png")
        write("dot.graph.json", DOT)
        self.expect(0, "clip: --tonemap khronos-neutral shows such highlights", "dot.graph.json", "--mesh", "plane",
                    "--camera", "position=0,0,1 target=0,0,0", "-o", "dot.png")
        # A curve that clips is not advised to take a curve.
        result = render("flat.graph.json", "--set", "_C=60", "--mesh", "plane", "--camera",
                        "position=0,0,1 target=0,0,0", "--tonemap", "agx", "-o", "agx.png")
        self.assertNotIn("--tonemap", result.stderr)

    def test_light_of_a_picture(self):
        write("white.graph.json", LIT.replace('[0.6, 0.5, 0.4], "roughness": 0.4', '[1, 1, 1]') % '"lighting": "lambert",')
        with open("even.hdr", "wb") as file:  # 8 everywhere: 128 / 256 times 2 to the power of 132 - 128
            file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + b"\x80\x80\x80\x84" * 128)
        lit = ("white.graph.json", "--env", "even.hdr")
        self.expect(0, "all light comes from a picture, whose exposure is -3.56, so that white surfaces stay below "
                    "white: --exposure 0 shows the light unchanged", *lit, "-o", "white.png")
        self.assertNotIn("clip", render(*lit, "-o", "white.png").stderr)
        # A dielectric reflects 0.04 at once, so 0.96 of the 8: -log2(7.68) is -2.94, rounded down.
        self.expect(0, "clip: --exposure -2.95", *lit, "--exposure", "0", "-o", "raw.png")
        # An EXR file has the light as it is.
        self.assertNotIn("exposure", render(*lit, "-o", "white.exr").stderr)

    def test_layers(self):
        self.expect(0, "flat.exr", "flat.graph.json", "--aov", "color", "-o", "flat.exr")
        self.assertIn(b"color.R", read("flat.exr"))
        self.expect(2, "only an EXR file has layers", "flat.graph.json", "--aov", "color", "-o", "flat.png")
        self.expect(2, "'color' is given twice", "flat.graph.json", "--aov", "color,color", "-o", "flat.exr")
        self.expect(2, "leave out --sweep", "flat.graph.json", "--aov", "color", "--sweep", "_C=0,1", "-o", "a.exr")
        os.remove("flat.exr")
        self.expect(1, "no node or input called 'colour'", "flat.graph.json", "--aov", "colour", "-o", "flat.exr")
        self.assertFalse(os.path.exists("flat.exr"))

    def test_values_of_each_light(self):
        # Facing the light, n.l is 1; the sphere's middle is seen from the front.
        lights = ["--light", "directional direction=0,0,1 intensity=1", "--light", "directional direction=0,1,0 intensity=1"]
        node = ["lit.graph.json", "--lighting", "lambert", "--node", "lighting/ndotl", *lights]
        middle = {}
        for name, light in (("sum", []), ("first", ["--of-light", "0"]), ("second", ["--of-light", "1"])):
            self.expect(0, "", *node, *light, "--camera", "position=0,0,4 target=0,0,0", "-o", name + ".png")
            middle[name] = picture(name + ".png").at(0.5, 0.5)[0]
        self.assertGreaterEqual(middle["sum"], middle["first"])
        self.assertGreater(middle["first"], 250)
        self.assertLess(middle["second"], 90)  # the pixel's middle is half a pixel off: n.l <= 0.06, 255 sRGB(0.06) = 70
        self.expect(1, "there is no light 2: the lights are 0 to 1", *node, "--of-light", "2")
        self.expect(2, "--of-light: needs --node", "lit.graph.json", "--of-light", "0")

    def test_mistakes(self):
        flat = ["flat.graph.json", "--sweep"]
        self.expect(2, "not of the form NAME=FROM..TO:COUNT or NAME=A,B,C", *flat, "_C")
        self.expect(2, "'0..1' is not of the form FROM..TO:COUNT", *flat, "_C=0..1")
        self.expect(2, "'_C' has a value already", *flat, "_C=0..1:2", "--set", "_C=1")
        self.expect(2, "'_C' is swept twice", *flat, "_C=0,1", "--sweep", "_C=0,1")
        self.expect(2, "at most two of --sweep", *flat, "_C=0,1", "--sweep", "_D=0,1", "--lighting", "all")
        self.expect(1, "did you mean '_C'?", *flat, "_c=0,1")
        self.expect(1, "401 pictures are too many", *flat, ",".join(["_C=0"] + ["0"] * 400))
        self.expect(1, "did you mean 'lambert'?", "lit.graph.json", "--lighting", "lamber")
        self.expect(0, "the workflow 'unlit' has no lighting", "flat.graph.json", "--lighting", "lambert")


if __name__ == "__main__":
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
