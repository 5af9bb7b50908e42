"""Every header compiles alone: whoever includes it needs to include nothing before it.

A header that a source of the build includes before anything else has been compiled alone with that source: mesh.hpp with
mesh.cpp. The others are compiled here. One that includes Tpetra takes 2 s, so what passed is remembered in the build
folder by a digest of the header, of all headers of ours below it and of the compiler command; only what changed is
compiled again.

usage: headers.py BUILD_FOLDER JOBS
"""

import concurrent.futures
import hashlib
import json
import pathlib
import shlex
import subprocess
import sys

import house


def proven_by(sources):
    """Headers that a source includes before anything else; sources: texts of C++ files."""
    firsts = [included[0] for included in map(house.includes, sources) if included]
    return {name for quote, name in firsts if quote == '"'}


def sources_of(entries):
    """Texts of our sources among the entries of compile_commands.json."""
    paths = {pathlib.Path(entry["directory"], entry["file"]).resolve() for entry in entries}
    return [path.read_text(encoding="utf-8") for path in sorted(paths) if house.ROOT in path.parents]


def compiler_command(entries):
    """The command that compiles one source of the library, without ccache, source and output."""
    for entry in entries:
        if entry["file"].endswith("src/base/version.cpp"):
            words = shlex.split(entry["command"])
            drop = {words.index("-o"), words.index("-o") + 1, words.index("-c"), words.index("-c") + 1}
            command = [word for i, word in enumerate(words)
                       if i not in drop and "ccache" not in pathlib.Path(word).name and "VOUSSOIR_VERSION" not in word]
            return command + ["-fsyntax-only", "-x", "c++", "-"]
    sys.exit("compile_commands.json does not hold src/base/version.cpp")


def headers_below(name, known):
    """All headers of ours that `name` includes, itself first."""
    if name not in known and (house.ROOT / "src" / name).is_file():
        known[name] = house.read(f"src/{name}")
        for quote, below in house.includes(known[name]):
            if quote == '"':
                headers_below(below, known)
    return known


def digest(name, command):
    texts = headers_below(name, {})
    return hashlib.sha256("\0".join([*command, *texts, *texts.values()]).encode()).hexdigest()


def compile_alone(name, command):
    """The first lines of the compiler's complaint, or an empty string."""
    done = subprocess.run(command, input=f'#include "{name}"\n', capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else "\n".join([f"src/{name} does not compile alone:"] +
                                                     done.stderr.splitlines()[:8])


def main():
    build, jobs = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    entries = json.loads((build / "compile_commands.json").read_text())
    command, proven = compiler_command(entries), proven_by(sources_of(entries))
    memory = build / "headers_that_compile_alone.json"
    passed = set(json.loads(memory.read_text())) if memory.exists() else set()

    names = [str(path.relative_to("src")) for path in house.code_files(".hpp") if path.parts[0] == "src"]
    digests = {name: digest(name, command) for name in names if name not in proven}
    changed = [name for name in digests if digests[name] not in passed]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        complaints = dict(zip(changed, pool.map(lambda name: compile_alone(name, command), changed)))
    memory.write_text(json.dumps(sorted(digests[name] for name in digests if not complaints.get(name))))
    print(f"{len(names)} headers, {len(names) - len(digests)} come first in a source, {len(changed)} compiled, "
          "the others have not changed since they passed")
    house.finish("Every header compiles alone", [text for text in complaints.values() if text])


if __name__ == "__main__":
    main()
