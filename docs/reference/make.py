#!/usr/bin/python3
"""Makes the reference of the public headers with Doxygen: docs/reference/make.py FOLDER

It writes FOLDER/html. It fails if a public declaration has no comment, and prints the header and the line.

The headers have plain comments. Doxygen reads copies of them in which they are Doxygen's. A comment above a declaration,
or behind it and on the lines that continue it, documents it; if it declares several names, each of them. The comment that
opens a header documents the file. What is indented after an empty line of a comment is code. Lines that begin with
"// ---", the tables of words and what only the library needs are left out. Everything else stays on its line.
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
HEADERS = HERE.parent.parent / "compiler/include/patina"

CODE = re.compile(r'(?:[^"/]|"(?:[^"\\]|\\.)*"|/(?!/))*')
# Several members of one type, each with its own initializer: "int width = 0, height = 0;"
NAME = r"\w+(?: = [^,;{}()]+|\{[^;]*?\})?"
SEVERAL = re.compile(rf"(\s+)((?:static )?(?:const )?[\w:]+(?:<[^;]*>)?) ({NAME}(?:, {NAME})+);\s*$")
SECRET = re.compile(r'template <>|private:|#(define|undef) (CHECK_COMPLAINT|COMPLAINT|PATINA_API)|#include "patina/complaints.def"')


def documented(code, comment, above):
    """The declarations of a line of code, each with the comment behind it, or the one above it."""
    several = SEVERAL.match(code)
    if not several or not (comment or above):
        return f"{code}///<{comment}" if comment else code
    indent, kind, names = several.groups()
    names = re.split(r", (?![^{]*\})", names)
    return indent + " ".join(f"{kind} {name}; /**<{comment or above} */" for name in names)


def shifted(comment):
    """A line of a comment, with code as far to the right as Markdown wants it."""
    return "  " + comment if comment.startswith("   ") else comment


def for_doxygen(lines):
    """The lines of a header with comments for Doxygen."""
    opening = lines.index("#pragma once")  # its line is for \\file, without which Doxygen ignores the header
    yield "/// \\file"
    yield "/// \\brief" + lines[0][2:]
    for line in lines[1:opening]:
        yield "///" + shifted(line[2:])
    column = None  # of a comment behind a declaration, which the next lines may continue
    above = ""     # the comment on the lines before
    until = None   # how what is left out ends
    for line in lines[opening + 1:]:
        if until is None and SECRET.match(line):
            until = "};" if line.startswith("private") else "});" if line.startswith("template") else ""
        if until is not None:
            ends = line.startswith(until) or not until
            yield line if ends and until == "};" else ""
            until = None if ends else until
            continue
        code = CODE.match(line).group()
        comment = line[len(code) + 2:]
        if not comment:
            column = None
        if comment.startswith((" ---", "/")):
            yield "" if comment.startswith(" ---") else line
        elif code.strip():
            column = len(code) if comment else None
            yield documented(code, comment, above)
        elif comment and column is not None and abs(len(code) - column) <= 1:
            yield f"{code}///<{comment}"
        elif comment or line.endswith("//"):
            above += comment
            yield f"{code}///{shifted(comment)}"
            continue
        else:
            yield line
        above = ""


def first_page(text):
    """The README, with links to headers as Doxygen's, and without links to pages that the reference does not have."""
    text = re.sub(r"\[`\w+\.h`\]\(\S+/(\w+\.h)\)", r"@ref \1", text)
    return re.sub(r"\[([^]]+)\]\(\.\.[^)]*\)", r"\1", text)


def main(folder):
    copies = folder / "include/patina"
    copies.mkdir(parents=True, exist_ok=True)
    for old in copies.iterdir():
        old.unlink()
    for header in HEADERS.glob("*.h"):
        lines = header.read_text(encoding="utf-8").split("\n")
        (copies / header.name).write_text("\n".join(for_doxygen(lines)), encoding="utf-8")
    (copies / "README.md").write_text(first_page((HERE / "README.md").read_text(encoding="utf-8")), encoding="utf-8")

    settings = (HERE / "Doxyfile").read_text(encoding="utf-8")
    version = re.search(r'PATINA_VERSION_STRING "(.*)"', (HEADERS / "version.h").read_text(encoding="utf-8")).group(1)
    run = subprocess.run(["doxygen", "-"], input=f"{settings}PROJECT_NUMBER = {version}\n", cwd=folder,
                         stderr=subprocess.PIPE, encoding="utf-8")
    for line in dict.fromkeys(run.stderr.splitlines()):  # Doxygen repeats what is in a namespace and in a file
        print(line.replace(str(copies), str(HEADERS)), file=sys.stderr)
    return run.returncode


sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
