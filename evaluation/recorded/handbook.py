# SPDX-License-Identifier: GPL-3.0-or-later
"""What no recording tells, from the handbook's data: how high furniture is, what kind of room a brief asks for, and
which words are colours."""

import re
from functools import cache
from pathlib import Path

from names import Thing, singular

_DATA = Path(__file__).resolve().parents[2] / "language_worker/handbook/data"
# Of what the handbook does not know.
_USUAL_M = {"surface": 0.25, "wall": 0.5, "ceiling": 0.5, "floor": 0.01}
_FLOOR_M = 0.8


def _plain(text: str) -> str:
    return " ".join(re.findall(r"[^\W_]+", text.lower()))


@cache
def _entries(kind: str) -> list[tuple[list[str], str]]:
    """All top-level entries of that field: their names, the first of which is not a synonym, and their text."""
    entries = []
    for path in sorted(_DATA.glob("*.textproto")):
        for body in re.findall(rf"^{kind} {{\n(.*?)^}}", path.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE):
            named = re.search(r'^  name: "(.*?)"', body, re.MULTILINE)
            synonyms = re.search(r"^  synonyms: (?:\[(.*?)\]|(\".*?\"))", body, re.DOTALL | re.MULTILINE)
            listed = re.findall(r'"(.*?)"', synonyms[1] or synonyms[2]) if synonyms else []
            entries.append(([named[1], *listed], body))
    return entries


@cache
def _heights() -> dict[str, float]:
    heights: dict[str, float] = {}
    # Names before synonyms: a word may be one entry's name and another's synonym.
    for only_names in (True, False):
        for names, body in _entries("furniture"):
            height = re.search(r"^  height_m \{ typical: ([\d.]+)", body, re.MULTILINE)
            for name in names[:1] if only_names else names[1:]:
                heights.setdefault(_plain(name), float(height[1]) if height else 0)
    return heights


def height_of(thing: Thing, room_height_m: float = 3) -> float:
    height_m = _FLOOR_M if thing.role != "tertiary" else _USUAL_M[thing.kind]
    words = _plain(thing.name).split()
    for begin in range(len(words)):
        name = " ".join(words[begin:])
        known = _heights().get(name, _heights().get(" ".join([*words[begin:-1], singular(words[-1])])))
        if known is not None:
            height_m = known or height_m
            break
    return min(height_m, room_height_m - 0.2)


def kind_of_room(brief: str) -> str:
    """The handbook's name for it; "room" when the brief names none that it knows."""
    text = f" {_plain(brief)} "
    named = [(text.index(f" {_plain(name)} "), -len(name), names[0]) for names, _ in _entries("archetypes")
             for name in names if f" {_plain(name)} " in text]
    return min(named)[2] if named else "room"


@cache
def _colours() -> re.Pattern[str]:
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(_DATA.glob("*.textproto")))
    entries = re.findall(r"^colours \{([^}]*)\}", text, re.MULTILINE)
    names = {name for entry in entries for name in re.findall('"(.*?)"', entry) if not name.startswith("#")}
    # The longest first: "off-white" before "white".
    return re.compile(rf"\b(?:{'|'.join(map(re.escape, sorted(names, key=len, reverse=True)))})\b")


def colour_in(text: str) -> str:
    """The first colour that a text names; empty when it names none."""
    found = _colours().search(text.lower())
    return found[0] if found else ""


def turned(brief: str, width_m: float, depth_m: float) -> bool:
    """Some rooms were recorded the other way round than their brief says."""
    size = re.search(r"(\d+(?:\.\d+)?) ?m? ?(?:x|by) ?(\d+(?:\.\d+)?)", brief)
    return size is not None and width_m != depth_m and (float(size[1]), float(size[2])) == (depth_m, width_m)


