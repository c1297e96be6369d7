# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the checks of this directory have in common: how they are called, and how they are tested.

A check is a function that takes the directory of a package and yields a sentence for each thing
that is wrong.
"""
import pathlib
import sys
import tempfile


def said_about(check_package, files):
    """Returns what the check says about a package of these files, given as {path: text}."""
    with tempfile.TemporaryDirectory() as directory:
        for path, text in files.items():
            file = pathlib.Path(directory, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return list(check_package(pathlib.Path(directory)))


def unnoticed(check_package, cases):
    """Yields a sentence for each case (files, complaint) of which the check does not complain so;
    where the complaint is None it must be silent."""
    for files, complaint in cases:
        said = said_about(check_package, files)
        if (not any(complaint in line for line in said)) if complaint else said:
            yield f"a complaint '{complaint}' was expected, and there was: {said}"


def main(check_package, self_test):
    """Runs the check on the directory of the command line, or its test; returns the status."""
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        wrong = list(self_test())
    else:
        root = arguments[0] if arguments else pathlib.Path(__file__).resolve().parent.parent
        wrong = list(check_package(pathlib.Path(root)))
    for sentence in wrong:
        print(sentence)
    return 1 if wrong else 0
