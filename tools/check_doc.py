#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the texts of the package agree with its files. Prints what does not, and nothing when
all is well.

  check_doc.py [DIRECTORY]     the package in DIRECTORY (default: the one this file belongs to)
  check_doc.py --self-test     each check can fail

Every name that a public header puts into a documentation group is on the classified reference pages
(doc/Shape_interrogation/PackageDescription.txt), and these name nothing else. Each example is in
examples.txt and in the README of the examples, and has at most 70 lines. The example of README.md
is that of 00_readme.cpp. The files that README.md points to and the figures of the manual exist.
"""
import re
import sys

import checks

DOC = "doc/Shape_interrogation"
EXAMPLES = "examples/Shape_interrogation"
LONGEST_EXAMPLE = 70
COMMENT = re.compile(r"/\*!.*?\*/|(?:^[ \t]*//[/!][^\n]*\n)+", re.S | re.M)
DECLARATION = re.compile(r"\b(?:class|struct|enum class|using)\s+(\w+)\b(?!::)")


def name_declared_in(code):
    """Returns the name that the code behind a documentation comment declares first."""
    code = re.sub(r"//[^\n]*|\[\[.*?\]\]", "", code).replace("decltype(auto)", "auto")
    while True:
        code = code.lstrip()
        if not code.startswith("template"):
            break
        depth = 0
        for end, character in enumerate(code):
            depth += (character == "<") - (character == ">")
            if character == ">" and depth == 0:
                break
        code = code[end + 1:]
    head = re.split(r"[;{=(]", code, maxsplit=1)[0]
    if head.startswith("#"):
        return None
    declared = DECLARATION.match(head)
    if declared:
        return declared.group(1)
    words = re.findall(r"\w+", head)
    return words[-1] if words else None


def names_documented_in(text):
    """Returns the names that a header puts into documentation groups."""
    names, comments = [], list(COMMENT.finditer(text))
    for comment in comments:
        if "\\ingroup" not in comment.group():
            continue
        code = text[comment.end():]
        if re.search(r"[@\\]\{\s*(\*/)?\s*$", comment.group()):
            group = code[:re.search(r"///?\s*[@\\]\}", code).start()]
            names += re.findall(r"^(?:inline|template|struct|class)[^;{(]*?(\w+)\s*[({]", group,
                                re.M)
            continue
        name = name_declared_in(code)
        if name:
            names.append(name)
    return names


def check_reference(root):
    headers = [path for path in (root / "include").rglob("*.h") if "internal" not in path.parts]
    concepts = sorted((root / DOC / "Concepts").glob("*.h"))
    public = {name for path in headers for name in names_documented_in(path.read_text("utf-8"))}
    public |= {path.stem for path in concepts}
    pages = (root / DOC / "PackageDescription.txt").read_text("utf-8")
    lists = pages[pages.find("\\cgalClassifedRefPages"):]
    listed = set(re.findall(r"`(?:CGAL::)?(?:Shape_interrogation::)?(\w+)", lists))
    for name in sorted(public - listed):
        yield f"{name} is not on the classified reference pages"
    for name in sorted(listed - public):
        yield f"{name} is on the classified reference pages, and documented nowhere"


def check_examples(root):
    listed = (root / DOC / "examples.txt").read_text("utf-8")
    described = (root / EXAMPLES / "README").read_text("utf-8")
    for path in sorted((root / EXAMPLES).glob("*.cpp")):
        if f"\\example Shape_interrogation/{path.name}" not in listed:
            yield f"{path.name} is not in examples.txt"
        if path.name not in described:
            yield f"{path.name} is not in the README of the examples"
        lines = path.read_text("utf-8").count("\n")
        if lines > LONGEST_EXAMPLE:
            yield f"{path.name} has {lines} lines, more than {LONGEST_EXAMPLE}"
    for name in re.findall(r"\w+\.cpp", listed + described):
        if not (root / EXAMPLES / name).exists():
            yield f"there is no example {name}"


def check_readme(root):
    readme = (root / "README.md").read_text("utf-8")
    blocks = re.findall(r"```cpp\n(.*?)```", readme, re.S)
    source = (root / EXAMPLES / "00_readme.cpp").read_text("utf-8")
    if [source[source.find("#include"):]] != blocks:
        yield "the C++ example of README.md is not that of 00_readme.cpp"
    for target in re.findall(r"\]\(([^)#:]+)\)", re.sub(r"```.*?```", "", readme, flags=re.S)):
        if not (root / target).exists():
            yield f"README.md points to {target}, which does not exist"


def check_figures(root):
    manual = (root / DOC / "Shape_interrogation.txt").read_text("utf-8")
    pictures = set(re.findall(r"\\cgalFigureBegin\{\w+,([\w.]+)\}", manual))
    for name in sorted(pictures):
        if not (root / DOC / "fig" / name).exists():
            yield f"the manual shows {name}, which is not in fig"
    for path in sorted((root / DOC / "fig").glob("*")):
        if path.name not in pictures:
            yield f"{path.name} is in fig, and not in the manual"


def check_package(root):
    """Yields one sentence for each thing that is wrong."""
    yield from check_reference(root)
    yield from check_examples(root)
    yield from check_readme(root)
    yield from check_figures(root)


def self_test():
    """Yields what goes unnoticed when one thing is wrong in a small package."""
    header, readme = "include/CGAL/Shape_interrogation/Waist/a.h", "README.md"
    example, manual = f"{EXAMPLES}/00_readme.cpp", f"{DOC}/Shape_interrogation.txt"
    right = {
        header: "/*!\n * \\ingroup G\n * \\brief is.\n */\ntemplate <class T, class U = X<T>>\n"
                "class A_3\n{};\n//! \\ingroup G\n//! \\brief does.\ndecltype(auto) b(int x);\n"
                "/// \\ingroup G\n/// @{\ninline int c(int x) { return x; }\n/// @}\n",
        f"{DOC}/PackageDescription.txt":
            "\\cgalClassifedRefPages\n- `CGAL::A_3`\n- `CGAL::b()`, `CGAL::c()`\n- `Concept_3`\n",
        f"{DOC}/Concepts/Concept_3.h": "class Concept_3 {};\n",
        f"{DOC}/examples.txt": "\\example Shape_interrogation/00_readme.cpp\n",
        f"{DOC}/fig/picture.png": "", manual: "\\cgalFigureBegin{f,picture.png}\n",
        f"{EXAMPLES}/README": "00_readme.cpp is the first.\n",
        example: "// Comment.\n#include <a>\n",
        readme: "[manual](doc)\n```cpp\n#include <a>\n```\n",
    }

    return checks.unnoticed(check_package, [({**right, **changes}, said) for changes, said in [
        ({}, None),
        ({header: right[header].replace("A_3", "D_3")}, "D_3 is not on"),
        ({header: right[header].replace(" b(", " d(")}, "d is not on"),
        ({header: right[header].replace(" c(", " d(")}, "c is on the classified"),
        ({f"{DOC}/Concepts/Other_3.h": ""}, "Other_3 is not on"),
        ({f"{DOC}/examples.txt": ""}, "not in examples.txt"),
        ({f"{EXAMPLES}/README": ""}, "not in the README of the examples"),
        ({f"{EXAMPLES}/README": "00_readme.cpp and 99.cpp\n"}, "no example 99.cpp"),
        ({example: right[example] + "\n" * 70}, "has 72 lines"),
        ({readme: right[readme].replace("<a>", "<b>")}, "is not that of 00_readme.cpp"),
        ({readme: right[readme].replace("(doc)", "(nowhere)")}, "points to nowhere"),
        ({manual: "\\cgalFigureBegin{f,other.png}\n"}, "shows other.png"),
        ({manual: ""}, "not in the manual"),
    ]])


if __name__ == "__main__":
    sys.exit(checks.main(check_package, self_test))
