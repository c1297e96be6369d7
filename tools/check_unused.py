#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks for code that nothing uses. Prints what it finds, and nothing when all is well.

  check_unused.py [DIRECTORY]    the package in DIRECTORY (default: the one this file belongs to)
  check_unused.py --self-test    each check can fail

Every class, function, type and constant that is defined in include or demo at the level of
namespaces and classes is named somewhere besides. A function that a public header offers to users
(documented, outside of namespace internal, not private) is named in a test or an example. This is
about names, not about overloads. What overrides a function, or is in a specialisation, is used
through the name of another.
"""
import collections
import pathlib
import re
import sys

import checks

DEFINING, EXERCISING = ("include", "demo"), ("test", "examples")
ALL = DEFINING + EXERCISING + ("benchmark",)
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|\bR"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
                     r"|'(?:\\.|[^'\\\n])+'|\[\[.*?\]\]|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.']*|::|->|[=!<>]=|[^\s\w]")
NOT_DOCUMENTED = re.compile(r"^#ifndef DOXYGEN_RUNNING.*?^#endif", re.S | re.M)
# Words that may stand before a parenthesis and are no function.
NO_FUNCTION = {"decltype", "noexcept", "alignas", "explicit", "static_assert", "operator"}


def is_word(token):
    return token[0].isalpha() or token[0] == "_"


def behind(tokens, start, left, right):
    """Returns the position behind the bracket that closes the one at `start`."""
    depth = 0
    for i in range(start, len(tokens)):
        depth += (tokens[i] == left) - (tokens[i] == right)
        if depth == 0:
            return i + 1
    return len(tokens)


def declared(head):
    """Returns the words of a declaration without its `template <...>`."""
    while head[:1] == ["template"]:
        head = head[behind(head, 1, "<", ">"):]
    return [word for word in head if word not in ("inline", "static", "friend", "typename")]


def class_of(words):
    """Returns the name of the class, with "<" if it is a specialisation, or None."""
    if words[:1] and words[0] in ("class", "struct", "union", "enum") and "(" not in words:
        words = words[2:] if words[:2] == ["enum", "class"] else words[1:]
        return words[0] + ("<" if words[1:2] == ["<"] else "") if words else None
    return None


def function_of(words):
    """Returns the name of the function, or None."""
    i = 0
    while i < len(words) and words[i] not in ("(", "=", "operator", "~"):
        i = behind(words, i, "<", ">") if words[i] == "<" else i + 1
        if words[i:i + 1] == ["("] and words[i - 1] in NO_FUNCTION:
            i = behind(words, i, "(", ")")
    return words[i - 1] if 0 < i and words[i:i + 1] == ["("] and is_word(words[i - 1]) else None


def value_of(words):
    """Returns the name of the constant or of the other name of a type, or None."""
    if words[:1] == ["using"]:
        return words[1] if words[2:3] == ["="] else None
    if "constexpr" in words and "=" in words[1:]:
        return words[words.index("=") - 1]
    return None


class Definitions:
    """The names that one file defines, how often it declares them, and the public functions."""

    def __init__(self, tokens, is_public):
        self.declarations, self.public = collections.Counter(), set()
        self.defined = set()
        self.scan(tokens, is_public, "")

    def note(self, name, is_definition=True):
        self.declarations[name] += 1
        if is_definition:
            self.defined.add(name)

    def scan(self, tokens, is_public, owner):
        """Reads what is inside of a namespace or of the class `owner`."""
        i, head, visible = 0, [], is_public
        while i < len(tokens):
            token = tokens[i]
            if token == ":" and head[-1:] and head[-1] in ("public", "private", "protected"):
                visible, head = is_public and head[-1] == "public", []
            elif token == ";":
                self.statement(declared(head), visible, owner)
                head = []
            elif token == "{" and head.count("(") > head.count(")"): # a default argument
                i = behind(tokens, i, "{", "}") - 1
            elif token == "{":
                end = behind(tokens, i, "{", "}")
                self.block(declared(head), tokens[i + 1:end - 1], visible, owner)
                i, head = end - 1, []
            else:
                head.append(token)
            i += 1

    def statement(self, words, visible, owner):
        value, function = value_of(words), function_of(words)
        if value:
            self.note(value)
        elif class_of(words):
            self.note(class_of(words), False)
        elif function and function != owner:
            self.note(function, False)
            if visible:
                self.public.add(function)

    def block(self, words, inside, visible, owner):
        opened, value, function = class_of(words), value_of(words), function_of(words)
        if words[:1] == ["namespace"]:
            hidden = len(words) == 1 or "internal" in words
            self.scan(inside, visible and not hidden, "")
        elif opened and not opened.endswith("<"):
            self.note(opened)
            if words[0] != "enum":
                first = ["private", ":"] if words[0] == "class" else []
                self.scan(first + inside, visible, opened)
        elif value:
            self.note(value)
        elif function and function != owner and not {"override", ","} & {words[-1], words[0]}:
            self.note(function)
            if visible:
                self.public.add(function)


def tokens_of(text):
    return TOKEN.findall(NO_CODE.sub(" ", text))


def public_functions(path, text):
    """Returns the functions of a header that are for users, and documented."""
    if "internal" in path.parts:
        return set()
    return Definitions(tokens_of(NOT_DOCUMENTED.sub("", text)), True).public


def check_package(root):
    """Yields one sentence for each name that nothing uses."""
    files = {folder: [path for suffix in ("*.h", "*.cpp") for path in (root / folder).rglob(suffix)]
             for folder in ALL}
    texts = {path: path.read_text(encoding="utf-8") for folder in ALL for path in files[folder]}
    tokens = {path: tokens_of(text) for path, text in texts.items()}
    used = collections.Counter(token for path in tokens for token in tokens[path])
    exercised = {token for folder in EXERCISING for path in files[folder] for token in tokens[path]}
    defined, public = {"main": None}, {}
    for folder in DEFINING:
        for path in sorted(files[folder]):
            found = Definitions(tokens[path], False)
            used.subtract(found.declarations)
            place = path.relative_to(root).as_posix()
            defined.update((name, place) for name in found.defined if name not in defined)
            if folder == "include":
                public.update((name, place) for name in public_functions(path, texts[path])
                              if name not in public)
    unused = {name for name in defined.keys() - {"main"} if used[name] <= 0}
    for name in sorted(unused):
        yield f"{name} in {defined[name]} is used nowhere"
    for name in sorted(public.keys() - unused - exercised):
        yield f"{name} in {public[name]} is public, and named in no test or example"


def self_test():
    """Yields what goes unnoticed when one thing is wrong in a small package."""
    header, inner = "include/a.h", "include/internal/b.h"
    code = ("namespace CGAL {\ntemplate <class T = X<int>>\nclass A : public B\n{\npublic:\n"
            "  A() : m_x{1}, m_y(2) {}\n  int size() const { return m_x; }\nprivate:\n"
            "  int inner() { return \"unused() { text\"[0]; }\n};\n"
            "namespace internal {\ninline int hidden(int x = 0) { return x; }\n}\n"
            "enum class Kind { ONE };\nusing Number = int;\nconstexpr int limit = 3;\n"
            "int free_function(const A<int>& a = {});\n// comment() {}\n"
            "#define NOTHING_OF unused() {}\n}\n")
    use = "int i = A().size() + limit + free_function(Kind::ONE, Number());\n"
    more = "int A<int>::use() { return inner() + hidden() + use(); }\n"
    right = {header: code, inner: "inline int far(int) { return 1; }\n", "test/t.cpp": use,
             "demo/d.cpp": more + "int free_function(const A& a) { return far(2); }\n"}

    def changed(path, old, new):
        return {**right, path: right[path].replace(old, new)}

    return checks.unnoticed(check_package, [
        (right, None),
        (changed("demo/d.cpp", "far(2)", "2"), "far in include/internal/b.h is used nowhere"),
        (changed("demo/d.cpp", "inner()", "1"), "inner in include/a.h is used nowhere"),
        (changed("demo/d.cpp", "hidden()", "1"), "hidden in include/a.h is used nowhere"),
        (changed("demo/d.cpp", " + use()", ""), "use in demo/d.cpp is used nowhere"),
        (changed("test/t.cpp", "free_function", "f"),
         "free_function in demo/d.cpp is used nowhere"),
        (changed("test/t.cpp", "limit", "1"), "limit in include/a.h is used nowhere"),
        (changed("test/t.cpp", "size()", "b()"), "size in include/a.h is used nowhere"),
        (changed("test/t.cpp", "Number", "N"), "Number in include/a.h is used nowhere"),
        (changed("test/t.cpp", "Kind", "K"), "Kind in include/a.h is used nowhere"),
        ({**changed("test/t.cpp", "size()", "b()"), "benchmark/b.cpp": "size();\n"},
         "size in include/a.h is public, and named in no test"),
    ])


if __name__ == "__main__":
    sys.exit(checks.main(check_package, self_test))
