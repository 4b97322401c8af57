#!/usr/bin/env python3
"""The bill of materials has what SPDX 2.3 asks of it, and names what the linker and the compiler really read.

    sbom_test.py BUILD      BUILD: the build folder

What is linked is found without the list of components: by the link lines, the files that were made, and the headers that
Ninja noted for each object file. dpkg says which package they are of.
"""

import json
import os
import re
import shutil
import sys

from built_files import Build, needed, output_of, owners, source_packages

# Sections 6 to 11 of the specification of SPDX 2.3.
DOCUMENT = ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo")
PACKAGE = ("SPDXID", "name", "downloadLocation")
NAMED_LICENCES = {"Apache-2.0", "BSD-3-Clause", "BSL-1.0", "CC0-1.0", "EPL-1.0", "GPL-3.0-or-later", "LGPL-2.1-or-later", "MIT"}
EXCEPTIONS = {"Bison-exception-2.2", "GCC-exception-3.1"}
RELATIONSHIPS = {"DESCRIBES", "CONTAINS", "STATIC_LINK", "DYNAMIC_LINK"}
# The headers of the kernel, which those of the C library include: numbers and layouts, no code.
NO_CODE = {"linux"}


def licence_mistakes(expression, own):
    if expression in ("NOASSERTION", "NONE"):
        return
    for term in re.split(r" AND | OR ", expression.replace("(", "").replace(")", "")):
        name, _, exception = term.partition(" WITH ")
        if name not in NAMED_LICENCES | own:
            yield f"'{name}' is no licence of SPDX, and the file has no text of it"
        if exception and exception not in EXCEPTIONS:
            yield f"'{exception}' is no exception of SPDX"


def form_mistakes(document):
    for key in DOCUMENT:
        if not document.get(key):
            yield f"the document has no {key}"
    if document["spdxVersion"] != "SPDX-2.3" or document["dataLicense"] != "CC0-1.0" or document["SPDXID"] != "SPDXRef-DOCUMENT":
        yield "the document is not SPDX 2.3 under CC0-1.0"
    if not re.fullmatch(r"https://[^\s#]+", document["documentNamespace"]):
        yield f"the namespace '{document['documentNamespace']}' is no absolute URI"
    created = document["creationInfo"]
    if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", created["created"]):
        yield f"'{created['created']}' is no time of SPDX"
    if not created["creators"] or not all(re.match(r"(Tool|Person|Organization): .", who) for who in created["creators"]):
        yield f"the creators {created['creators']} are not of the form 'Tool: name'"
    own = set()
    for text in document["hasExtractedLicensingInfos"]:
        own.add(text["licenseId"])
        if not re.fullmatch(r"LicenseRef-[A-Za-z0-9.-]+", text["licenseId"]) or len(text["extractedText"]) < 200:
            yield f"{text['licenseId']} is no licence with a text"
    ids = [document["SPDXID"]]
    for package in document["packages"]:
        ids.append(package["SPDXID"])
        for key in PACKAGE:
            if not package.get(key):
                yield f"the package {package.get('name')} has no {key}"
        if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", package["SPDXID"]):
            yield f"'{package['SPDXID']}' is no name of SPDX"
        if package["filesAnalyzed"] is not False:
            yield f"{package['name']}: its files are not listed, so filesAnalyzed must be false"
        if not re.match(r"NOASSERTION$|(Organization|Person): .", package["supplier"]):
            yield f"{package['name']}: '{package['supplier']}' is no supplier"
        for key in ("licenseConcluded", "licenseDeclared"):
            yield from (f"{package['name']}: {mistake}" for mistake in licence_mistakes(package[key], own))
        for reference in package.get("externalRefs", ()):
            if reference["referenceCategory"] != "PACKAGE-MANAGER" or reference["referenceType"] != "purl":
                yield f"{package['name']}: a reference is no package URL"
            if not re.fullmatch(r"pkg:deb/[a-z0-9.-]+/[a-z0-9.+-]+@[A-Za-z0-9.%~-]+\?arch=\w+", reference["referenceLocator"]):
                yield f"{package['name']}: '{reference['referenceLocator']}' is no package URL"
    if len(set(ids)) != len(ids):
        yield "two elements have the same SPDXID"
    for row in document["relationships"]:
        if row["relationshipType"] not in RELATIONSHIPS or row["spdxElementId"] not in ids or row["relatedSpdxElement"] not in ids:
            yield f"the relationship {row} is between things that are not there"
    described = [row["relatedSpdxElement"] for row in document["relationships"] if row["relationshipType"] == "DESCRIBES"]
    if described != document["documentDescribes"]:
        yield f"the document describes {described}"


def used_packages(document, product):
    """{source package: relationships} of a product, as the bill says; and the names of what has no package."""
    packages = {package["SPDXID"]: package for package in document["packages"]}
    used, unknown = {}, set()
    for row in document["relationships"]:
        if row["spdxElementId"] != f"SPDXRef-{product}":
            continue
        package = packages[row["relatedSpdxElement"]]
        for reference in package.get("externalRefs", ()):
            name = re.match(r"pkg:deb/[^/]*/([^@]*)@", reference["referenceLocator"]).group(1)
            used.setdefault(source_packages([name])[name], set()).add(row["relationshipType"])
        if "externalRefs" not in package:
            unknown.add(package["name"])
    return used, unknown


def content_mistakes(document, build):
    """The bill against what was built."""
    for product, path in build.products.items():
        said, unknown = used_packages(document, product)
        if unknown - {"spirv-headers"}:
            yield f"{product}: dpkg knows no package of {', '.join(sorted(unknown))}"
        found = {}
        linked = build.linked(product)
        loaded = {output_of("gcc", f"-print-file-name={name}").strip() for name in needed(path)}
        for kind, paths in (("STATIC_LINK", {name for name in linked if name.endswith(".a")}),
                            ("DYNAMIC_LINK", {name for name in linked if ".so" in name} | {p for p in loaded if "/" in p}),
                            ("header", build.headers(product))):
            for file, package in owners({re.sub(r"^/lib(?=/)", "/usr/lib", name) for name in map(os.path.realpath, paths)}).items():
                found.setdefault(package, {}).setdefault(kind, file)
        for package, kinds in found.items():
            for kind, file in kinds.items():
                if package in NO_CODE and kind == "header":
                    continue
                if package not in said:
                    yield f"{product} uses {file} of {package}, which package/components.cmake does not name for it"
                elif kind != "header" and kind not in said[package]:
                    yield f"{product} reads {file}: package/components.cmake lacks {kind} of {package}"
        for package, kinds in said.items():
            if package not in found:
                yield f"{product} uses nothing of {package}, which package/components.cmake names for it"
                continue
            for kind in kinds - {"CONTAINS"} - set(found[package]):
                yield f"{product}: package/components.cmake has {kind} of {package}, and nothing is linked so"
            if "CONTAINS" in kinds and "header" not in found[package]:
                yield f"{product}: package/components.cmake says that headers of {package} are in it, and none is"


def main():
    build = Build(sys.argv[1])
    with open(build.folder / "package" / "patina.spdx.json", encoding="utf-8") as file:
        document = json.load(file)
    mistakes = list(form_mistakes(document))
    if not mistakes and not shutil.which("dpkg-query"):
        print("skipped: without dpkg nobody knows which package a file is of; the form of the bill is right")
        return
    if not mistakes:
        mistakes = list(content_mistakes(document, build))
    for mistake in mistakes:
        print(mistake)
    if mistakes:
        sys.exit(1)
    print(f"{len(document['packages'])} packages, {len(document['relationships'])} relationships; compared with "
          f"{', '.join(build.products)}: all is well")


main()
