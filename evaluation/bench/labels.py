# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of recorded rooms with the calls that a careful reader accepts for them.

A line of a .jsonl file is an object with room, list, subject_index, sentence and gold, and with bullet and part where a
bullet was split: lines of one bullet make one sentence."""

import json
from dataclasses import dataclass, field
from pathlib import Path

from calls import FUNCTIONS, Arguments, BadCall, canonical, object_id
from problem import BadProblem, read_graph

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
            if isinstance(value, bool):
                return str(value).lower()
            return f"{value:g}" if isinstance(value, float) else str(value)

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
    graph: dict
    bullets: list[Bullet] = field(default_factory=list)


def _object_id(index: object, room: Room) -> str:
    tertiary = isinstance(index, str) and index[:1] == "t"
    name = object_id(tertiary, index[1:] if tertiary else index)
    if all(made["id"] != name for made in room.graph["object_list"]["objects"]):
        raise BadLabels(f'the room has no object {json.dumps(index)}; expected an index such as 3 or "t3"')
    return name


def read_call(call: object, room: Room) -> Call:
    """A labelled call {"function", "objects", "params"}; objects are indices, "t3" is a tertiary one."""
    given = call if isinstance(call, dict) else {}
    if not isinstance(given.get("function"), str) or not isinstance(given.get("objects"), list):
        raise BadLabels(f"gold: {json.dumps(call)} is not a call with function and objects")
    if not canonical(call["function"]):
        raise BadLabels(f"gold: unknown function {call['function']}")
    function, arguments = FUNCTIONS[canonical(call["function"])], {}
    objects = [_object_id(index, room) for index in call["objects"]]
    for name, kind in function.parameters:
        if kind not in "oOiL" or (kind == "O" and not objects):
            continue
        if not objects:
            raise BadLabels(f"objects: too few for {function.type}")
        arguments[name], objects = (objects, []) if kind == "L" else (objects[0], objects[1:])
    if objects:
        raise BadLabels(f"objects: too many for {function.type}")
    subject = next(iter(arguments.values()), "")
    for keyword, value in call.get("params", {}).items():
        position = function.position_of({"type": "fixed_object_type", "zone": "region_name"}.get(keyword, keyword))
        if position < 0:
            raise BadLabels(f"params: {function.type} has no {keyword}")
        name, kind = function.parameters[position]
        said = Arguments(room.graph).read(name, kind, value, subject)
        if said is not None:
            arguments[name] = said
    return Call(function.type, arguments)


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
                except (BadCall, BadLabels) as error:
                    self.failures.append(f"{file}:{number}: {error}")
        self.rooms = {name: room for name, room in self.rooms.items() if room.bullets}
        if not self.rooms:
            raise BadLabels(self.failures[0] if self.failures else f"{path}: no labels in it")

    def _room(self, name: object) -> Room:
        if not isinstance(name, str) or not name or "/" in name:
            raise BadLabels("room: missing, or not a file name")
        if name not in self.rooms:
            paths = [folder / f"{name}.json" for folder in self._folders if (folder / f"{name}.json").is_file()]
            if not paths:
                raise BadLabels(f"room: no {name}.json in {self._folders[0]}; name its folder with --rooms")
            try:
                self.rooms[name] = Room(read_graph(paths[0].read_text(encoding="utf-8")))
            except BadProblem as error:
                raise BadLabels(f"{paths[0]}: {error}") from error
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
