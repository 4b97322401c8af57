"""Compiles material graphs with Patina.

In MODULE.bazel (the prefix that Patina is installed to):

    bazel_dep(name = "patina")
    local_path_override(module_name = "patina", path = "/usr/local/share/patina/bazel")

In WORKSPACE, if the project has no modules:

    local_repository(name = "patina", path = "/usr/local/share/patina/bazel")

In a BUILD file:

    load("@patina//:patina.bzl", "patina_shaders")

    patina_shaders(
        name = "shaders",
        srcs = glob(["**/*.graph.json"]),
        data = glob(["**/*.subgraph.json", "**/*.png"]),
        options = ["-t", "glsl"],
    )
"""

def _place(file, label):
    """"metal/rust.graph.json" of the package that holds it gives "metal/rust"."""
    path = file.short_path
    if label.package and path.startswith(label.package + "/"):
        path = path[len(label.package) + 1:]
    for ending in [".graph.json", ".json"]:
        if path.endswith(ending):
            return path[:-len(ending)]
    return path

def _patina_shaders(ctx):
    options = [ctx.expand_location(option, ctx.attr.data) for option in ctx.attr.options]
    folders = []
    for graph in ctx.files.srcs:
        # Only Patina knows how many shaders a graph has: the output is a folder.
        folder = ctx.actions.declare_directory(ctx.label.name + "/" + _place(graph, ctx.label))
        ctx.actions.run(
            executable = ctx.executable._patina,
            arguments = ["compile", graph.path, "--output", folder.path, "--quiet"] + options,
            inputs = [graph] + ctx.files.data,
            outputs = [folder],
            mnemonic = "PatinaCompile",
            progress_message = "Compiling %s" % graph.short_path,
        )
        folders.append(folder)
    return [DefaultInfo(files = depset(folders), runfiles = ctx.runfiles(folders))]

patina_shaders = rule(
    implementation = _patina_shaders,
    doc = "Compiles each graph to a folder of shaders and their reflection, NAME/GRAPH/.",
    attrs = {
        "srcs": attr.label_list(
            doc = "Material graphs. Each is an action of its own.",
            allow_files = [".json"],
            mandatory = True,
            allow_empty = False,
        ),
        "data": attr.label_list(
            doc = "What the graphs read: sub-graphs, lighting graphs, nodes, passes, textures. If one of them " +
                  "changes, all graphs of this target are compiled again.",
            allow_files = True,
        ),
        "options": attr.string_list(
            doc = "Options of 'patina compile'; $(location mine.pass.hlsl) is the path of a file of data.",
        ),
        "_patina": attr.label(
            default = "//:patina",
            executable = True,
            allow_single_file = True,
            cfg = "exec",
        ),
    },
)
