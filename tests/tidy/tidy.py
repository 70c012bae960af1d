#!/usr/bin/env python3
"""The findings of clang-tidy in src/ and ui/.

    tidy.py checks   COMPILE_COMMANDS FOLDER      everything but the analyzer, many sources at a time
    tidy.py analyzer COMPILE_COMMANDS [SECONDS]   the path-sensitive analyzer, file by file

COMPILE_COMMANDS is a compile_commands.json with an entry for each source; .clang-tidy is in the
current folder. FOLDER receives the files that each include many sources: checking the headers of the
standard library takes ten times as long as checking ours, so they are checked only a few times.

Results without findings are remembered in $XDG_CACHE_HOME/rasterwalk-tidy, by a hash of everything
they depend on. With SECONDS the analyzer begins no further file after that time, and says how many
are left; the files changed last come first.

Exit codes: 0 in order, 1 something was found, 2 wrong usage, 77 this version of clang-tidy is not used.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

VERSION = "14"  # other versions find different things, some of them false
NOT_ASKED = 77
UNITS = 6  # of sources checked as one, more if names clash; some checks take ever longer in larger ones
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
TYPE_NAME = re.compile(r"(?:template <[^>]*> )?(?:struct|class|union|enum class|enum|using) (\w+)")
OTHER_NAME = re.compile(r"[\w:<>,&*\[\] ]*?[ &*](\w+(?:(?=\[| =|;|\{)|\(.*))")


def find_tool():
    """The path of clang-tidy, and its version in full; None if it is a different version."""
    for name in (f"clang-tidy-{VERSION}", "clang-tidy"):
        path = shutil.which(name)
        if path:
            said = subprocess.run([path, "--version"], capture_output=True, text=True).stdout
            if re.search(rf"version {VERSION}\.", said):
                return path, said
    return None


def read_commands(path):
    """The compiler's arguments for each source of src/ and ui/, without input and output."""
    commands = {}
    for entry in json.loads(pathlib.Path(path).read_text()):
        source = pathlib.Path(os.path.relpath(entry["file"]))
        if source.parts[0] not in ("src", "ui"):
            continue
        # One header, compiled for each level of instructions: the checks misread vectors of lanes.
        if source.name.startswith("fast_loops_"):
            continue
        words = shlex.split(entry["command"])
        compiler = next(i for i, word in enumerate(words) if re.search(r"(\+\+|cc|clang)(-\d+)?$", word))
        words = words[compiler:]
        output = words.index("-o")
        del words[output:output + 2]
        del words[words.index("-c"):]
        commands[source] = words
    return commands


def ask(tool, checks, source, command):
    """What clang-tidy says about a source, and whether it is clean."""
    run = subprocess.run([tool, "--quiet", f"--config-file={pathlib.Path('.clang-tidy').resolve()}",
                          f"--checks={checks}", str(source), "--"] + command[1:], capture_output=True, text=True)
    return (run.stdout if run.returncode == 0 else run.stdout + run.stderr).strip(), run.returncode == 0


def faulty_files(command, source):
    """The files in which the compiler finds errors."""
    run = subprocess.run(command + ["-fsyntax-only", str(source)], capture_output=True, text=True)
    return set(re.findall(r"^(.+?):\d+:\d+: (?:fatal )?error: ", run.stderr, re.MULTILINE))


def report(answers):
    """Prints each finding once: a header is read by many. Returns the exit code."""
    told = set()
    for said, is_good in answers:
        for finding in re.split(r"\n(?=\S+:\d+:\d+: (?:error|warning))", said):
            if not is_good and finding and finding not in told:
                told.add(finding)
                print(finding)
    return 1 if any(not is_good for _, is_good in answers) else 0


def jobs():
    return concurrent.futures.ThreadPoolExecutor(os.cpu_count())


def local_names(text):
    """What a file declares at the left margin: outside and inside an unnamed namespace."""
    outside, inside, is_inside = set(), set(), False
    for line in text.split("\n"):
        if line == "namespace {":
            is_inside = True
        elif line == "} // namespace":
            is_inside = False
        elif line[:1].isalpha() and not line.startswith("namespace"):
            found = TYPE_NAME.match(line) or OTHER_NAME.match(line)
            if found:
                (inside if is_inside else outside).add(found.group(1))
    return outside, inside


def meet(some, others):
    """Functions may share a name; a function and something else may not."""
    bare = {name.split("(")[0] for name in others if "(" in name}
    return some & others or {name for name in some if "(" not in name} & bare


class Unit:
    """Sources that are checked as one: none of them has a name that clashes with another's."""

    def __init__(self):
        self.sources, self.read, self.owned, self.size = [], set(), set(), 0

    def has_room_for(self, read, owned):
        return not (meet(owned, self.owned) or meet(self.owned, owned) or
                    meet(owned - read, self.read) or meet(self.owned - self.read, read))

    def take(self, source, read, owned):
        self.sources.append(source)
        self.read |= read
        self.owned |= owned
        self.size += source.stat().st_size


def join_commands(commands):
    """The sources, by commands that differ only in folders, macros and optimization; all get all folders and macros."""
    joined = {}  # the other words of a command -> its folders and macros, and the sources
    for source, words in sorted(commands.items()):
        options, rest, pending = [], [], iter(words)
        for word in pending:
            if word == "-isystem":
                options.append((word, next(pending)))
            elif word.startswith(("-I", "-D")):
                options.append((word,))
            elif not word.startswith("-O"):  # what is not compiled is not optimized
                rest.append(word)
        known, sources = joined.setdefault(tuple(rest), ([], []))
        known.extend(option for option in options if option not in known)
        sources.append(source)
    return [(list(rest) + [word for option in options for word in option], sources)
            for rest, (options, sources) in joined.items()]


def into_units(sources, headers):
    """A folder stays together, except for sources whose names clash with those of others."""
    names = {}

    def names_of(path):
        if path not in names:
            names[path] = local_names(path.read_text(errors="replace"))
        return names[path]

    folders = {}
    for source in sources:
        folders.setdefault(source.parent, []).append(source)
    units = [Unit() for _ in range(min(UNITS, len(folders)))]
    for folder in sorted(folders, key=lambda folder: -len(folders[folder])):
        units.sort(key=lambda unit: unit.size)
        for source in folders[folder]:
            outside, owned = names_of(source)
            # Each of two programs has a main.
            owned = owned | {name for name in outside if name.startswith("main(")}
            read = {name for path in headers.closure(source) if path != source for name in names_of(path)[0]}
            unit = next((unit for unit in units if unit.has_room_for(read, owned)), None)
            if not unit:
                unit = Unit()
                units.append(unit)
            unit.take(source, read, owned)
    return [unit.sources for unit in units]


def check_units(tool, version, commands, folder):
    """All checks that look at the text of one file, on many files at once."""
    os.makedirs(folder, exist_ok=True)
    checks = "-clang-analyzer-*,-bugprone-suspicious-include"
    cache, headers = memory(), Headers()

    def unit_key(command, sources):
        files = sorted({path for source in sources for path in headers.closure(source)})
        return key_of(checks, files, command, version)

    units = [(command, sources) for command, together in join_commands(commands)
             for sources in into_units(together, headers)]
    units.sort(key=lambda item: -len(item[1]))  # the longest first
    to_do = []
    for number, (command, sources) in enumerate(units):
        key = unit_key(command, sources)
        if not (cache / key).exists():
            to_do.append((str(number), command, sources, key))

    def unity_of(number, sources):
        unity = pathlib.Path(folder) / f"{number}.cpp"
        unity.write_text("".join(f'#include "{source.resolve()}"\n' for source in sources))
        return unity

    def ask_together(number, command, sources):
        """If they do not compile, the compiler says which cannot share a file: that is not a fault."""
        unity = unity_of(number, sources)
        said, is_good = ask(tool, checks, unity, command)
        if "[clang-diagnostic-error]" not in said or len(sources) == 1:
            return [(said, is_good)]
        faulty = faulty_files(command, unity)
        misfits = [source for source in sources if str(source.resolve()) in faulty]
        if not misfits:
            return [(said, is_good)]
        if len(misfits) == len(sources):
            misfits = sources[len(sources) // 2:]
        others = [source for source in sources if source not in misfits]
        return ask_together(number + "a", command, others) + ask_together(number + "b", command, misfits)

    def check(number, command, sources, key):
        answers = ask_together(number, command, sources)
        # Files changed in the meantime may not be the ones that were checked.
        if all(is_good for _, is_good in answers) and key == unit_key(command, sources):
            (cache / key).touch()
        return answers

    with jobs() as pool:
        answers = list(pool.map(lambda item: check(*item), to_do))
    code = report([answer for several in answers for answer in several])
    line = f"{len(commands)} files in {len(units)} units"
    if len(to_do) < len(units):
        line += f", {len(units) - len(to_do)} remembered"
    parted = sum(len(several) > 1 for several in answers)
    if parted:
        line += f", {parted} in parts: names meet"
    print(line + ".")
    return code


class Headers:
    """Which files of this project a source reads, itself included."""

    def __init__(self):
        self.read = {}

    def closure(self, source):
        found, open_files = set(), [source]
        while open_files:
            path = open_files.pop()
            if path not in found:
                found.add(path)
                open_files.extend(self.included(path))
        return sorted(found)

    def included(self, path):
        if path not in self.read:
            self.read[path] = []
            for name in INCLUDE.findall(path.read_text(errors="replace")):
                for place in (path.parent / name, pathlib.Path("src") / name, pathlib.Path(name)):
                    if place.is_file():
                        self.read[path].append(pathlib.Path(os.path.normpath(place)))
                        break
        return self.read[path]


def memory():
    """The folder with a file for each hash."""
    folder = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "rasterwalk-tidy"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def key_of(question, files, command, version):
    """A hash of everything an answer depends on."""
    key = hashlib.sha256(repr((question, command, version, [str(path) for path in files])).encode())
    for path in [pathlib.Path(__file__), pathlib.Path(".clang-tidy")] + files:
        key.update(hashlib.sha256(path.read_bytes()).digest())
    return key.hexdigest()


def analyze_files(tool, version, commands, seconds):
    """The analyzer follows the paths through each function; it would not in an included source."""
    checks = ",".join(["-*"] + re.findall(r"^\s*(clang-analyzer-[\w.]+)", pathlib.Path(".clang-tidy").read_text(),
                                          re.MULTILINE))
    cache, headers = memory(), Headers()
    to_do = []
    for source, command in commands.items():
        files = headers.closure(source)
        key = key_of(str(source), files, command, version)
        if not (cache / key).exists():
            changed = max(path.stat().st_mtime for path in files)
            to_do.append((-changed, source, command, key))
    to_do.sort(key=lambda item: item[:2])  # the last changed first
    end = time.monotonic() + seconds

    def analyze(source, command, key):
        if time.monotonic() > end:
            return None
        said, is_good = ask(tool, checks, source, command)
        if is_good and key == key_of(str(source), headers.closure(source), command, version):
            (cache / key).touch()
        return said, is_good

    with jobs() as pool:
        answers = list(pool.map(lambda item: analyze(*item[1:]), to_do))
    done = [answer for answer in answers if answer]
    code = report(done)
    line = f"{len(commands) - len(to_do)} files remembered, {len(done)} analyzed"
    if len(done) < len(to_do):
        line += f", {len(to_do) - len(done)} left for another time"
    print(line)
    return code


def main(arguments):
    if len(arguments) not in (2, 3) or arguments[0] not in ("checks", "analyzer") or \
            (arguments[0] == "checks" and len(arguments) != 3):
        print(__doc__, file=sys.stderr)
        return 2
    found = find_tool()
    if not found:
        print(f"clang-tidy {VERSION} is not installed; another version is not asked.")
        return NOT_ASKED
    commands = read_commands(arguments[1])
    if not commands:
        print(f"{arguments[1]} names no file of src/ or ui/.", file=sys.stderr)
        return 2
    if arguments[0] == "checks":
        return check_units(*found, commands, arguments[2])
    return analyze_files(*found, commands, float(arguments[2]) if len(arguments) == 3 else float("inf"))


sys.exit(main(sys.argv[1:]))
