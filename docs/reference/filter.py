#!/usr/bin/python3
"""Writes a header with its // comments as Doxygen's: docs/reference/filter.py HEADER

A comment above a declaration, or behind it and on the lines that continue it, documents it; if it declares several names,
each of them. The comment that opens a header documents the file; what is indented in it is code. Lines that begin with
"// ---", the tables of words and what only the library needs are left out.
"""
import re
import sys

CODE = re.compile(r'(?:[^"/]|"(?:[^"\\]|\\.)*"|/(?!/))*')
# Several members of one type, each with its own initializer: "int width = 0, height = 0;"
NAME = r"\w+(?: = [^,;{}()]+|\{[^;]*?\})?"
SEVERAL = re.compile(rf"(\s+)((?:static )?(?:const )?[\w:]+(?:<[^;]*>)?) ({NAME}(?:, {NAME})+);\s*$")
SECRET = re.compile(r"template <>|private:|#define (COMPLAINT|PATINA_API)")


def documented(code, comment, above):
    """The declarations of a line of code, each with the comment behind it, or the one above it."""
    several = SEVERAL.match(code)
    if not several or not (comment or above):
        return f"{code}///<{comment}" if comment else code
    indent, kind, names = several.groups()
    names = re.split(r", (?![^{]*\})", names)
    return indent + " ".join(f"{kind} {name}; /**<{comment or above} */" for name in names)


def lines_of(path):
    lines = open(path, encoding="utf-8").read().split("\n")
    opening = next((i for i, line in enumerate(lines) if not line.startswith("//")), len(lines))
    if opening:
        yield "/// \\file"
        yield "/// \\brief" + lines[0][2:]
        for line in lines[1:opening]:
            yield "///" + ("    " if line.startswith("//   ") else "") + line[2:]
    column = None  # of a comment behind a declaration, which the next lines may continue
    above = ""     # the comment on the lines before
    until = None   # how what is left out ends
    for line in lines[opening:]:
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
        elif comment:
            above += comment
            yield f"{code}///{comment}"
            continue
        else:
            yield line
        above = ""


print("\n".join(lines_of(sys.argv[1])))
