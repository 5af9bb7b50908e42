"""Every header compiles alone: whoever includes it needs to include nothing before it.

The sources of a folder are compiled as one, so that a header may find there what another source has included. Here each
is compiled by itself. One that includes Tpetra takes 2 s, so what passed is remembered in the build folder by a digest
of the header, of all headers of ours below it and of the compiler command; only what changed is compiled again.

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
    command = compiler_command(json.loads((build / "compile_commands.json").read_text()))
    memory = build / "headers_that_compile_alone.json"
    passed = set(json.loads(memory.read_text())) if memory.exists() else set()

    names = [str(path.relative_to("src")) for path in house.code_files(".hpp") if path.parts[0] == "src"]
    digests = {name: digest(name, command) for name in names}
    changed = [name for name in names if digests[name] not in passed]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        complaints = dict(zip(changed, pool.map(lambda name: compile_alone(name, command), changed)))
    memory.write_text(json.dumps(sorted(digests[name] for name in names if not complaints.get(name))))
    print(f"{len(names)} headers, {len(changed)} compiled, the others have not changed since they passed")
    house.finish("Every header compiles alone", [text for text in complaints.values() if text])


if __name__ == "__main__":
    main()
