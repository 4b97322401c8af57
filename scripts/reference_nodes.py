"""The pages of nodes for scripts/reference: docs/nodes/README.md, and a page for each family of docs/nodes/families.json.

  page   the page's name, without .md
  title  its heading; text: what the nodes have in common
  from   which nodes it has: files of nodes/ ("lighting/fresnel"), and nodes ("FresnelF82") that stand elsewhere
  plots  what scripts/pictures draws of several nodes on the same axes
"""
import functools
import json
import re

from reference_text import (WRITTEN, Wrong, anchor, block, cell, code, end, enumerate_words, first_sentence, link,
                            number, one_line, plain, table)

FOLDER = "docs/nodes"
COMPARED = "Compared"
INTRODUCTION = """# Nodes

A page for each family of nodes. A node says what it computes, from which paper, and what must hold; `patina node NAME` shows
the same. `patina nodes --search "round corners"` finds a node by what it does.

## How formulas are written

`n` is the normal, `l` the direction to the light, `v` that to the viewer, `h` the half vector between them, `r` a mirrored
direction, `t` and `b` tangent and bitangent: all are unit vectors. `n.l` is the cosine of two of them; the input `ndotl` is
this number. For other vectors, `dot(a, b)` and `cross(a, b)` are written out. `v.xy` are components. A space multiplies: `2 pi` is two
times pi. `a^2` is a power, `exp` and `log` have the base e, `|v|` is the length of a vector, `lerp(a, b, t)` goes from a to b, and
`saturate` limits to 0 to 1. `alpha` is the roughness of microfacet models, the square of the roughness that an artist sets.

Each chapter ends with the node as a graph has it, with every input at its default, and with examples, which the tests check.

"""


def stem(node):
    """The file of a node as families.json names it: lighting/fresnel."""
    return node["file"].removeprefix("nodes/").removesuffix(".node.hlsl")


def family_of(node, families):
    by_name = [family for family in families if node["name"] in family["from"]]
    found = by_name or [family for family in families if stem(node) in family["from"]]
    if len(found) != 1:
        raise Wrong(f"{FOLDER}/families.json: {len(found)} families have the node {node['name']} of {stem(node)}; one must")
    return found[0]


@functools.cache
def text_of(path):
    return path.read_text(encoding="utf-8")


def place(root, node, order):
    """Where a node stands on its page: as families.json names it or its file, then as in the file."""
    named = order.index(node["name"] if node["name"] in order else stem(node))
    return named, re.search(rf"^\w+ {node['name']}\(", text_of(root / node["file"]), re.MULTILINE).start()


def read_families(root, nodes):
    """The families with their nodes, in order."""
    families = json.loads((root / FOLDER / "families.json").read_text(encoding="utf-8"))["families"]
    for family in families:
        family["nodes"] = []
    for node in nodes:
        family_of(node, families)["nodes"].append(node)
    for family in families:
        order = family["from"]
        unknown = [name for name in order if name not in [*map(stem, family["nodes"]), *(n["name"] for n in family["nodes"])]]
        if unknown:
            raise Wrong(f"{FOLDER}/families.json: {family['page']}: there is no file or node {unknown[0]}")
        family["nodes"].sort(key=lambda node: place(root, node, order))
    return families


def addresses(families):
    """The place of each node, from docs/nodes."""
    return {node["name"]: f"{family['page']}.md{anchor(node['name'])}" for family in families for node in family["nodes"]}


# --- a node

def facts(port, is_output):
    """0 to 1; in m; default 0.5"""
    found = []
    if "range" in port:
        found.append(" to ".join(number(limit) for limit in port["range"]))
    if "unit" in port:
        found.append("in " + port["unit"])
    if not is_output:
        found.append("default " + port["default"] if "default" in port else "needs a value")
    return "; ".join(found)


def meaning(port):
    """What a port is, and what its words are."""
    docs = port.get("valueDocs", [])
    words = [code(word) + (": " + cell(doc) if doc else "") for word, doc in zip(port.get("values", []), docs)]
    return "<br>".join(([cell(port["doc"])] if "doc" in port else []) + words)


def ports(node, key):
    heads = [key.removesuffix("s"), "type", "range" if key == "outputs" else "range and default", "what"]
    rows = [[code(port["name"]), cell(port["type"]), cell(facts(port, key == "outputs")), meaning(port)] for port in node[key]]
    if key == "outputs" and len(rows) == 1 and not rows[0][3]:
        name, kind, limits, _ = rows[0]
        return f"Output: {name}, {kind}{', ' + limits if limits else ''}.\n\n"
    return table(heads, rows)


def engine_forms(node, library, places):
    """The nodes that compute this one as an engine does."""
    names = [*node["also"], node["name"]]
    for engine in library["engines"]:
        found = [other["name"] for other in library["nodes"] if other["name"] in [name + engine["title"] for name in names]]
        if found:
            yield f"{engine['title']}'s formula: {link(found[0], places[found[0]])}"


def is_compared(node, family):
    """True if a plot shows the node together with others."""
    plots = family.get("plots", [])
    return node["name"] in [each if isinstance(each, str) else each["node"] for plot in plots for each in plot["nodes"]]


def remarks(node, family, library, places):
    """The lines below the formula: other names, related nodes, source, plot and file."""
    if node["also"]:
        yield "Also known as: " + plain(", ".join(node["also"]))
    yield from engine_forms(node, library, places)
    if "source" in node:
        yield "Source: " + plain(one_line(node["source"]))
    if is_compared(node, family):
        yield f"Plot: {link('compared with others', anchor(COMPARED))}"
    if node["file"] != main_file(family):
        yield "File: " + link(plain(node["file"]), "../../" + node["file"])


def drawn(root, node):
    """The plot and the picture of a node alone, if it has any."""
    for folder, ending, what in ("plots", "svg", "its value"), ("pictures", "png", "drawn"):
        path = f"{folder}/{node['name']}.{ending}"
        if (root / FOLDER / path).exists():
            yield f"![{node['name']}: {what}]({path})\n\n"


def chapter(root, node, family, library, places):
    below = [line + "." if not line.endswith((".", ")")) else line for line in remarks(node, family, library, places)]
    text = f"### {node['name']}\n\n{plain(node['doc'])}\n\n" + block(node.get("formula", ""))
    text += "  \n".join(below) + "\n\n" if below else ""
    text += ports(node, "inputs") + ports(node, "outputs") + "".join(drawn(root, node))
    return text + block(node["example"], "json") + block("\n".join(node.get("tests", [])), "hlsl")


# --- a family

def main_file(family):
    """The file that has most nodes of a family."""
    files = [node["file"] for node in family["nodes"]]
    return max(files, key=files.count)


def notes(plot):
    """What a reader must know of a plot of several nodes."""
    for each in plot["nodes"]:
        if not isinstance(each, str) and "set" in each:
            given = [code(f"{name} = {re.sub(r'[{}$]', '', text)}") for name, text in each["set"].items()]
            yield f"{each['node']} has {enumerate_words(given)}."
    if len(plot["nodes"]) > 2:
        yield "Where curves coincide, wide lines show below narrow ones."


def family_drawings(root, family):
    """What is drawn of several nodes: pictures in rows, and curves on the same axes."""
    if (root / FOLDER / f"pictures/{family['page']}.png").exists():
        yield f"![{family['title']}, drawn](pictures/{family['page']}.png)\n\n"
    for plot in family.get("plots", []):
        yield f"![{plot['title']}](plots/{plot['plot']}.svg)\n\n"
        about = " ".join(notes(plot))
        yield about + "\n\n" if about else ""


def family_page(root, family, library, places):
    file = main_file(family)
    is_all = all(node["file"] == file for node in family["nodes"])
    text = (f"{WRITTEN}# {family['title']}\n\n[All nodes, and how formulas are written](README.md)\n\n{family['text']}\n\n"
            f"The nodes are in {link(plain(file), '../../' + file)}{'' if is_all else ', unless the chapter says otherwise'}.\n\n")
    text += table(["node", "what it does"], [[link(node["name"], anchor(node["name"])), cell(first_sentence(node["doc"]))]
                                             for node in family["nodes"]])
    drawings = "".join(family_drawings(root, family))
    text += f"## {COMPARED}\n\n{drawings}" if drawings else ""
    # Links to this page are links to its headings.
    places = {name: address.removeprefix(family["page"] + ".md") for name, address in places.items()}
    return end(text + "## Nodes\n\n" + "".join(chapter(root, node, family, library, places) for node in family["nodes"]))


def index(families, places):
    rows = [[link(family["title"], family["page"] + ".md"), str(len(family["nodes"])), family["text"]] for family in families]
    text = WRITTEN + INTRODUCTION + "## Families\n\n" + table(["family", "nodes", "what they do"], rows)
    every = sorted((node for family in families for node in family["nodes"]), key=lambda node: node["name"].lower())
    rows = [[link(node["name"], places[node["name"]]), cell(first_sentence(node["doc"]))] for node in every]
    return end(text + "## All nodes\n\n" + table(["node", "what it does"], rows))


def node_pages(root, library):
    families = read_families(root, library["nodes"])
    places = addresses(families)
    library["places"] = places
    pages = {f"{FOLDER}/{family['page']}.md": family_page(root, family, library, places) for family in families}
    return pages | {f"{FOLDER}/README.md": index(families, places)}
