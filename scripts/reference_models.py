"""The pages of lighting models for scripts/reference: docs/models/README.md, and the pages of docs/models/chapters.json.

  page    the page's name, without .md
  title   its heading; text: what its models have in common
  models  their names, in order
"""
import json

from reference_text import (WRITTEN, Wrong, anchor, block, cell, code, end, enumerate_words, first_sentence, link,
                            number, one_line, plain, table)

FOLDER = "docs/models"
INTRODUCTION = """# Lighting models

Each is a graph of [nodes](../nodes/README.md); `patina model NAME` shows the same. [The gallery](../gallery.md) has their
pictures side by side. The cost is the number of SPIR-V instructions of the optimised fragment shader,
[measured](../cost.md) for each pixel and for each light. The model's chapter names the shader.

`direct` is the radiance that one light adds, `indirect` that of the environment; both are linear. A light's `radiance` and the
ambient irradiance are E/pi, the radiance of a white Lambertian surface, so a BRDF is multiplied by pi. Angles are in radians,
directions are unit vectors in world space. Formulas are written as [those of nodes](../nodes/README.md#how-formulas-are-written).

"""


def facts(given):
    """0 to 1; default 0.5"""
    found = []
    if "range" in given:
        found.append(" to ".join(number(limit) for limit in given["range"]))
    if "values" in given:
        found.append(enumerate_words(given["values"]))
    if "default" in given:
        found.append("default " + given["default"])
    if given.get("variant"):
        found.append("known when the graph is compiled")
    return "; ".join(found)


def inputs(title, head, given):
    rows = [[code(each["name"]), cell(each["type"]), cell(facts(each)), cell(each.get("doc", ""))] for each in given]
    return f"**{title}**\n\n" + table([head, "type", "range and default", "what"], rows) if rows else ""


def equation(model):
    """The model's formula, and the outputs of its graph."""
    lines = [f"{name} {'' if value.startswith('=') else '= '}{value}" for name, value in model["outputs"].items()]
    return "\n\n".join(part for part in (model.get("formula", ""), "\n".join(lines)) if part)


def reads(model, semantics):
    rows = [[code("@" + name), semantics[name]["type"], cell(first_sentence(semantics[name].get("doc", "")))]
            for name in model.get("reads", [])]
    return "**What it reads**\n\n" + table(["semantic", "type", "what"], rows) if rows else ""


def graph(model, places):
    rows = []
    for node in model["nodes"]:
        given = ([node["expr"]] if "expr" in node else []) + [f"{port}: {value}" for port, value in node.get("in", {}).items()]
        name = node.get("node", "")
        rows.append([code(node["id"]), link(name, "../nodes/" + places[name]) if name in places else cell(name),
                     code("; ".join(given)), cell(node.get("doc", ""))])
    return "**Nodes**\n\n" + table(["id", "node", "what it is given", "remark"], rows) if rows else ""


def cost(model):
    found = model["cost"]
    once, light = found["once"], found["perLight"]
    text = f"Cost: {once['instructions']} SPIR-V instructions for each pixel, of them {once['transcendental']} transcendental"
    if light["instructions"]:
        text += f", and {light['instructions']} for each light, of them {light['transcendental']} transcendental"
    return (f"{text}. Texture reads: {once['textures'] + light['textures']}. Registers: {found['registers']}. This is the fragment "
            f"shader of the pass `{found['pass']}` in the workflow `{found['workflow']}`, with a property at every input, after "
            "`spirv-opt -O`.\n\n")


def remarks(model):
    if "use" in model:
        yield "When to use it: " + plain(one_line(model["use"]))
    if "source" in model:
        yield "Source: " + plain(one_line(model["source"]))
    yield "File: " + link(plain(model["file"]), "../../" + model["file"])


def chapter(root, model, semantics, places):
    name = model["name"]
    text = f"### {name}\n\n{plain(model['doc'])}\n\n" + "  \n".join(remarks(model)) + "\n\n" + block(equation(model))
    if (root / FOLDER / f"pictures/{name}.png").exists():
        text += f"![{name}: rendered](pictures/{name}.png)\n\n"
    text += block(f'"lighting": "{name}"', "json") + cost(model)
    text += inputs("Inputs of its own", "input", model.get("inputs", []))
    text += inputs("Properties", "property", model.get("properties", []))
    return text + reads(model, semantics) + graph(model, places)


def page(root, about, models, semantics, places):
    text = f"{WRITTEN}# {about['title']}\n\n[All lighting models, their units and what the cost means](README.md)\n\n{about['text']}\n\n"
    rows = [[link(name, anchor(name)), cell(first_sentence(models[name]["doc"]))] for name in about["models"]]
    text += table(["model", "what it is"], rows)
    return end(text + "".join(chapter(root, models[name], semantics, places) for name in about["models"]))


def index(chapters, models):
    text = WRITTEN + INTRODUCTION
    for about in chapters:
        rows = [[link(name, f"{about['page']}.md{anchor(name)}"), str(models[name]["cost"]["once"]["instructions"]),
                 str(models[name]["cost"]["perLight"]["instructions"]), cell(first_sentence(models[name]["doc"]))]
                for name in about["models"]]
        text += f"## {link(about['title'], about['page'] + '.md')}\n\n{about['text']}\n\n"
        text += table(["model", "per pixel", "per light", "what it is"], rows)
    return end(text)


def model_pages(root, library):
    chapters = json.loads((root / FOLDER / "chapters.json").read_text(encoding="utf-8"))["pages"]
    models = {model["name"]: model for model in library["models"]}
    listed = [name for about in chapters for name in about["models"]]
    if sorted(listed) != sorted(models):
        wrong = sorted(set(listed) ^ set(models)) or [name for name in listed if listed.count(name) > 1]
        raise Wrong(f"{FOLDER}/chapters.json must name each lighting model once; look at {wrong[0]}")
    semantics = {semantic["name"]: semantic for semantic in library["values"]["semantics"]}
    pages = {f"{FOLDER}/{about['page']}.md": page(root, about, models, semantics, library["places"]) for about in chapters}
    return pages | {f"{FOLDER}/README.md": index(chapters, models)}
