#!/usr/bin/env python3
"""Makes docs/measured.md of the figures in a folder: table.json, which `judges` wrote, and other *.json, whose figures were measured
by other programs, each with its conditions and its edition.

usage: page.py FOLDER -o PAGE | page.py FOLDER --check PAGE | page.py FOLDER --keep TABLE

--check says whether the page is what the figures make of it. --keep takes a table over, if it is a whole one.
"""
import json
import os
import sys

GROUPS = {"seen": "seen", "held_out": "held out", "shared": "shared"}
OF_RIGS = ("intent", "gesture", "meant", "drawing_beside")     # what the page says of each rig
MEASURES = [
    ("intent", "faces of known poses by several hands: error of the whole face, of its movement"),
    ("gesture", "lines that no pose meets: *right* if what an artist means moves and little else"),
    ("body", "limbs of known poses: error of the figure, of its height"),
    ("exact", "exact targets, preset `exact`: gap to the least sum of distances"),
    ("meant", "the same targets, default preset: error of the whole face"),
    ("drawing_over", "one drawing of a whole face of a known pose, over it: *right* are lines given their own curve"),
    ("drawing_over_10", "the same, place and proportions 10 % off"),
    ("drawing_over_20", "the same, 20 % off"),
    ("drawing_beside", "the same anywhere on a sheet of its own, larger or smaller, turned"),
    ("drawing_beside_10", "the same, proportions 10 % off"),
    ("drawing_beside_20", "the same, 20 % off"),
    ("drawn_faces", "faces as people draw them: *right* if the face shows the signs of what is meant; stray: torn lips and lids"),
    ("no_faces", "drawings of other things: *right* if nothing moves"),
    ("drawn_by_people", "faces typed by twelve hands, `tests/judges/drawing/sets`; on rigs that are held out, hands that are held out"),
    ("drawn_by_people_rest", "the same, with the same hand's drawing of the face at rest"),
    ("no_faces_by_people", "drawings of other things by these hands: *right* if nothing moves"),
    ("shared_drawings", "faces and other things of the shared data, judged like these two"),
]


def read(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError) as error:
        sys.exit(f"{path}: {error}; tests/judges/run makes the table, the others are kept in the project")


def number(value, digits=1):
    return f"{value:.{digits}f}"


def right(row):
    return f"{row['right']:.0f}/{row['of']:.0f}" if "of" in row else ""


def error(row):
    return f"{number(row['error_median'])}/{number(row['error_worst'])}" if "error_median" in row else ""


def lines_of(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + " --- |" * len(head)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def judged(table):
    rows = table["rows"]
    known = [m for m, _ in MEASURES]
    measures = sorted({r["measure"] for r in rows}, key=lambda m: (known.index(m) if m in known else len(known), m))
    yield "## How it reads what was drawn"
    yield ""
    yield f"Edition {table['edition']}, commit {table.get('commit', 'unknown')}, {table.get('machine', 'a machine')}; `tests/judges/run`."
    yield "Code makes the rigs; nobody chose anything by looking at those *held out*, so only their totals are shown. *Shared*: real models."
    yield ""
    for name, text in MEASURES:
        if name in measures:
            yield f"- `{name}`: {text}"
    yield ""
    if "note" in table:
        yield table["note"]
        yield ""
    yield "Errors are median/worst, strays (what should stay) 95 in 100/worst, in per cent; *still*: farthest of what was redrawn in place."
    yield ""
    totals = [r for r in rows if r["rig"] == "all"]
    totals.sort(key=lambda r: (measures.index(r["measure"]), list(GROUPS).index(r["group"])))
    cells = []
    for r in totals:
        stray = f"{number(r['stray_95'], 2)}/{number(r['stray_worst'], 2)}" if "stray_95" in r else ""
        still = number(r["still_worst"], 2) if "still_worst" in r else ""
        cells.append([r["measure"], GROUPS[r["group"]], str(r["cases"]), right(r), error(r), stray, still, number(r["ms_median"])])
    yield from lines_of(["measure", "rigs", "cases", "right", "error", "stray", "still", "ms"], cells)
    yield ""
    measures = [m for m in measures if m in OF_RIGS]
    rigs = []
    for r in rows:
        if r["rig"] != "all" and r["group"] != "held_out" and r["measure"] in measures and r["rig"] not in rigs:
            rigs.append(r["rig"])
    cells = []
    for rig in rigs:
        mine = {r["measure"]: r for r in rows if r["rig"] == rig}
        cells.append([rig] + [(right(mine[m]) or error(mine[m])) if m in mine else "" for m in measures])
    yield from lines_of(["rig"] + measures, cells)


def section(part):
    yield f"## {part['title']}"
    yield ""
    if "note" in part:
        yield part["note"]
        yield ""
    yield from lines_of(["what", "figure", "how", "edition"],
                        ([f["what"], f["figure"], f["how"], str(f["edition"])] for f in part["figures"]))


def page(folder):
    parts = [read(os.path.join(folder, name)) for name in sorted(os.listdir(folder)) if name.endswith(".json") and name != "table.json"]
    parts.sort(key=lambda part: part["order"])
    out = ["# Measurements", "",
           "`tests/judges/page.py` makes this page from `tests/judges/measured`. A figure was measured with the edition that its row names (0:",
           "before there were any), on one core of a shared 2-core AMD EPYC if no machine is named.", ""]
    out += judged(read(os.path.join(folder, "table.json")))
    for part in parts:
        out += [""] + list(section(part))
    return "\n".join(out) + "\n"


def main(args):
    if len(args) != 3 or args[1] not in ("-o", "--check", "--keep"):
        sys.exit(__doc__)
    folder, what, path = args
    if what == "--keep":
        table = read(path)
        if table.get("short"):
            sys.exit(f"{path}: a table of --short; run judges without it")
        place = os.path.join(folder, "table.json")
        lost = {r["group"] for r in read(place)["rows"]} - {r["group"] for r in table["rows"]} if os.path.exists(place) else set()
        if lost:
            sys.exit(f"{path}: no rows of {', '.join(sorted(lost))} rigs, which {place} has; run it where the shared models are")
        rows = [{k: round(v, 3) if isinstance(v, float) else v for k, v in r.items()} for r in table["rows"]]
        head = {k: v for k, v in table.items() if k != "rows"}
        with open(place, "w", encoding="utf-8") as file:
            file.write(json.dumps(head)[:-1] + ', "rows": [\n' + ",\n".join(json.dumps(r) for r in rows) + "\n]}\n")
        return 0
    made = page(folder)
    if what == "-o":
        with open(path, "w", encoding="utf-8") as file:
            file.write(made)
        return 0
    with open(path, encoding="utf-8") as file:
        same = file.read() == made
    if not same:
        print(f"{path} is not what {folder} makes of it; run tests/judges/page.py {folder} -o {path}")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
