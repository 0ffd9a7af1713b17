# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of recorded rooms with the calls that a careful reader accepts for them.

A line of a .jsonl file is an object with room, list, subject_index, sentence and gold, and with bullet and part where a
bullet was split: lines of one bullet make one sentence."""

import json
from dataclasses import dataclass, field
from pathlib import Path

VOCABULARY = json.loads((Path(__file__).resolve().parents[1] / "readers/flairgpt_vocabulary.json").read_text())
LISTS = ("primary_intra", "primary_inter", "secondary_intra", "secondary_inter", "tertiary")


class BadLabels(Exception):
    """A line, or a file, that says nothing that can be measured."""


@dataclass(frozen=True)
class Call:
    """A call in our words, with no more arguments than a label states."""

    type: str
    arguments: dict[str, object]

    def text(self) -> str:
        """"near(object=floor_3, max_distance_m=0.6)"."""
        def shown(value: object) -> str:
            if isinstance(value, list):
                return f"[{', '.join(value)}]"
            return str(value).lower() if isinstance(value, bool) else f"{value:g}" if isinstance(value, float) else str(value)

        return f"{self.type}({', '.join(f'{name}={shown(value)}' for name, value in self.arguments.items())})"


@dataclass
class Label:
    """One labelled clause: a whole bullet, or one fact of it."""

    # The reference function of the best alternative; "refuse" when nothing is to be made of it.
    function: str
    # What is accepted, best first: all calls of one of them. Empty when the clause is to be refused.
    alternatives: list[list[Call]]


@dataclass
class Bullet:
    """A sentence as the model wrote it, with the labels of its clauses."""

    list: str
    text: str
    subjects: list[str]
    labels: list[Label] = field(default_factory=list)


@dataclass
class Room:
    path: Path
    # By id: whether the object is no deeper than wide.
    objects: dict[str, bool]
    bullets: list[Bullet] = field(default_factory=list)


def _read_room(path: Path) -> Room:
    try:
        room = json.loads(path.read_text(encoding="utf-8"))
        listed = [("floor", piece) for piece in room["primary"] + room["secondary"]]
        listed += [("item", piece) for piece in room["tertiary"]]
        return Room(path, {f"{kind}_{piece['index']}": piece["width"] >= piece["length"] for kind, piece in listed})
    except (ValueError, KeyError, TypeError) as error:
        raise BadLabels(f"{path}: not a recorded room: {error}") from error


def _object_id(index: object, room: Room) -> str:
    name = f"item_{index[1:]}" if isinstance(index, str) and index[:1] == "t" else f"floor_{index}"
    if name not in room.objects:
        raise BadLabels(f'the room has no object {json.dumps(index)}; expected an index such as 3 or "t3"')
    return name


def _parameters(function: str) -> list[tuple[str, str]]:
    """Of a function of the reference: names and the letters of their kinds."""
    words = VOCABULARY["functions"][function].split()[1:]
    return [(name, kind) for name, _, kind in (word.partition(":") for word in words) if kind]


def canonical(name: str) -> str:
    """The name of a function of another version, or a slip whose meaning is clear; empty when it is unknown."""
    if name.startswith("p_"):
        name = "io_" + name[2:]
    name = VOCABULARY["aliases"].get(name, name)
    swapped = {"ind": "io", "io": "ind"}.get(name.partition("_")[0], "") + "_" + name.partition("_")[2]
    return next((known for known in (name, swapped) if known in VOCABULARY["functions"]), "")


def _sides(value: object, wide: bool) -> list[str]:
    ends, flanks = ["front", "back"], ["left", "right"]
    groups = {"all": ends + flanks, "every": ends + flanks, "all sides": ends + flanks, "side": flanks, "sides": flanks}
    sides: list[str] = []
    for word in value if isinstance(value, list) else [value]:
        if word in ("one", "any"):
            return ["front"]
        if str(word).startswith("long") or word == "length":
            named = ends if wide else flanks
        elif str(word).startswith("short") or word == "width":
            named = flanks if wide else ends
        elif word in VOCABULARY["sides"]:
            named = [VOCABULARY["sides"][word]]
        elif word in groups:
            named = groups[word]
        else:
            raise BadLabels(f"unknown side {json.dumps(word)}")
        sides += [side for side in named if side not in sides]
    return sides


def _value(kind: str, value: object, wide: bool) -> object:
    """A parameter's value in our words; None when it says nothing."""
    if kind in "sS":
        sides = _sides(value, wide)
        return sides if kind == "S" else sides[0] if len(sides) == 1 else None
    if kind == "n":
        return float(value)
    if kind == "z":
        return "".join(c.lower() if c.isascii() and c.isalnum() else "_" for c in value)
    if kind in "fc":
        words = VOCABULARY["features" if kind == "f" else "corners"]
        if value not in words:
            raise BadLabels(f"unknown {'feature' if kind == 'f' else 'corner'} {json.dumps(value)}")
        return words[value]
    return None if kind == "_" else value


def read_call(call: object, room: Room) -> Call:
    """A labelled call {"function", "objects", "params"}; objects are indices, "t3" is a tertiary one."""
    if not isinstance(call, dict) or not isinstance(call.get("function"), str) or not isinstance(call.get("objects"), list):
        raise BadLabels(f"gold: {json.dumps(call)} is not a call with function and objects")
    function = canonical(call["function"])
    if not function:
        raise BadLabels(f"gold: unknown function {call['function']}")
    made, arguments = VOCABULARY["functions"][function].split()[0], {}
    objects = [_object_id(index, room) for index in call["objects"]]
    for name, kind in _parameters(function):
        if kind not in "oOiL" or (kind == "O" and not objects):
            continue
        if not objects:
            raise BadLabels(f"objects: too few for {made}")
        arguments[name], objects = (objects, []) if kind == "L" else (objects[0], objects[1:])
    if objects:
        raise BadLabels(f"objects: too many for {made}")
    wide = room.objects.get(next(iter(arguments.values()), ""), True)
    for given, value in call.get("params", {}).items():
        keyword = {"type": "fixed_object_type", "zone": "region_name"}.get(given, given)
        meant = [(name, kind) for name, kind in _parameters(function) if name in VOCABULARY["keywords"].get(keyword, [])]
        if not meant:
            raise BadLabels(f"params: {made} has no {given}")
        said = _value(meant[0][1], value, wide)
        if said is not None:
            arguments[meant[0][0]] = said
    return Call(made, arguments)


class Labels:
    """All labelled rooms, in the order of the labels; `failures` are lines "FILE:LINE: reason"."""

    def __init__(self, path: Path, rooms: Path | None) -> None:
        self.rooms: dict[str, Room] = {}
        self.failures: list[str] = []
        folder = path if path.is_dir() else path.parent
        self._folders = [rooms] if rooms else [folder, folder / "rooms", folder.parent / "rooms"]
        files = sorted(path.glob("*.jsonl")) if path.is_dir() else [path]
        if not files:
            raise BadLabels(f"{path}: no .jsonl files in it")
        for file in files:
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                try:
                    self._read(line)
                except BadLabels as error:
                    self.failures.append(f"{file}:{number}: {error}")
        self.rooms = {name: room for name, room in self.rooms.items() if room.bullets}
        if not self.rooms:
            raise BadLabels(self.failures[0] if self.failures else f"{path}: no labels in it")

    def _room(self, name: object) -> Room:
        if not isinstance(name, str) or not name or "/" in name:
            raise BadLabels("room: missing, or not a file name")
        if name not in self.rooms:
            path = next((folder / f"{name}.json" for folder in self._folders if (folder / f"{name}.json").is_file()), None)
            if path is None:
                raise BadLabels(f"room: no {name}.json in {self._folders[0]}; name its folder with --rooms")
            self.rooms[name] = _read_room(path)
        return self.rooms[name]

    def _read(self, line: str) -> None:
        if not line.strip():
            return
        try:
            record = json.loads(line)
        except ValueError:
            record = None
        if not isinstance(record, dict):
            raise BadLabels("not a JSON object")
        room = self._room(record.get("room"))
        if not isinstance(record.get("sentence"), str):
            raise BadLabels("sentence: missing; expected a text")
        if record.get("list") not in LISTS:
            raise BadLabels(f"list: unknown list {record.get('list')}; known are {', '.join(LISTS)}")
        if not isinstance(record.get("gold"), list):
            raise BadLabels("gold: missing; expected a list of alternatives, empty to refuse")
        if not all(isinstance(alternative, list) and alternative for alternative in record["gold"]):
            raise BadLabels("gold: an alternative without calls")
        text, sentence = record.get("bullet", record["sentence"]), record["sentence"]
        subjects = [_object_id(index, room) for index in record.get("subject_index", [])]
        label = Label(record["gold"][0][0]["function"] if record["gold"] and isinstance(record["gold"][0][0], dict)
                      and "function" in record["gold"][0][0] else "refuse",
                      [[read_call(call, room) for call in alternative] for alternative in record["gold"]])
        last = room.bullets[-1] if room.bullets else None
        if last is None or (last.list, last.text) != (record["list"], text) or text == sentence:
            last = Bullet(record["list"], text, subjects)
            room.bullets.append(last)
        last.labels.append(label)
