#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles a piece of code with the flags of a user's program, and judges what happened.

  compile_check.py header COMMANDS HEADER   the header compiles alone, and when it is read twice
  compile_check.py fail COMMANDS FILE       the file does not compile, and the compiler says the
                                            sentence of its first line, "// expect: sentence";
                                            with -DCONTROL, the corrected variant, it compiles
  compile_check.py self-test COMMANDS       each of these judgements can be a failure

COMMANDS is a compile_commands.json that has the flags of user.cpp, which lies beside this file.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile


def user_command(commands):
    """Returns the compiler and the flags of user.cpp, without what is read and written."""
    with open(commands, encoding="utf-8") as stream:
        entries = json.load(stream)
    words = next(shlex.split(entry["command"]) for entry in entries
                 if entry["file"].endswith("/compile_check/user.cpp"))
    words = words[:words.index("-o")] if "-o" in words else words[:-2]
    return words + ["-fsyntax-only", "-x", "c++"]


def compile_text(command, text, *flags):
    """Returns whether the text compiles, and what the compiler says."""
    environment = dict(os.environ, LC_ALL="C")
    done = subprocess.run([*command, *flags, "-"], input=text, text=True, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode == 0, done.stdout


def check_header(command, header):
    """Returns what is wrong with the header, or an empty string."""
    compiles, said = compile_text(command, f"#include <{header}>\n" * 2)
    if not compiles:
        return f"<{header}> does not compile alone:\n{said}"
    return f"<{header}> gives a warning when it is compiled alone:\n{said}" if said else ""


def check_fail(command, text):
    """Returns what is wrong with a case that must not compile, or an empty string."""
    expected = re.match(r"// expect: (.*\S)", text)
    if not expected:
        return "The first line is to be '// expect: ' and a part of the compiler's message."
    compiles, said = compile_text(command, text)
    if compiles:
        return "It compiles, and must not."
    # A long message may be broken, and is quoted in a way that depends on the compiler.
    if expected[1] not in " ".join(said.split()):
        return f"It does not compile, but nowhere it is said '{expected[1]}':\n{said}"
    compiles, said = compile_text(command, text, "-DCONTROL")
    return "" if compiles else f"The corrected variant does not compile either:\n{said}"


def self_test(command):
    """Returns which judgement does not hold, or an empty string."""
    case = ("// expect: numbers only\ntemplate <class T> void f(T)\n"
            "{ static_assert(sizeof(T) == 1, \"numbers only\"); }\n"
            "#ifdef CONTROL\nvoid g() { f('a'); }\n#else\nvoid g() { f(1.0); }\n#endif\n")
    judgements = [
        (check_fail(command, case), None),
        (check_fail(command, case.replace("1.0", "'b'")), "It compiles"),
        (check_fail(command, case.replace("expect: numbers", "expect: letters")), "nowhere"),
        (check_fail(command, case.replace("'a'", "2.0")), "corrected variant"),
        (check_fail(command, case[3:]), "first line"),
    ]
    with tempfile.TemporaryDirectory() as directory:
        for name, text, complaint in (("good.h", "#pragma once\nstruct A {};\n", None),
                                      ("twice.h", "struct A {};\n", "not compile alone"),
                                      ("alone.h", "#pragma once\nB f();\n", "not compile alone")):
            with open(os.path.join(directory, name), "w", encoding="utf-8") as stream:
                stream.write(text)
            judgements.append((check_header(command + ["-I", directory], name), complaint))
    for number, (said, complaint) in enumerate(judgements):
        if (complaint not in said) if complaint else said:
            return f"Judgement {number} was to be '{complaint}', and was: {said}"
    return ""


def main():
    kind, commands, *what = sys.argv[1:]
    command = user_command(commands)
    if kind == "header":
        wrong = check_header(command, *what)
    elif kind == "fail":
        with open(what[0], encoding="utf-8") as stream:
            text = stream.read()
        directory = os.path.dirname(os.path.abspath(what[0]))
        wrong = check_fail(command + ["-I", directory], text)
    else:
        wrong = self_test(command)
    sys.exit(wrong or 0)


if __name__ == "__main__":
    main()
