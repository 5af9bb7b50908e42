"""Code in READMEs is code: a command stands in a line of its own, and its options are options of the program."""

import re

import house

COMMANDS = ("drivers/run", "drivers/sweep", "drivers/scaling", "tests/run", "build/release/drivers/voussoir")
COMMAND = re.compile(r"(?<![\w./-])(?:" + "|".join(map(re.escape, COMMANDS)) + r")(?![\w/-])")
OPTION = re.compile(r"(?<!\S)--[a-z][a-z-]*")


def blocks(text):
    """Blocks of code of a text in Markdown, indented by four blanks or between fences: lists of (number, line)."""
    found, now, fenced, blank = [], [], False, True
    for number, line in enumerate(text.splitlines(), start=1):
        fence = line.lstrip().startswith("```")
        code = fenced or (line.startswith("    ") and (blank or now))
        if fence:
            fenced = not fenced
        elif code:
            now.append((number, line.strip()))
        elif now and line.strip():
            found.append(now)
            now = []
        blank = not line.strip()
    return found + ([now] if now else [])


def problems_of(path, text, known):
    """What is wrong with the code of a README, given the options that each command knows."""
    problems = []
    for block in blocks(text):
        before = ""
        for number, line in block:
            # Behind # there are words, which name no command either: such lines have run into one another.
            commands = COMMAND.findall(line)
            if len(commands) > 1:
                problems.append(f"{path}:{number}: two commands in one line of code: {line}")
            if line.startswith("--") and not before.endswith("\\"):
                problems.append(f"{path}:{number}: a line of code begins with an option: {line}")
            if commands and line.startswith(commands[0]):
                options = OPTION.findall(line.split(" #")[0])
                problems += [f"{path}:{number}: {commands[0]} has no option {option}" for option in options
                             if commands[0] in known and option not in known[commands[0]]]
            before = line
    return problems


def known_options():
    voussoir = set(OPTION.findall(house.read("drivers/voussoir.cpp").replace('"', " ").replace("=", " ")))
    run = set(OPTION.findall(house.read("drivers/run").replace("=", " ").replace("|", " ")))
    sweep = set(OPTION.findall(house.read("python/voussoir/sweep_command.py").replace('"', " ")))
    scaling = set(OPTION.findall(house.read("drivers/scaling").replace('"', " ").replace("=", " ").replace(",", " ")))
    return {"build/release/drivers/voussoir": voussoir, "drivers/run": run | voussoir, "drivers/sweep": sweep,
            "drivers/scaling": scaling}


if __name__ == "__main__":
    options = known_options()
    markdown = house.code_files(".md") + [path.relative_to(house.ROOT) for folder in ("xml", "meshes")
                                          for path in (house.ROOT / folder).glob("*.md")]
    house.finish("code in READMEs is code",
                 [problem for path in markdown for problem in problems_of(path, house.read(path), options)])
