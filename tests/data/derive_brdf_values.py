#!/usr/bin/env python3
"""Derives brdf-values.json from the papers: every expected value from its inputs, in double, with nothing of Patina.

    derive_brdf_values.py          compares; exit status 1 if a value differs
    derive_brdf_values.py --write  puts the derived value where one differs

A row of the file says: term, inputs, expected (a number, a vector, or parts by name), group, rtolF32 (how far single
precision may be off, relative), note. The terms are functions in brdf/, one family a file.
"""

import argparse
import collections
import json
import pathlib
import sys
import time

from brdf import diffuse, disney, distribution, empirical, fresnel, harmonics  # noqa: F401, each files its terms
from brdf import image_based, layers, split_sum, unity, unity_brdf, visibility  # noqa: F401
from brdf.registry import TERMS

VALUES = pathlib.Path(__file__).with_name("brdf-values.json")


def read():
    return json.loads(VALUES.read_text(encoding="utf-8"))


def write(rows):
    lines = ",\n".join(json.dumps(row) for row in rows)
    VALUES.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


def numbers(value):
    """The numbers of a value by their place in it: {"": 1.5}, {"0": 1, "1": 2}, {"SHA.3": 0.2}."""
    if isinstance(value, dict):
        parts = value.items()
    elif isinstance(value, list):
        parts = enumerate(value)
    else:
        return {"": value}
    return {f"{key}.{place}".rstrip("."): n for key, part in parts for place, n in numbers(part).items()}


def difference(expected, derived, term):
    """The greatest difference as a multiple of what the term allows; 1 and less is agreement."""
    expected, derived = numbers(expected), numbers(derived)
    if expected.keys() != derived.keys():
        return float("inf")
    worst = 0.0
    for place, value in expected.items():
        allowed = term.relative * abs(value) + term.absolute
        apart = abs(value - derived[place])
        if not apart <= allowed:  # a NaN is no agreement
            worst = max(worst, apart / allowed if allowed > 0 and apart == apart else float("inf"))
        elif apart > 0:
            worst = max(worst, apart / allowed)
    return worst


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true", help="compare (the default)")
    arguments.add_argument("--write", action="store_true", help="put the derived value where one differs")
    options = arguments.parse_args()

    rows = read()
    start = time.monotonic()
    worst = collections.defaultdict(float)  # by what the term allows
    differing = 0
    for number, row in enumerate(rows):
        term = TERMS.get(row["term"])
        if term is None:
            sys.exit(f"row {number}: no function derives the term '{row['term']}'")
        derived = term.function(**row["inputs"])
        apart = difference(row["expected"], derived, term)
        worst[term.relative] = max(worst[term.relative], apart)
        if apart > 1:
            differing += 1
            print(f"row {number}: {row['term']} {json.dumps(row['inputs'])}: {row['expected']}, derived {derived}")
            row["expected"] = derived

    unused = sorted(TERMS.keys() - {row["term"] for row in rows})
    if unused:
        sys.exit(f"no row asks for {', '.join(unused)}")
    for relative, multiple in sorted(worst.items()):
        print(f"within {relative:g}: at worst {multiple * relative:.2g}")
    print(f"{len(rows)} rows of {len(TERMS)} terms, {differing} differ, {time.monotonic() - start:.1f} s")
    if options.write and differing:
        write(rows)
    elif differing:
        sys.exit(1)


if __name__ == "__main__":
    main()
