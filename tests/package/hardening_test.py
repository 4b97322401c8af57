#!/usr/bin/env python3
"""The programs and shared libraries that were built have the protections that package/hardening.cmake asks for.

    hardening_test.py BUILD HARDENED     BUILD: the build folder; HARDENED: 1 if the build asked for them
"""

import re
import sys

from built_files import Build, output_of


def mistakes(name, path):
    header = output_of("readelf", "--file-header", "--wide", path)
    segments = output_of("readelf", "--program-headers", "--wide", path)
    dynamic = output_of("readelf", "--dynamic", "--wide", path)
    symbols = set(re.findall(r" UND (\S+?)(?:@\S+)?(?: |$)", output_of("readelf", "--dyn-syms", "--wide", path), re.MULTILINE))
    if not re.search(r"Type:\s+DYN ", header):
        yield "its code lies at a fixed address (no PIE)"
    if not name.startswith("lib") and not re.search(r"\(FLAGS_1\).*\bPIE\b", dynamic):
        yield "it is not marked as a position-independent program"
    if "GNU_RELRO" not in segments:
        yield "the tables of the linker can be written (no RELRO)"
    if not re.search(r"BIND_NOW|\(FLAGS_1\).*\bNOW\b", dynamic):
        yield "functions are bound when they are called, so the tables of the linker stay writable (no BIND_NOW)"
    if not re.search(r"GNU_STACK( +0x\w+){5} RW ", segments):
        yield "its stack is executable"
    if re.search(r" LOAD( +0x\w+){5} RWE", segments):
        yield "a part of it can be written and executed"
    if "__stack_chk_fail" not in symbols:
        yield "no function guards its stack (no -fstack-protector-strong)"
    checked = {symbol for symbol in symbols if re.fullmatch(r"__\w+_chk", symbol)}
    if not checked and name != "libpatina-lighting":  # which copies only into memory whose size no compiler knows
        yield "no function of C checks what it writes (no _FORTIFY_SOURCE)"
    for found in re.findall(r"\((?:RPATH|RUNPATH|TEXTREL)\).*", dynamic):
        yield f"it has {found}: it would look for libraries in a folder of the machine that built it"


def main():
    if sys.argv[2] != "1":
        print("skipped: this build has no hardening flags (package/hardening.cmake)")
        return
    build = Build(sys.argv[1])
    if not build.products:
        sys.exit("nothing is built")
    found = [f"{name}: {mistake}" for name, path in build.products.items() for mistake in mistakes(name, path)]
    if found:
        sys.exit("\n".join(found))
    print(f"{', '.join(build.products)}: all is well")


main()
