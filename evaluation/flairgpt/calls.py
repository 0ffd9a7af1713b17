# SPDX-License-Identifier: GPL-3.0-or-later
"""The calls of recorded problems as constraint edges of ours, in the form that their JSON has."""

import json
import math
import re
from pathlib import Path

VOCABULARY = json.loads((Path(__file__).parent / "vocabulary.json").read_text(encoding="utf-8"))
# No index of an object is larger.
LARGEST_INDEX = 1e6


class BadCall(Exception):
    """What is wrong with a call: it means nothing."""


class Function:
    """A function of the reference: our type, and its parameters in the order of its positional arguments, each a name
    of ours and the letter of its kind; see vocabulary.json."""

    def __init__(self, row: str) -> None:
        self.type, *words = row.split()
        # Further arguments do not change what the call says.
        self.ignores_others = "*" in words
        self.parameters = [(name, kind) for name, _, kind in (word.partition(":") for word in words) if kind]

    def position_of(self, keyword: str) -> int:
        """Of the parameter that a recorded keyword names; -1 when it names none."""
        # The empty name is that of what is ignored. A tertiary's object_index is the floor object that it belongs to.
        item_first = keyword in ("object_index", "other_index") and self.parameters[:1] and self.parameters[0][1] == "i"
        names = VOCABULARY["keywords"].get(keyword, [])
        return next((i for i, (name, _) in enumerate(self.parameters) if name in names and i >= bool(item_first)), -1)


FUNCTIONS = {name: Function(row) for name, row in VOCABULARY["functions"].items()}


def canonical(name: str) -> str:
    """The name of a function of another version, or a slip whose meaning is clear; empty when it is unknown."""
    name = "io_" + name[2:] if name.startswith("p_") else name
    name = VOCABULARY["aliases"].get(name, name)
    kind, _, rest = name.partition("_")
    swapped = {"ind": "io", "io": "ind"}.get(kind, "") + "_" + rest
    return next((known for known in (name, swapped) if known in FUNCTIONS), "")


def words_of(name: str) -> str:
    """"Dining_Area" is "dining area"."""
    return " ".join(re.findall(r"[a-z0-9]+", name.lower()))


def object_id(tertiary: bool, index: int) -> str:
    return f"{'item' if tertiary else 'floor'}_{index}"


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def sides_of(value: object, wide: bool) -> list[str]:
    """The sides that words mean on an object that is `wide`: not deeper than wide."""
    ends, flanks = ["front", "back"], ["left", "right"]
    groups = {"all": ends[:1] + ends[1:] + flanks, "side": flanks, "sides": flanks}
    groups["every"] = groups["all sides"] = groups["all"]
    sides: list[str] = []
    for word in value if isinstance(value, list) else [value] if isinstance(value, str) else []:
        word = word if isinstance(word, str) else json.dumps(word)
        if word in ("one", "any"):
            return ["front"]
        if word.startswith("long") or word == "length":
            named = ends if wide else flanks
        elif word.startswith("short") or word == "width":
            named = flanks if wide else ends
        elif word in groups:
            named = groups[word]
        elif word in VOCABULARY["sides"]:
            named = [VOCABULARY["sides"][word]]
        else:
            raise BadCall(f'unknown side "{word}"')
        sides += [side for side in named if side not in sides]
    return sides


class Arguments:
    """Reads arguments against the room, zones and objects of a graph."""

    def __init__(self, graph: dict) -> None:
        self._objects = {made["id"]: made for made in graph["object_list"]["objects"]}
        self._zones = graph["zone_plan"]["zones"]
        room = graph["room"]
        self._features = {"door" if one["kind"] == "OPENING_KIND_DOOR" else "window" for one in room["openings"]}
        self._features |= {"socket"} if room["sockets"] else set()

    def object(self, recorded: object, tertiary: bool) -> str:
        """By index or by name."""
        value = recorded[0] if isinstance(recorded, list) and len(recorded) == 1 else recorded
        if _is_number(value) and abs(value) <= LARGEST_INDEX and value == math.floor(value):
            if object_id(tertiary, int(value)) in self._objects:
                return object_id(tertiary, int(value))
        if isinstance(value, str):
            named = [name for name, made in self._objects.items() if words_of(made["name"]) == words_of(value)]
            if len(named) == 1:
                return named[0]
        raise BadCall(f"no object {json.dumps(recorded)}")

    def is_object(self, value: object) -> bool:
        try:
            return bool(self.object(value, False))
        except BadCall:
            return False

    def _feature(self, value: object) -> str:
        feature = VOCABULARY["features"].get(words_of(value)) if isinstance(value, str) else None
        if feature is None:
            raise BadCall(f"no feature {json.dumps(value)}")
        if feature not in self._features:
            raise BadCall(f"the room has no {feature}")
        return feature

    def _zone(self, value: object) -> str:
        def bare(name: str) -> str:
            """Without the words that only say that it is a zone."""
            return " ".join(word for word in words_of(name).split() if word not in VOCABULARY["zone_words"])

        if isinstance(value, str):
            same = [zone["id"] for zone in self._zones if words_of(zone["name"]) == words_of(value)]
            alike = [zone["id"] for zone in self._zones if bare(value) and bare(zone["name"]) == bare(value)]
            if same or len(alike) == 1:
                return (same or alike)[0]
        raise BadCall(f"no zone {json.dumps(value)}")

    def read(self, name: str, kind: str, value: object, subject: str) -> object:
        """The value for a parameter; None when it is left to its default. `subject` is the call's first object, whose
        proportions say which sides are its long ones."""
        if kind == "_" or value is None:
            if kind in "oizfL":
                raise BadCall(f"{name} is not given")
            return None
        if kind == "n":
            if not _is_number(value):
                raise BadCall(f"{name} is {json.dumps(value)}, not a number")
            return float(value)
        if kind == "b":
            return value is True
        if kind == "L":
            if not isinstance(value, list):
                raise BadCall(f"{json.dumps(value)} is not a list of objects")
            return list(dict.fromkeys(self.object(item, False) for item in value))
        if kind in "sS":
            made = self._objects.get(subject)
            sides = sides_of(value, made is None or made["width_m"] >= made["depth_m"])
            # "At its sides" where one side is asked for leaves the side open.
            return (sides or None) if kind == "S" else sides[0] if len(sides) == 1 else None
        if kind == "c":
            if value not in VOCABULARY["corners"] if isinstance(value, str) else True:
                raise BadCall(f"unknown corner {json.dumps(value)}")
            return VOCABULARY["corners"][value]
        if kind == "z":
            return self._zone(value)
        return self._feature(value) if kind == "f" else self.object(value, kind == "i")


def _value_json(value: object) -> dict:
    if isinstance(value, bool):
        return {"flag": value}
    if isinstance(value, list):
        return {"texts": {"items": value}}
    return {"number": value} if isinstance(value, float) else {"text": value}


def _assign(record: object) -> tuple[str, list]:
    """The function's name, and the value of each of its parameters, None for those that are not given."""
    if not isinstance(record, dict) or not isinstance(record.get("function"), str):
        raise BadCall('not a call; should be {"function": NAME, "args": [...], "kwargs": {...}}')
    name = canonical(record["function"])
    if not name:
        raise BadCall(f"unknown function {record['function']}")
    function, arguments = FUNCTIONS[name], record.get("args", [])
    if not isinstance(arguments, list):
        raise BadCall("args is not a list")
    arguments = list(arguments)
    # A lone number after the object is the distance, whatever stands between.
    for i, (_, kind) in enumerate(function.parameters[1:], 1):
        if i < len(arguments) and kind in "sS" and _is_number(arguments[i]):
            arguments.insert(i, None)
    count = len(function.parameters)
    if len(arguments) > count and not function.ignores_others:
        raise BadCall(f"{len(arguments)} arguments, at most {count} are known")
    values = (arguments + [None] * count)[:count]
    keywords = record.get("kwargs", {})
    for keyword, value in (keywords.items() if isinstance(keywords, dict) else []):
        position = function.position_of(keyword)
        if position >= 0:
            values[position] = value
        elif not function.ignores_others:
            raise BadCall(f"unknown keyword {keyword}")
    return name, values


def _reinterpret(name: str, values: list, arguments: Arguments) -> tuple[str, list]:
    """What the call says when its second argument is a wall, or a piece of furniture in place of a door or window."""
    second = values[1] if len(values) > 1 and isinstance(values[1], str) else ""
    wall, furniture = words_of(second) in ("wall", "walls"), bool(second) and arguments.is_object(second)
    become = {("io_next_to", wall): ("ind_next_to_wall", [0, 2]),
              ("ind_away_from_fixed_object", wall): ("ind_not_against_wall", [0, 2]),
              ("ind_away_from_fixed_object", furniture and not wall): ("io_away_from", [0, 1, 2]),
              ("ind_close_to_fixed_object", wall): ("ind_near_wall", [0, 2, 3]),
              ("ind_close_to_fixed_object", furniture and not wall): ("io_near", [0, 1, 3])}.get((name, True))
    if become is None:
        return name, values
    other, taken = become
    count = len(FUNCTIONS[other].parameters)
    return other, ([values[i] for i in taken] + [None] * count)[:count]


def read_call(record: object, graph: dict) -> list[dict]:
    """One recorded call as edges without ids; more than one when it names several partners at once."""
    arguments = Arguments(graph)
    name, values = _reinterpret(*_assign(record), arguments)
    partners = values[1] if name in ("io_away_from", "io_near") else None
    several = isinstance(partners, list) and len(partners) > 1
    edges = []
    for one in ([[values[0], partner, *values[2:]] for partner in partners] if several else [values]):
        made: list[dict] = []
        for (parameter, kind), value in zip(FUNCTIONS[name].parameters, one):
            subject = made[0]["value"].get("text", "") if made else ""
            read = arguments.read(parameter, kind, value, subject)
            if read is not None:
                made.append({"name": parameter, "value": _value_json(read)})
        edges.append({"type": FUNCTIONS[name].type, "arguments": made, "weight": 1})
    return edges


def call_text(call: object) -> str:
    """As a model would write it: "io_near(3, 1, max_dist=0.5)"."""
    if not isinstance(call, dict) or not isinstance(call.get("function"), str):
        return json.dumps(call)
    arguments, keywords = call.get("args", []), call.get("kwargs", {})
    parts = [json.dumps(value) for value in (arguments if isinstance(arguments, list) else [])]
    parts += [f"{name}={json.dumps(value)}" for name, value in (keywords.items() if isinstance(keywords, dict) else [])]
    return f"{call['function']}({', '.join(parts)})"
