"""Drawings of graphs: every node, port and link is there, and a link ends where its ports are. Usage: graph_test.py PATINA"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

PATINA = ""
SVG = "{http://www.w3.org/2000/svg}"

GRAPH = """{ "patina": 1, "workflow": "metallic-roughness",
  "properties": [ { "name": "_Wear", "type": "float", "default": 0.5 } ],
  "nodes": [
    { "id": "parts", "node": "Split", "in": { "value": [0.1, 0.2, 0.3, 0.4] } },
    { "id": "worn", "node": "Lerp", "in": { "from": "parts.r", "to": "parts.b", "t": "$_Wear" } },
    { "id": "less", "expr": "worn < 0.5 && parts.r > 0 ? 0.1 : 0.2" } ],
  "surface": { "baseColor": "worn", "roughness": "less" } }"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def graph(*arguments):
    return subprocess.run([PATINA, "graph", *arguments], capture_output=True, text=True, check=False)


class Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.chdir(folder.name)
        write("own.graph.json", GRAPH)

    def test_nodes_ports_and_links(self):
        self.assertEqual(graph("own.graph.json", "-o", "own.svg").returncode, 0)
        root = ElementTree.parse("own.svg").getroot()
        groups = root.iter(SVG + "g")
        kinds = {}
        for group in groups:
            kinds.setdefault(group.get("class"), []).append(group)
        boxes = {}
        for box in kinds["node"]:
            texts = [(each.text.strip(), float(each.get("y"))) for each in box.iter(SVG + "text")]
            boxes[box.find(SVG + "title").text] = (texts[0][0], texts)
        self.assertEqual(sorted(name for name, _ in boxes.values()), ["less", "parts", "surface", "worn"])
        words = {text for _, texts in boxes.values() for text, _ in texts}
        for word in ("Split", "Lerp", "float4", "= $_Wear", "roughness",
                     "= worn < 0.5 && parts.r > 0 ? 0.1 : 0.2"):
            self.assertIn(word, words)

        def port(line):
            """The box, and the port whose text is nearest to the height where the link meets it."""
            box, y = line
            name, texts = boxes[box]
            return name, {text for text, at in texts if abs(at - y) < 10}

        links = set()
        for edge in kinds["edge"]:
            ends = re.match(r"(n\d+):\w+->(n\d+):\w+", edge.find(SVG + "title").text)
            points = [float(each) for each in re.findall(r"-?[\d.]+", edge.find(SVG + "path").get("d"))]
            source, out = port((ends[1], points[1]))
            target, into = port((ends[2], points[-1]))
            links.add((source, next(iter(out & {"r", "g", "b", "a", "out"})), target,
                       next(iter(into & {"from", "to", "t", "expr", "baseColor", "roughness"}))))
        self.assertEqual(links, {("parts", "r", "worn", "from"), ("parts", "b", "worn", "to"), ("worn", "out", "less", "expr"),
                                 ("parts", "r", "less", "expr"), ("worn", "out", "surface", "baseColor"),
                                 ("less", "out", "surface", "roughness")})

    def test_types_and_defaults(self):
        def label(path, box):
            """The words of a box of a .dot file."""
            self.assertEqual(graph(path, "-o", "own.dot").returncode, 0)
            with open("own.dot", encoding="utf-8") as file:
                line = next(each for each in file if "<B>%s</B>" % box in each)
            return re.sub(r"\s*<[^>]*>\s*", " ", line).split()

        def types(words):
            return [each for each in words if re.fullmatch(r"(float|bool|int)[N1-4]?", each)]

        nodes = """{ "id": "cap", "node": "MatcapUV" },
            { "id": "mixed", "node": "Lerp", "in": { "from": [1, 0], "to": "cap", "t": 0.5 } },
            { "id": "sum", "expr": "mixed.x + mixed.y" }, { "id": "unread", "node": "Lerp" }"""
        write("typed.graph.json", '{ "patina": 1, "workflow": "unlit", "nodes": [ %s ], "surface": { "color": "sum" } }' %
              nodes.replace('"unread", "node": "Lerp"', '"unread", "node": "Lerp", "in": { "from": 0, "to": 1, "t": 0 }'))
        self.assertIn("@normalVS", label("typed.graph.json", "cap"))
        self.assertEqual(types(label("typed.graph.json", "mixed")), ["float2"] * 4)
        self.assertEqual(types(label("typed.graph.json", "sum")), ["float"])
        # Of a node that nothing reads, too.
        self.assertEqual(types(label("typed.graph.json", "unread")), ["float"] * 4)
        write("typed.subgraph.json", """{ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "amount", "type": "float" } ],
          "nodes": [ { "id": "twice", "expr": "2 * $amount * @normalWS" } ], "outputs": { "out": "twice" } }""")
        self.assertEqual(types(label("typed.subgraph.json", "twice")), ["float3"])
        write("typed.lighting.json", """{ "patina": 1, "kind": "lighting", "nodes": [
          { "id": "lit", "expr": "@light.radiance * 0.5" } ], "direct": "= lit * @surface.diffuseColor" }""")
        self.assertEqual(types(label("typed.lighting.json", "lit")), ["float3"])
        # A drawing of a graph whose types do not fit shows what the file says.
        write("wrong.graph.json", """{ "patina": 1, "workflow": "unlit", "nodes": [
          { "id": "sum", "expr": "float2(1, 2) + float3(1, 2, 3)" } ], "surface": { "color": "sum" } }""")
        self.assertEqual(types(label("wrong.graph.json", "sum")), [])

    def test_other_kinds_and_files(self):
        write("own.lighting.json", """{ "patina": 1, "kind": "lighting", "nodes": [ { "id": "ndotl", "node": "NdotL" } ],
          "direct": "= ndotl * @light.radiance" }""")
        self.assertEqual(graph("own.lighting.json").returncode, 0)
        with open("own.svg", encoding="utf-8") as file:
            self.assertIn("outputs", file.read())
        self.assertEqual(graph("own.graph.json", "-o", "own.dot").returncode, 0)
        with open("own.dot", encoding="utf-8") as file:
            self.assertIn("->", file.read())

    def test_mistakes(self):
        result = graph("own.graph.json", "-o", "own.png")
        self.assertEqual(result.returncode, 2)
        self.assertIn("is not an .svg file or a .dot file", result.stderr)
        write("bad.graph.json", GRAPH.replace("Split", "Splt"))
        result = graph("bad.graph.json", "-o", "bad.svg")
        self.assertEqual(result.returncode, 1)
        self.assertIn("bad.graph.json:4:31: error: there is no node 'Splt'", result.stdout + result.stderr)
        self.assertFalse(os.path.exists("bad.svg"))
        nodes = ",".join('{ "id": "n%d", "expr": "1" }' % i for i in range(1001))
        write("many.graph.json", '{ "patina": 1, "workflow": "unlit", "nodes": [%s], "surface": { "color": "n0" } }' % nodes)
        result = graph("many.graph.json", "-o", "many.svg")
        self.assertEqual(result.returncode, 1)
        self.assertIn("a drawing has at most 1000", result.stdout + result.stderr)
        result = graph("own.graph.json", "-o", "own.graph.json")
        self.assertEqual(result.returncode, 2)


if __name__ == "__main__":
    PATINA = os.path.abspath(sys.argv.pop(1))
    unittest.main()
