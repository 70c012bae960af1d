#!/usr/bin/env python3
"""Prints the invocations that two versions answered differently, each with the first line that differs.
usage: differences.py LIST NEW_ANSWERS OLD_ANSWERS
An answer goes from ">>> invocation" to "<<< exit code". What LIST does not name is left out. Standard error says how
many invocations both versions answered."""
import sys


def records(path):
    """The invocations of a file and their answers, one after another."""
    name, lines = None, []
    with open(path, "rb") as answers:
        for line in answers:
            if line.startswith(b">>> "):
                name, lines = line[4:].rstrip(b"\n"), []
                continue
            lines.append(line)
            if name is not None and line.startswith(b"<<< exit"):
                yield name, b"".join(lines)
                name = None


def first_difference(old, new):
    """The number of the first line that differs, from 1, and its text in both."""
    old, new = old.splitlines(), new.splitlines()
    at = 0
    while at < min(len(old), len(new)) and old[at] == new[at]:
        at += 1
    shown = [lines[at].decode(errors="replace") if at < len(lines) else "(no more)" for lines in (old, new)]
    return at + 1, *shown


def main():
    with open(sys.argv[1], "rb") as names:
        wanted = {line.rstrip(b"\n") for line in names}
    answers = {name: answer for name, answer in records(sys.argv[2]) if name in wanted}
    compared = 0
    for name, old in records(sys.argv[3]):
        new = answers.get(name)
        if name not in wanted or new is None:
            continue
        compared += 1
        if old != new:
            line, was, now = first_difference(old, new)
            print(f"{name.decode(errors='replace')}\n  line {line}\n  old: {was}\n  new: {now}")
    print(compared, file=sys.stderr)


main()
