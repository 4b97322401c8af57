"""Markdown for scripts/reference: text that shows as it is, tables, links, and the ends of sentences."""

WRITTEN = "<!-- written by scripts/reference -->\n"
# A bar ends a cell of a table; the others are Markdown's own characters.
MARKS = "\\*_<>|"


class Wrong(Exception):
    """Something that the pages are made of is not as it must be."""


def plain(text):
    """Text as Markdown that shows the same. What stands between `backquotes` stays unchanged."""
    parts = text.split("`")
    return "`".join(part if number % 2 else "".join("\\" * (c in MARKS) + c for c in part)
                    for number, part in enumerate(parts))


def one_line(text):
    return text.replace("\n", " ")


def cell(text):
    return plain(one_line(text))


def code(text):
    """`text`; a bar ends a table's cell, also inside of code."""
    return "`" + one_line(text).replace("|", "\\|") + "`" if text else ""


def link(text, address):
    return f"[{text}]({address})"


def anchor(name):
    return "#" + name.lower()


def block(text, language=""):
    return f"```{language}\n{text}\n```\n\n" if text else ""


def table(heads, rows):
    """A table without the columns that are empty in every row; nothing if it has no rows."""
    if not rows:
        return ""
    shown = [column for column, _ in enumerate(heads) if any(row[column] for row in rows)]
    lines = [[heads[column] for column in shown], *[[row[column] for column in shown] for row in rows]]
    made = ["| " + " | ".join(line) + " |" for line in lines]
    made.insert(1, "|" + "---|" * len(shown))
    return "\n".join(made) + "\n\n"


def first_sentence(text):
    """On one line, without its full stop; that of "Rec. 709" does not end a sentence."""
    sentence = one_line(text.split("\n\n")[0])
    stop = sentence.find(". ")
    while stop >= 0 and sentence[stop + 2:stop + 3].isdigit():
        stop = sentence.find(". ", stop + 1)
    return sentence[:stop if stop >= 0 else None].removesuffix(".")


def number(value):
    """As a person writes it: 1 instead of 1.0."""
    return repr(value).removesuffix(".0")


def enumerate_words(words):
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def end(text):
    """A page ends with one empty line less than its last part."""
    return text.rstrip("\n") + "\n"
