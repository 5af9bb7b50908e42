"""The inputs of a sweep: what stands behind --set, the combinations it makes, and how they are called."""

import itertools
import math
import re

from .program import InputError

MOST_RUNS = 10000  # a sweep of more is a slip of the keyboard
LONGEST_NAME = 100  # letters of a folder


def spread(text, whole):
    """Values of "from:to:n", as many as asked for, evenly between both ends, which belong to them."""
    parts = text.split(":")
    try:
        low, high, count = float(parts[0]), float(parts[1]), int(parts[2])
        right = len(parts) == 3 and count >= 2 and math.isfinite(low) and math.isfinite(high) and low != high
    except (ValueError, IndexError):
        right = False
    if not right:
        raise InputError(f"--set {whole}\n  holds {text}, which is no range.\n"
                         "  Write from:to:n, two different numbers and how many values (2 or more), both ends included; "
                         "-2:2:9 is every half metre.")
    if count > MOST_RUNS:
        raise InputError(f"--set {whole}\n  asks for {count} values, at most {MOST_RUNS} may be.\n  Ask for fewer.")
    values = [low + (high - low) * k / (count - 1) for k in range(count)]
    step = abs(high - low) / (count - 1)
    digits = max(0, 6 - math.floor(math.log10(step)))  # 0.1 and not 0.1 + 1e-17: far below the step, so none coincide
    return [repr(round(value, digits) + 0.0).removesuffix(".0") for value in values]


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def values_of(text, whole):
    """Values that a text lists: between semicolons where there is one, else between commas; ranges among them."""
    pieces = [piece.strip() for piece in text.split(";" if ";" in text else ",")]
    values = []
    for piece in pieces:
        if not piece:
            raise InputError(f"--set {whole}\n  has an empty value.\n  Write path=a,b,c or path=from:to:n.")
        first = piece.split(":")[0]
        values += spread(piece, whole) if ":" in piece and (is_number(first) or not first) else [piece]
    twice = [value for k, value in enumerate(values) if value in values[:k]]
    if twice:
        raise InputError(f"--set {whole}\n  has {twice[0]} twice.\n  Every value is computed once; leave one out.")
    return values


def plain_path(path):
    """A path as --set of the program takes it, whichever of its ways it was written in."""
    pieces = [piece.strip() for piece in path.split(" > " if " > " in path else "/")]
    pieces = [piece for piece in pieces if piece]
    return "/".join(pieces[1:] if pieces[:1] == ["scene"] else pieces)


def read_inputs(texts):
    """path -> values, from texts such as "loads/axle/position=-2:2:9"."""
    inputs = {}
    for text in texts:
        path, equals, values = text.partition("=")
        path = plain_path(path)
        if not equals or not path:
            raise InputError(f"--set {text}\n  must be path=values.\n"
                             "  Write path=a,b,c or path=from:to:n, such as loads/axle/position=-2:2:9.")
        if path in inputs:
            raise InputError(f"--set {text}\n  names {path} a second time.\n  Give all its values in one --set.")
        inputs[path] = values_of(values, text)
    return inputs


def combinations(inputs, together):
    """Tuples of values, in the order of the inputs; `together`: the first of each, then the second of each, ..."""
    if not inputs:
        raise InputError("No input is varied.\n  Give one with --set path=a,b,c or --set path=from:to:n.")
    if together:
        counts = {path: len(values) for path, values in inputs.items()}
        longest = max(counts.values())
        if any(count not in (1, longest) for count in counts.values()):
            raise InputError("--zip\n  takes the first values of all inputs together, then the second ones, so that each needs as "
                             "many (or one alone, which stays): "
                             + ", ".join(f"{path} has {count}" for path, count in counts.items())
                             + ".\n  Give as many of each, or leave --zip out for all combinations.")
        return list(zip(*(values if len(values) > 1 else values * longest for values in inputs.values())))
    count = math.prod(len(values) for values in inputs.values())
    if count > MOST_RUNS:
        raise InputError(f"{count} combinations\n  are more than {MOST_RUNS}, which is what a sweep may have.\n"
                         "  Give fewer values, or --zip.")
    return list(itertools.product(*inputs.values()))


def short_names(paths):
    """Of every path its last key, or as many of its last keys as tell it from the others."""
    names = {}
    for path in paths:
        pieces = path.split("/")
        for length in range(1, len(pieces) + 1):
            name = "/".join(pieces[-length:])
            if sum(other == name or other.endswith("/" + name) for other in paths) == 1:
                break
        names[path] = name
    return names


def folder_names(inputs, combos):
    """One folder for each combination. It tells the values and depends on nothing else, so that a sweep of more values
    finds what is there."""
    short = short_names(list(inputs))
    names, fold = [], lambda text: re.sub(r"[^\w.+=-]+", "-", text)
    for combo in combos:
        name = fold("+".join(f"{short[path]}={value}" for path, value in zip(inputs, combo)))
        names.append(name)
    plain = len(set(names)) == len(names) and all(len(name) <= LONGEST_NAME and not name.startswith(".") for name in names)
    if plain:
        return names
    import hashlib

    exact = ["\n".join(f"{path}={value}" for path, value in zip(inputs, combo)) for combo in combos]
    return [f"{name[:60].lstrip('.')}-{hashlib.sha256(text.encode()).hexdigest()[:12]}" for name, text in zip(names, exact)]
