#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks how the files of the package hang together. Prints what is wrong, and nothing when all
is well.

  check_tree.py [DIRECTORY]    the package in DIRECTORY (default: the one this file belongs to)
  check_tree.py --self-test    each check can fail

Headers: no include cycle; a floor includes only floors beneath it; every public header is read by
the umbrella header and by something else that is compiled; every internal header is read by some
other header. All sources: licence line, include guard, length of lines and of headers.
"""
import re
import sys

import checks

# The floors of the package, each with those that it stands on directly. Sources of second-order
# data (Curves, Surfaces) and questions about it (Analysis) meet in the Waist only.
STANDS_ON = {
    "internal": [],
    "Number_types": ["internal"],
    "Bernstein": ["Number_types"],
    "Differentiation": ["Number_types"],
    "Waist": ["Differentiation"],
    "Curves": ["Waist"],
    "Surfaces": ["Curves"],
    "Constraints": ["Surfaces"],
    "Analysis": ["Waist"],
    "Traits": ["Analysis"],
    "Splines": ["Bernstein", "Curves"],
    "Contours": ["Bernstein", "Waist"],
    "Property_surfaces": ["Contours", "Splines", "Surfaces", "Analysis"],
    "Meshing": ["Property_surfaces"],
    "IO": ["Meshing"],
}
UMBRELLA = "CGAL/Shape_interrogation.h"
# Floors and headers that the umbrella header need not read, because they are slow to compile.
NOT_IN_UMBRELLA = {"Meshing", "IO", "Contours", "parse_expression.h", "isolate_roots.h",
                   "Trichotomy.h", "patch_contours.h", "regularity.h", "trichotomy_of_patch.h"}
READERS = ("test", "examples", "demo", "benchmark")
LONGEST_LINE = 100
LONGEST_HEADER = 300


def beneath(floor):
    """Returns the floor itself and all floors beneath it."""
    return {floor}.union(*(beneath(lower) for lower in STANDS_ON[floor]))


def floor_of(header):
    """Returns the floor of CGAL/Shape_interrogation/FLOOR/..., or an empty string."""
    parts = header.split("/")
    return parts[2] if len(parts) > 3 and parts[2] in STANDS_ON else ""


def name_of(header):
    return header.rpartition("/")[2]


def is_internal(header):
    return "/internal/" in header


def includes_of(path, own):
    """Returns those of the headers `own` that the file includes."""
    text = path.read_text(encoding="utf-8")
    return [name for name in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text, re.M)
            if name in own]


def reachable(start, graph):
    """Returns what is read with the header; itself among it only where it is on a cycle."""
    found, waiting = set(), list(graph.get(start, []))
    while waiting:
        header = waiting.pop()
        if header not in found:
            found.add(header)
            waiting += graph[header]
    return found


def check_cycles(graph):
    cyclic = {header for header in graph if header in reachable(header, graph)}
    while cyclic:
        first = min(cyclic)
        cycle = {other for other in reachable(first, graph) if first in reachable(other, graph)}
        yield "these headers include each other: " + ", ".join(sorted(cycle))
        cyclic -= cycle


def check_directions(graph):
    for header in sorted(graph.keys() - {UMBRELLA}):
        floor = floor_of(header)
        if not floor:
            yield f"{header} is on no floor (the floors: {', '.join(STANDS_ON)})"
            continue
        for other in graph[header]:
            if floor_of(other) not in beneath(floor):
                yield f"{header} includes {other}, which is not beneath {floor}"


def check_use(graph, read_outside):
    """`read_outside` are the headers that tests and programs include."""
    read_inside = {}
    for header, others in graph.items():
        for other in others:
            read_inside.setdefault(other, set()).add(header)
    in_umbrella = reachable(UMBRELLA, graph)
    for header in sorted(graph.keys() - {UMBRELLA}):
        readers = read_inside.get(header, set()) - {UMBRELLA}
        if is_internal(header):
            if not readers:
                yield f"{header} is internal and no header includes it"
            continue
        if not readers and header not in read_outside:
            yield f"{header} is included by no test, program or other header"
        if header not in in_umbrella and not NOT_IN_UMBRELLA & {floor_of(header), name_of(header)}:
            yield f"{header} is not read by {UMBRELLA}"


def check_form(path, name):
    lines = path.read_text(encoding="utf-8").splitlines()
    if not any("SPDX-License-Identifier: GPL-3.0-or-later" in line for line in lines[:10]):
        yield f"{name} has no licence line among its first ten"
    for number, line in enumerate(lines, 1):
        if len(line) > LONGEST_LINE:
            yield f"{name}:{number} has {len(line)} characters, more than {LONGEST_LINE}"
        if line != line.rstrip() or "\t" in line:
            yield f"{name}:{number} has a tab or ends in spaces"
    if name.startswith("include/"):
        guard = re.sub(r"[/.]", "_", name[len("include/"):]).upper()
        if f"#ifndef {guard}" not in lines or f"#define {guard}" not in lines:
            yield f"{name} has no include guard {guard}"
        if len(lines) > LONGEST_HEADER:
            yield f"{name} has {len(lines)} lines, more than {LONGEST_HEADER}"


def check_package(root):
    """Yields one sentence for each thing that is wrong."""
    include = root / "include"
    headers = {path.relative_to(include).as_posix(): path for path in include.rglob("*.h")}
    graph = {name: includes_of(path, headers) for name, path in headers.items()}
    outside = [path for folder in READERS for suffix in ("*.h", "*.cpp")
               for path in (root / folder).rglob(suffix)]
    read_outside = {name for path in outside for name in includes_of(path, headers)}
    yield from check_cycles(graph)
    yield from check_directions(graph)
    yield from check_use(graph, read_outside)
    for path in sorted([*headers.values(), *outside]):
        yield from check_form(path, path.relative_to(root).as_posix())


def self_test():
    """Yields what goes unnoticed when one thing is wrong in a small package."""
    top = "include/CGAL/Shape_interrogation"

    def header(path, *included, after=""):
        guard = re.sub(r"[/.]", "_", path[len("include/"):]).upper()
        reads = "".join(f"#include <{name}>\n" for name in included)
        return (f"// SPDX-License-Identifier: GPL-3.0-or-later\n#ifndef {guard}\n"
                f"#define {guard}\n{reads}{after}#endif\n")

    def package(**changes):
        paths = {"umbrella": f"{top}.h", "low": f"{top}/Waist/Low.h",
                 "high": f"{top}/Analysis/high.h", "inner": f"{top}/Waist/internal/inner.h"}
        name = {key: path[len("include/"):] for key, path in paths.items()}
        files = {paths["umbrella"]: header(paths["umbrella"], name["high"]),
                 paths["low"]: header(paths["low"], name["inner"]),
                 paths["high"]: header(paths["high"], name["low"]),
                 paths["inner"]: header(paths["inner"]),
                 "test/test_high.cpp": "// SPDX-License-Identifier: GPL-3.0-or-later\n"
                                       f"#include <{name['high']}>\n"}
        files.update({paths.get(key, key): text for key, text in changes.items()})
        return files

    low, high = f"{top}/Waist/Low.h", f"{top}/Analysis/high.h"
    source = f"{top}/Surfaces/S.h"
    return checks.unnoticed(check_package, [(package(**changes), said) for changes, said in [
        ({}, None),
        ({"low": header(low, "CGAL/Shape_interrogation/Waist/internal/inner.h",
                        "CGAL/Shape_interrogation/Analysis/high.h")}, "include each other"),
        ({"low": header(low, "CGAL/Shape_interrogation/Analysis/high.h")}, "not beneath Waist"),
        ({source: header(source, "CGAL/Shape_interrogation/Analysis/high.h")},
         "not beneath Surfaces"),
        ({f"{top}/Lost.h": header(f"{top}/Lost.h")}, "on no floor"),
        ({"low": header(low)}, "no header includes it"),
        ({"test/test_high.cpp": "// SPDX-License-Identifier: GPL-3.0-or-later\n"},
         "included by no test"),
        ({"umbrella": header(f"{top}.h")}, "not read by"),
        ({"test/test_low.cpp": "int i;\n"}, "no licence line"),
        ({"high": header(high, "CGAL/Shape_interrogation/Waist/Low.h").replace("HIGH", "LOW")},
         "no include guard"),
        ({"high": header(high, "CGAL/Shape_interrogation/Waist/Low.h", after="\n" * 300)},
         "lines, more than"),
        ({"high": header(high, "CGAL/Shape_interrogation/Waist/Low.h", after="/" * 101 + "\n")},
         "characters, more than"),
        ({"high": header(high, "CGAL/Shape_interrogation/Waist/Low.h", after="int i; \n")},
         "ends in spaces"),
    ]])


if __name__ == "__main__":
    sys.exit(checks.main(check_package, self_test))
