"""xml/reference.xml is what the program prints, so the documentation of a scene cannot grow old.

usage: reference.py VOUSSOIR_PROGRAM
"""

import difflib
import subprocess
import sys

import house


def main():
    printed = subprocess.run([sys.argv[1], "--print-parameters"], capture_output=True, text=True, check=True).stdout
    path = house.ROOT / "xml" / "reference.xml"
    kept = path.read_text(encoding="utf-8") if path.exists() else ""
    difference = list(difflib.unified_diff(kept.splitlines(), printed.splitlines(), "xml/reference.xml",
                                           "voussoir --print-parameters", lineterm="", n=1))
    if difference:
        print("\n".join(difference[:40]))
        difference = ["Renew it: drivers/run --quiet --print-parameters > xml/reference.xml"]
    house.finish("xml/reference.xml is current", difference)


if __name__ == "__main__":
    main()
