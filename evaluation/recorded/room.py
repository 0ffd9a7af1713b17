# SPDX-License-Identifier: GPL-3.0-or-later
"""A room that was recorded when the paper's authors designed it with a model: what the model was asked for, room and
objects as numbers, its calls, and the texts that it wrote."""

import hashlib
import json
import re
from dataclasses import dataclass, field

from names import LISTS, Thing, keys_of
from problem import BadProblem, read_graph

_LARGEST_FILE = 10_000_000


class BadRoom(Exception):
    """A file that is no recorded room; names the field."""


@dataclass
class Call:
    """A call that the recorded model translated a sentence of its own to, in today's words."""

    function: str
    # In order, each with its values.
    arguments: list[tuple[str, list[str]]]

    def values(self) -> list[str]:
        return [value for _, values in self.arguments for value in values]


@dataclass
class Room:
    brief: str
    # Of the file, 8 hex digits.
    digest: str
    width_m: float
    depth_m: float
    openings: list[dict]
    sockets: list[dict]
    # Names by id, in order.
    zones: dict[str, str]
    things: list[Thing]
    calls: list[Call]
    # By name: "primary_intra", "secondary_inter_clean" and so on.
    texts: dict[str, str] = field(default_factory=dict)

    @property
    def floor(self) -> list[Thing]:
        """What is no tertiary."""
        return [thing for thing in self.things if thing.role != "tertiary"]

    @property
    def tertiaries(self) -> list[Thing]:
        return [thing for thing in self.things if thing.role == "tertiary"]


def is_rug(name: str) -> bool:
    keys = keys_of(name)
    return bool(keys) and keys[-1] in LISTS["rugs"] and keys[0] not in LISTS["before other rugs"]


def _values(value: dict) -> list[str]:
    if "texts" in value:
        return value["texts"].get("items", [])
    if "number" in value:
        return [f"{value['number']:g}"]
    return ["true" if value["flag"] else "false"] if "flag" in value else [value.get("text", "")]


def _things(graph: dict) -> list[Thing]:
    return [Thing(made["id"], made["name"], made["role"].removeprefix("OBJECT_ROLE_").lower(),
                  made["kind"].removeprefix("OBJECT_KIND_").lower(), made.get("zone_id", ""), made["width_m"],
                  made["depth_m"]) for made in graph["object_list"]["objects"]]


def _calls(graph: dict) -> list[Call]:
    return [Call(edge["type"], [(one["name"], _values(one["value"])) for one in edge.get("arguments", [])])
            for edge in graph.get("edges", [])]


def read_problem(content: bytes) -> dict:
    """The file's JSON, with a prompt and texts."""
    if len(content) > _LARGEST_FILE:
        raise BadRoom(f"has {len(content)} bytes; at most {_LARGEST_FILE}")
    try:
        problem = json.loads(content)
    except ValueError as error:
        raise BadRoom(str(error)) from error
    if not isinstance(problem, dict) or not isinstance(problem.get("prompt"), str) or not problem["prompt"].strip():
        raise BadRoom("prompt: should be the text that the model was asked with")
    if not isinstance(problem.get("language"), dict):
        raise BadRoom("language: should be an object with the texts that the model wrote")
    for name, text in problem["language"].items():
        if text is not None and not isinstance(text, str):
            raise BadRoom(f"language.{name}: should be text")
    return problem


def read_room(content: bytes) -> Room:
    """The room that a file holds."""
    problem = read_problem(content)
    try:
        graph = read_graph(content.decode("utf-8", "replace"))
    except BadProblem as error:
        raise BadRoom(error.args[0]) from error
    far = graph["room"]["floor"]["vertices"][2]
    room = Room(re.sub(r"\s", " ", problem["prompt"]).strip(), hashlib.sha256(content).hexdigest()[:8], far["x_m"],
                far["y_m"], graph["room"].get("openings", []), graph["room"].get("sockets", []),
                {zone["id"]: zone["name"] for zone in graph["zone_plan"].get("zones", [])}, _things(graph),
                _calls(graph), {name: text for name, text in problem["language"].items() if text})
    if not room.floor:
        raise BadRoom("primary: names no object")
    if not room.zones:
        raise BadRoom("zones: names no zone")
    return room
