#!/usr/bin/env python3
"""The licences that Patina prints and installs are those of the components in the bill of materials, and the README names
every package that scripts/setup installs, with its reason.

    licences_test.py SOURCE BUILD PATINA     SOURCE: the repository; BUILD: the build folder; PATINA: the program
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

CODE = {"CONTAINS", "STATIC_LINK"}
# Words that the terms of a licence have.
TERMS = {
    "MIT": "Permission is hereby granted, free of charge",
    "BSD-3-Clause": "Redistribution and use in source and binary forms",
    "Apache-2.0": "TERMS AND CONDITIONS FOR USE, REPRODUCTION, AND DISTRIBUTION",
    "BSL-1.0": "machine-executable object code",
    "GPL-3.0-or-later": "GNU General Public License",
    "Bison-exception-2.2": "special exception, you may create a larger work",
    "LicenseRef-NVIDIA": "NVIDIA grants you a personal, non-exclusive license",
}
source, build = map(pathlib.Path, sys.argv[1:3])
patina = sys.argv[3]
mistakes = []


def check(holds, mistake):
    if not holds:
        mistakes.append(mistake)


def run(*arguments):
    return subprocess.run([patina, *arguments], capture_output=True, text=True, check=False)


def upstream(version):
    """2:0.9.9.8+ds-6 is 0.9.9.8."""
    return re.sub(r"[+~].*$", "", re.sub(r"^\d+:|-[^-]*$", "", version))


def same_words(text):
    """Lines of copyright files start with a space or a star, and a line with a point alone is empty."""
    return " ".join(re.sub(r"^ \.? *$|[*#]", "", text, flags=re.MULTILINE).split())


with open(build / "package" / "patina.spdx.json", encoding="utf-8") as file:
    document = json.load(file)
packages = {package["SPDXID"]: package for package in document["packages"]}
inside = {}  # {component: products}
for row in document["relationships"]:
    if row["relationshipType"] in CODE and row["spdxElementId"] != "SPDXRef-Patina":
        inside.setdefault(packages[row["relatedSpdxElement"]]["name"], set()).add(row["spdxElementId"].removeprefix("SPDXRef-"))
by_name = {package["name"]: package for package in packages.values()}

# --- the command
listed = run("--licences")
check(listed.returncode == 0 and run("--licenses").stdout == listed.stdout, "patina --licences and --licenses differ, or fail")
check("is yours" in listed.stdout, "patina --licences does not say whose the shaders are")
check("CC0-1.0" in listed.stdout, "patina --licences does not say what the example textures are under")
code_part = listed.stdout.partition("shared libraries:")[0]
for name, products in inside.items():
    package = by_name[name]
    found = re.search(rf"^  {re.escape(name)} +(\S+) +(.+)\n +in (.*)$", code_part, re.MULTILINE)
    check(found, f"patina --licences does not list {name}")
    if found:
        version = upstream(package["versionInfo"]).replace("NOASSERTION", "unknown")
        check(found.group(1) == version, f"patina --licences has another version of {name}")
        check(found.group(2) == package["licenseDeclared"], f"patina --licences has another licence of {name}")
        check(set(found.group(3).split(", ")) == products, f"patina --licences has {name} in other programs")
    text = run("--licences", name).stdout
    for word in re.split(r" (?:AND|WITH) ", package["licenseDeclared"]):
        check(same_words(TERMS[word]) in same_words(text), f"patina --licences {name} lacks the terms of {word}")
    check(text.partition("\n\n")[2] in run("--licences", "all").stdout, f"patina --licences all lacks {name}")
wrong = run("--licences", "fmtt")
check(wrong.returncode == 2 and "did you mean 'fmt'" in wrong.stderr, "patina --licences of an unknown name has no advice")

# --- the texts are those of the packages, of the version that was built with
rows = (source / "package" / "components.cmake").read_text(encoding="utf-8")
for name in inside:
    text_of = re.search(rf"component\({re.escape(name)}\s[^)]*TEXT_OF (\S+)", rows).group(1)
    version = upstream(by_name[name]["versionInfo"])
    check(text_of == version, f"package/licences/{name}.txt is of version {text_of}, and this build is with {version}: copy the "
                              f"file /usr/share/doc/PACKAGE/copyright again, and write the version in package/components.cmake")
    for reference in by_name[name].get("externalRefs", ()):
        package = re.match(r"pkg:deb/[^/]*/([^@]*)@", reference["referenceLocator"]).group(1)
        theirs = pathlib.Path("/usr/share/doc", package, "copyright")
        if theirs.exists():  # some systems are installed without documentation
            ours = source / "package" / "licences" / f"{name}.txt"
            check(ours.read_bytes() == theirs.read_bytes(), f"{ours} differs from {theirs}")

# --- what is installed
for component, is_of in (("library", lambda product: product.startswith("lib")), ("programs", lambda product: not product.startswith("lib"))):
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "-D", f"CMAKE_INSTALL_PREFIX={prefix}", "-D", f"CMAKE_INSTALL_COMPONENT={component}", "-P",
                        build / "package" / "cmake_install.cmake"], check=True, capture_output=True)
        folder = pathlib.Path(prefix, "share", "doc", "patina")
        texts = {file.stem for file in (folder / "licences").iterdir()}
        wanted = {name for name, products in inside.items() if any(map(is_of, products))}
        check(texts == wanted, f"the component {component} has the licences {sorted(texts)}, and code of {sorted(wanted)}")
        for name in texts & wanted:
            text = (folder / "licences" / f"{name}.txt").read_text(encoding="utf-8")
            check(text in run("--licences", name).stdout, f"the text of {name} that is installed is not the one that is printed")
        licence = (folder / "LICENSE").read_text(encoding="utf-8")
        check((source / "LICENSE").read_text(encoding="utf-8") in licence, f"the LICENSE of {component} is not Patina's")
        for name in wanted:
            check(re.search(rf"^{name} ", licence, re.MULTILINE), f"the LICENSE of {component} does not name {name}")
        check((folder / "SECURITY.md").read_bytes() == (source / "SECURITY.md").read_bytes(), "SECURITY.md is not installed")
        sbom = pathlib.Path(prefix, "share", "patina", "patina.spdx.json")
        check(sbom.exists() and json.loads(sbom.read_text(encoding="utf-8")) == document, "the bill of materials is not installed")

# --- what is yours
licence = same_words((source / "LICENSE").read_text(encoding="utf-8"))
check("all of it without conditions" in licence, "the LICENSE does not say whose the shaders are")
zero = pathlib.Path("/usr/share/common-licenses/CC0-1.0")
if zero.exists():
    check((source / "examples/graphs/textures/LICENSE").read_bytes() == zero.read_bytes(), "the textures' LICENSE is not CC0-1.0")

# --- the README names what scripts/setup installs
setup = (source / "scripts" / "setup").read_text(encoding="utf-8")
lists = re.findall(r"packages\+?=\(\n?(.*?)\)", re.sub(r" #.*| +#.*", "", setup), re.DOTALL)
installed = {word for words in lists for word in words.split()}
check(len(installed) > 30, "no packages were found in scripts/setup")
for page in ("README.md", "README.zh.md"):
    rows = re.findall(r"^\| ([^|]*?) \|", (source / page).read_text(encoding="utf-8").partition("`scripts/setup`")[2], re.MULTILINE)
    rows = [row for row in rows if "`" in row]
    named = {word for row in rows for word in re.findall(r"`([^`]*)`", row)}
    check(not installed - named, f"{page}: the table of dependencies lacks {sorted(installed - named)}")
    check(not named - installed, f"{page}: scripts/setup does not install {sorted(named - installed)}")

if mistakes:
    sys.exit("\n".join(mistakes))
print(f"{len(inside)} components with code in Patina, {len(installed)} packages in the README: all is well")
