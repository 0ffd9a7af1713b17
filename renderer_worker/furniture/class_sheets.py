#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws every piece of the handbook once, to be looked at beside its name: twelve to a room, as a plan and from above.

    renderer_worker/furniture/class_sheets.py OUT [WORD ...]    those whose name has one of the words; all without words
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS, ROWS = 4, 3


def pieces():
    for path in sorted((ROOT / "language_worker/handbook/data").glob("*.textproto")):
        for text in re.findall(r"^furniture \{\n(.*?)^\}", path.read_text(), re.M | re.S):
            def field(pattern, usual=""):
                found = re.search("^  " + pattern, text, re.M)
                return found.group(1) if found else usual
            sizes = [float(field(side + r"_m \{ typical: ([\d.]+)", 0.3)) for side in ("width", "depth", "height")]
            yield field('name: "(.*?)"'), field('category: "(.*?)"'), field(r"kind: FURNITURE_KIND_(\w+)", "FLOOR"), sizes


def layout(sheet):
    """Pieces in rows from the far left, each in a cell of the largest one's size."""
    cell_x = max(size[0] for *_, size in sheet) + 0.35
    cell_y = max(size[1] for *_, size in sheet) + 0.35
    width, depth = COLUMNS * cell_x, ROWS * cell_y
    corners = "".join(f"vertices {{ x_m: {x} y_m: {y} }} " for x, y in ((0, 0), (width, 0), (width, depth), (0, depth)))
    walls = "".join(f'walls {{ name: "{name}" }} ' for name in ("south", "east", "north", "west"))
    objects, placements = "", ""
    for i, (name, category, kind, (w, d, h)) in enumerate(sheet):
        x, y = (i % COLUMNS + 0.5) * cell_x, depth - (i // COLUMNS + 0.5) * cell_y
        objects += (f'  objects {{ id: "piece_{i + 1}" name: "{name}" category: "{category}" kind: OBJECT_KIND_{kind} '
                    f"role: OBJECT_ROLE_{'SECONDARY' if kind == 'FLOOR' else 'TERTIARY'} zone_id: \"all\" width_m: {w} depth_m: {d} height_m: {h} }}\n")
        placements += f'placements {{ object_id: "piece_{i + 1}" x_m: {x} y_m: {y} theta_rad: 3.14159265 }}\n'
    return ("# proto-file: flair/v1/artifact.proto\n# proto-message: flair.v1.Artifact\nsolved_layout {\ngraph {\n"
            f'zone_plan {{ zones {{ id: "all" name: "pieces" }} }}\nroom {{ room_type: "show room" height_m: 2.6 floor {{ {corners}}} {walls}}}\nobject_list {{\n{objects}}}\n}}\n{placements}}}\n')


def main():
    out, words = pathlib.Path(sys.argv[1]), sys.argv[2:]
    out.mkdir(parents=True, exist_ok=True)
    chosen = [piece for piece in pieces() if not words or any(word in piece[0] for word in words)]
    chosen.sort(key=lambda piece: (piece[2], max(piece[3][:2]) // 0.4))
    count = COLUMNS * ROWS
    for first in range(0, len(chosen), count):
        sheet = chosen[first:first + count]
        stem = out / f"sheet_{first // count + 1:02}"
        stem.with_suffix(".textproto").write_text(layout(sheet))
        print(stem.name, *(piece[0] for piece in sheet), sep=", ")
        for picture, options in ((f"{stem}_plan.png", []), (f"{stem}_view.png", ["--view", "birdseye", "--size", "1100"])):
            subprocess.run([ROOT / "flair", "render", stem.with_suffix(".textproto"), "--out", picture, *options], check=True)


if __name__ == "__main__":
    main()
