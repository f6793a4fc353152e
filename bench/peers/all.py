"""Runs all comparisons with peers, one after the other, and prints the goals of all in one table.

The exit status is the number of lines that fall short, or 125 if a part did not run to its end.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from goals import Line, finish  # noqa: E402

PARTS = ("run", "motion", "series", "continuation")
BROKEN = 125


def lines_of(part, words, folder):
    """The goals of a part, which prints its own tables; none if it failed."""
    file = Path(folder) / f"{part}.json"
    print(f"\n== bench/peers/{part}", flush=True)
    subprocess.run([HERE / part, "--line", words, "--json", file], check=False)
    if not file.exists():
        print(f"bench/peers/{part} did not run to its end", file=sys.stderr)
        return None
    records = json.loads(file.read_text(encoding="utf-8"))["lines"]
    return [Line(it["work"], it["peer"], it["goal"], it["quotients"]) for it in records]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--line", metavar="WORDS", default="", help="only work whose name contains this")
    parser.add_argument("--json", metavar="FILE", help="write the goals there too")
    return parser.parse_args()


def main(options):
    with tempfile.TemporaryDirectory() as folder:
        found = [lines_of(part, options.line, folder) for part in PARTS]
    print("\n== all")
    short = finish([line for lines in found for line in lines or ()], options.json)
    return BROKEN if None in found else short


if __name__ == "__main__":
    sys.exit(main(arguments()))
