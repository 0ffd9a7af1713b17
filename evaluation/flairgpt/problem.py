# SPDX-License-Identifier: GPL-3.0-or-later
"""Recorded problems of the paper's released implementation as graphs of ours, and layouts as its judge reads them.

A problem is a JSON file with room, fixed objects, zones, objects and constraint calls. Calls that name absent objects,
features or functions become diagnostics, as the recording is a model's and models err; heights, which it lacks, take
one plausible value per kind."""

import json
import math
import re

from calls import LARGEST_INDEX, VOCABULARY, BadCall, call_text, object_id, read_call

# Furniture stands higher than a window sill and lower than what hangs on walls.
_ROOM_HEIGHT_M, _FURNITURE_M, _WALL_BOTTOM_M, _WALL_PIECE_M, _LAMP_M, _ITEM_M = 3, 1, 1.4, 0.5, 0.5, 0.3
_RUG_M, _SILL_M, _HEAD_M = 0.01, 0.9, 2.1
# A thing on a table that covers half a square metre lies flat: a blanket, a cutting mat.
_CLOTH_M2, _CLOTH_M = 0.5, 0.02
# Things recorded without a size.
_LEAST_EXTENT_M = 0.05
_MOST_FAULTS, _LONGEST_VALUE = 5, 60
_ROLES = ("primary", "secondary", "tertiary")


class BadProblem(Exception):
    """Text that is no recorded problem: up to five faults, each as field, value and what would be right."""

    def __str__(self) -> str:
        return f"not a recorded FlairGPT problem: {self.args[0]}"


class _Checker:
    """Holds a problem against the rules of vocabulary.json: what a field is, whether it must be there, what would be
    right, and the same of its fields or elements. What its calls say is not looked at: a model wrote them."""

    def __init__(self) -> None:
        self.faults: list[str] = []
        self._indices: set[tuple[str, float]] = set()

    def _holds(self, value: object, rule: dict) -> bool:
        kind, is_number = rule["is"], isinstance(value, (int, float)) and not isinstance(value, bool)
        types = {"object": dict, "list": list, "text": str}
        if kind in types:
            return isinstance(value, types[kind])
        if kind == "metres":
            return is_number and value <= rule["most"] and (value > 0 or (rule["zero"] and value == 0))
        if kind == "wall":
            return not isinstance(value, str) or value in ("south", "east", "north", "west")
        if not is_number or not 0 <= value <= LARGEST_INDEX or value != math.floor(value):
            return False
        if (kind, value) in self._indices:
            return False
        self._indices.add((kind, value))
        return True

    def check(self, value: object, path: str, rule: dict) -> None:
        if not self._holds(value, rule):
            text = json.dumps(value)
            shown = text if len(text) <= _LONGEST_VALUE else text[:_LONGEST_VALUE] + "..."
            self.faults.append(f"{path}: {shown} should be {rule['right']}")
            return
        if "fields" in rule:
            self.check_fields(value, f"{path}.", rule["fields"])
        for i, element in enumerate(value if "each" in rule else []):
            self.check(element, f"{path}[{i}]", rule["each"])

    def check_fields(self, value: dict, path: str, rules: dict) -> None:
        for name, rule in rules.items():
            if name in value:
                self.check(value[name], path + name, rule)
            elif rule.get("required"):
                self.faults.append(f"{path}{name}: is missing; should be {rule['right']}")


def parse(text: str) -> dict:
    """The text as a problem whose fields are what they should be."""
    def refuse(constant: str) -> None:
        raise json.JSONDecodeError(f"{constant} is no number", text, text.index(constant))

    try:
        problem = json.loads(text, parse_constant=refuse)
    except json.JSONDecodeError as error:
        raise BadProblem(f"not JSON: parse error at line {error.lineno}, column {error.colno}: {error.msg}") from error
    except RecursionError as error:
        raise BadProblem("not JSON: nested too deep") from error
    if not isinstance(problem, dict):
        raise BadProblem(f"{json.dumps(problem)[:_LONGEST_VALUE]} is not an object")
    checker = _Checker()
    checker.check_fields(problem, "", VOCABULARY["problem"])
    if checker.faults:
        raise BadProblem("; ".join(checker.faults[:_MOST_FAULTS]))
    return problem


def _is_rug(name: str) -> bool:
    return any(word in VOCABULARY["rug_words"] for word in re.findall("[a-z]+", name.lower()))


def _add_opening(opening: dict, openings: list[dict]) -> None:
    """Models put windows over each other and over doors: windows that overlap become one, a window gives way to a
    door."""
    low, high = opening["offset_m"], opening["offset_m"] + opening["width_m"]
    window, i = opening["kind"] == "OPENING_KIND_WINDOW", 0
    while i < len(openings):
        other = openings[i]
        other_low, other_high = other["offset_m"], other["offset_m"] + other["width_m"]
        i += 1
        if other["wall"] != opening["wall"] or high <= other_low or other_high <= low:
            continue
        if other["kind"] != "OPENING_KIND_WINDOW":
            low, high = (low, other_low) if low < other_low else (other_high, high)
            continue
        i -= 1
        del openings[i]
        if window:
            low, high = min(low, other_low), max(high, other_high)
        else:
            begin, end = (other_low, low) if other_low < low else (high, other_high)
            rest = other | {"offset_m": begin, "width_m": end - begin}
            if rest["width_m"] > 0.1:
                openings.append(rest)
    if high - low >= 0.1:
        openings.append(opening | {"offset_m": low, "width_m": high - low})


def _add_feature(feature: dict, number: int, problem: dict, room: dict) -> None:
    """`number` counts the features: what merges leaves its id unused."""
    wall, position = feature.get("wall"), feature.get("position")
    if not isinstance(wall, str) or not isinstance(position, (int, float)) or isinstance(position, bool):
        return
    wall_m = problem["room"]["width" if wall in ("south", "north") else "length"]
    size_m = min(feature.get("width", 0), wall_m)
    low = position * (wall_m - size_m)
    # Recorded from the west or south end; walls here run counter-clockwise.
    offset = max(0.0, low if wall in ("south", "east") else wall_m - low - size_m)
    word = feature.get("kind", "").lower()
    if word.startswith("window"):
        _add_opening({"id": f"window_{number}", "kind": "OPENING_KIND_WINDOW", "wall": wall, "offset_m": offset,
                      "width_m": size_m, "sill_height_m": _SILL_M, "head_height_m": _HEAD_M}, room["openings"])
    elif word.startswith("door") or word == "entrance":
        # The recorded hinge is the end at which the wall, walked counter-clockwise, begins.
        leaf = {"hinge": "HINGE_SIDE_START", "swing": "DOOR_SWING_INWARD", "swing_angle_rad": math.pi / 2}
        _add_opening({"id": f"door_{number}", "kind": "OPENING_KIND_DOOR", "wall": wall, "offset_m": offset,
                      "width_m": size_m, "head_height_m": _HEAD_M, "leaf": leaf}, room["openings"])
    else:
        room["sockets"].append({"id": f"socket_{len(room['sockets']) + 1}", "wall": wall,
                                "offset_m": offset + size_m / 2, "height_m": 0.3})


def _room(problem: dict) -> dict:
    width, length = problem["room"]["width"], problem["room"]["length"]
    corners = [(0, 0), (width, 0), (width, length), (0, length)]
    room = {"room_type": "room", "title": problem.get("prompt", problem.get("name", "")),
            "floor": {"vertices": [{"x_m": x, "y_m": y} for x, y in corners]},
            "walls": [{"name": name} for name in ("south", "east", "north", "west")], "height_m": _ROOM_HEIGHT_M,
            "openings": [], "sockets": []}
    for number, feature in enumerate(problem.get("fixed_objects", []), 1):
        _add_feature(feature, number, problem, room)
    return room


def _zone_id(name: str) -> str:
    return "".join(c.lower() if c.isascii() and c.isalnum() else "_" for c in name)


def _object(record: dict, role: str) -> dict:
    tertiary = role == "tertiary"
    kind = record["type"] if tertiary and isinstance(record.get("type"), str) else "floor"
    rug = kind == "floor" and _is_rug(record["name"])
    made = {"id": object_id(tertiary, int(record["index"])), "name": record["name"],
            "role": f"OBJECT_ROLE_{role.upper()}", "kind": "OBJECT_KIND_FLOOR",
            "width_m": max(_LEAST_EXTENT_M, record["width"]), "depth_m": max(_LEAST_EXTENT_M, record["length"]),
            "height_m": _RUG_M if rug else _FURNITURE_M}
    if not tertiary:
        made["zone_id"] = _zone_id(record.get("zone", ""))
    if rug:
        made["walk_over"] = True
    if kind == "wall":
        made |= {"kind": "OBJECT_KIND_WALL", "elevation_m": _WALL_BOTTOM_M, "height_m": _WALL_PIECE_M}
    elif kind == "ceiling":
        made |= {"kind": "OBJECT_KIND_CEILING", "elevation_m": _ROOM_HEIGHT_M - _LAMP_M, "height_m": _LAMP_M}
    elif kind == "table":
        flat = made["width_m"] * made["depth_m"] >= _CLOTH_M2
        made |= {"kind": "OBJECT_KIND_SURFACE", "height_m": _CLOTH_M if flat else _ITEM_M}
    return made


def _add_calls(calls: list, graph: dict) -> None:
    for call in calls:
        try:
            edges = read_call(call, graph)
        except BadCall as error:
            message = f"{call_text(call)}: {error}"
            # Recordings repeat the calls of their zones for all of them.
            if all(other["message"] != message for other in graph["diagnostics"]):
                graph["diagnostics"].append({"severity": "SEVERITY_WARNING", "code": "unusable_call",
                                             "message": message})
            continue
        for edge in edges:
            if all({name: value for name, value in other.items() if name != "id"} != edge for other in graph["edges"]):
                graph["edges"].append(edge | {"id": f"e{len(graph['edges']) + 1}"})


def _graph(problem: dict) -> dict:
    objects = [_object(record, role) for role in _ROLES for record in problem.get(role, [])]
    graph = {"room": _room(problem), "zone_plan": {"zones": [{"id": _zone_id(name), "name": name}
                                                             for name in problem.get("zones", [])]},
             "object_list": {"objects": objects}, "edges": [], "diagnostics": []}
    calls = problem["calls"]
    _add_calls(calls.get("primary", []), graph)
    for zone in calls.get("secondary", []):
        _add_calls(zone.get("calls", []) if isinstance(zone, dict) else [], graph)
    _add_calls(calls.get("secondary_all", []) + calls.get("tertiary", []), graph)
    return graph


def read_graph(text: str) -> dict:
    """The problem as a LayoutGraph in the form of its JSON. Object ids are "floor_INDEX" and "item_INDEX"."""
    problem = parse(text)
    try:
        return _graph(problem)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise BadProblem(f"{type(error).__name__}: {error}") from error


def read_placements(text: str) -> list[dict] | None:
    """The layout that was recorded with a problem, by the released implementation; None when it has none, or not all of
    one."""
    problem, placements = json.loads(text), []
    for role in _ROLES:
        records, solution = problem.get(role, []), problem.get("solution")
        poses = solution.get(role, []) if isinstance(solution, dict) else None
        if not isinstance(poses, list) or len(poses) != len(records):
            return None
        for record, pose in zip(records, poses):
            if not isinstance(pose, list) or len(pose) < 3:
                return None
            if not all(isinstance(one, (int, float)) for one in pose[:3]):
                return None
            placements.append({"object_id": object_id(role == "tertiary", int(record["index"])), "x_m": pose[0],
                               "y_m": pose[1], "theta_rad": _wrapped(pose[2])})
    return placements


def _wrapped(theta_rad: float) -> float:
    """In [0, 2 pi). Recorded headings are what the authors' solver ended with: 94.2 instead of 0."""
    turned = theta_rad - math.floor(theta_rad / math.tau) * math.tau
    return turned if 0 <= turned < math.tau else 0


def _index_of(name: str, otherwise: int) -> int:
    """The recording's index in an id; `otherwise` for the ids of graphs that were not imported."""
    found = re.fullmatch(r"(?:floor|item)_(\d{1,9})", name)
    return int(found[1]) if found else otherwise


def judge_layout(layout: dict, name: str, seconds: float) -> dict:
    """A SolvedLayout as the judge reads it. Objects keep the index that they were imported with; those of other graphs
    are numbered in their order, tertiaries by themselves."""
    placements = {placement["object_id"]: placement for placement in layout.get("placements", [])}
    counts, objects = {True: 0, False: 0}, []
    for made in layout["graph"]["object_list"].get("objects", []):
        role = made["role"].removeprefix("OBJECT_ROLE_").lower()
        index = _index_of(made["id"], counts[role == "tertiary"])
        counts[role == "tertiary"] += 1
        if made["id"] in placements:
            pose = placements[made["id"]]
            objects.append({"role": role, "index": index, "name": made["name"], "x": pose.get("x_m", 0),
                            "y": pose.get("y_m", 0), "theta": pose.get("theta_rad", 0), "width": made["width_m"],
                            "length": made["depth_m"]})
    return {"name": name, "seconds": seconds, "objects": objects}
