"""What the linker and the compiler read for Patina's programs and libraries, as Ninja's files know it.

    build = Build(folder)
    build.products                   {"patina": its path, "libpatina": its path, ...}: those that were built
    build.linked("patina")           libraries of the system on the link line of it, and of static libraries in it
    build.headers("patina")          headers of the system that its object files include
"""

import functools
import json
import os
import pathlib
import re
import subprocess

NAMES = {
    "patina": "patina",
    "patina-import": "patina-import",
    "patina-render": "patina-render",
    "libpatina": "package/libpatina.so.*.*.*",
    "libpatina-lighting": "package/libpatina-lighting.so.*.*.*",
}


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Build:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.products = {name: files[0] for name, pattern in NAMES.items() if (files := sorted(self.folder.glob(pattern)))}
        self.inputs, self.libraries = {}, {}
        outputs = []
        for line in (self.folder / "build.ninja").read_text(encoding="utf-8").replace("$\n", "").splitlines():
            if line.startswith("build "):
                # "build OUTPUTS: RULE INPUTS | IMPLICIT || ORDER"
                head, _, tail = line[6:].partition(": ")
                outputs = head.replace("|", " ").split()
                rule, *inputs = re.split(r" \|\| ", tail)[0].replace(" | ", " ").split()
                if "LINKER" in rule or "COMPILER" in rule:
                    self.inputs.update({output: inputs for output in outputs})
            elif line.startswith("  LINK_LIBRARIES = "):
                for output in outputs:
                    self.libraries[output] = line.partition(" = ")[2].split()

    def target(self, product):
        return self.products[product].relative_to(self.folder).as_posix()

    @functools.cache
    def objects(self, product):
        """The object files in a product, also those of Patina's own static libraries."""
        found, waiting = set(), [self.target(product)]
        while waiting:
            for path in self.inputs.get(waiting.pop(), ()):
                if path.endswith(".o"):
                    found.add(path)
                elif path.endswith(".a") and not path.startswith("/"):
                    waiting.append(path)
        return found

    @functools.cache
    def linked(self, product):
        paths = set()
        for word in self.libraries.get(self.target(product), ()):
            if word.startswith("-l"):
                word = output_of("gcc", f"-print-file-name=lib{word[2:]}.a").strip()
                if not word.startswith("/"):
                    continue  # a part of the C library without an archive of its own
                if word.endswith(".a") and not output_of("ar", "t", word).strip():
                    continue  # an empty archive: the C library holds what it once held
            if word.startswith("/") and not word.startswith(f"{self.folder}/"):
                paths.add(os.path.realpath(word))
        return paths

    @functools.cached_property
    def dependencies(self):
        """{object file: headers}"""
        made, current = {}, []
        for line in output_of("ninja", "-C", str(self.folder), "-t", "deps").splitlines():
            if line.startswith("    "):
                current.append(line.strip())
            elif ": #deps" in line:
                made[line.partition(": #deps")[0]] = current = []
        # An object file has the headers of the precompiled one, too.
        for item, precompiled in self.precompiled().items():
            made[item] = made.get(item, []) + made.get(precompiled, [])
        return made

    def precompiled(self):
        """{object file: precompiled header}"""
        made = {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            used = re.search(r" -include (\S+/cmake_pch\.hxx).* -o (\S+\.o) ", entry["command"])
            if used:
                made[used[2]] = os.path.relpath(used[1] + ".gch", self.folder)
        return made

    def headers(self, product):
        found = {header for item in self.objects(product) for header in self.dependencies[item]}
        return {os.path.normpath(path) for path in found if path.startswith(("/usr/", "/opt/"))}


def needed(path):
    """The shared libraries that a file names: ["libc.so.6"]."""
    return re.findall(r"\(NEEDED\).*\[(.*)\]", output_of("readelf", "--dynamic", "--wide", str(path)))


def owners(paths):
    """{path: source package}, by dpkg. The package of a path in /usr may be known by the path in /."""
    wanted = {name: path for path in paths for name in (path, path.removeprefix("/usr"))}
    run = subprocess.run(["dpkg-query", "--search", *wanted], capture_output=True, text=True, check=False)
    packages = {}
    for line in run.stdout.splitlines():
        package, _, path = line.rpartition(": ")
        if path in wanted:
            packages[wanted[path]] = package.split(",")[0].split(":")[0]
    sources = source_packages(set(packages.values()))
    return {path: sources[package] for path, package in packages.items()}


def source_packages(names):
    if not names:
        return {}
    lines = output_of("dpkg-query", "--show", "--showformat", "${Package} ${source:Package}\n", *sorted(names))
    return dict(line.split() for line in lines.splitlines())
