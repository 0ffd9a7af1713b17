# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the parts of a message fit each other: what a number or a name alone does not show.

Requests, briefs, graphs and layouts name their parts alike (room, zone_plan, object_list ...), so one walk serves all.
"""

import math
from collections.abc import Iterable, Iterator
from typing import Any

from google.protobuf.message import Message

from flair import v1

Point = tuple[float, float]

_TOLERANCE_M = 1e-6
_PARENTS = ("brief", "layout_graph", "graph", "solved_layout", "options")
_PIN_MARGIN_M = 1.0


def broken_in(message: Message, path: str = "") -> Iterator[str]:
    """References that lead nowhere and shapes that close to nothing."""
    prefix = f"{path}." if path else ""
    names = message.DESCRIPTOR.fields_by_name
    has = {name for name in names if names[name].message_type is not None
           and names[name].label != names[name].LABEL_REPEATED and message.HasField(name)}
    for name in _PARENTS:
        if name in has:
            yield from broken_in(getattr(message, name), prefix + name)
        if name in has and name.endswith("graph") and "placements" in names:
            objects = [item.id for item in getattr(message, name).object_list.objects]
            yield from _placements(message.placements, objects, f"{prefix}placements")
    if "time_limit" in has and message.time_limit.ToNanoseconds() <= 0:
        yield f"{prefix}time_limit: {message.time_limit.ToJsonString()} is not a duration; more than 0 s"
    if isinstance(message, v1.Room):
        yield from _room(message, prefix)
    elif "room" in has:
        yield from _room(message.room, f"{prefix}room.")
    if "object_list" not in has:
        return
    objects = [item.id for item in message.object_list.objects]
    zones = [zone.id for zone in message.zone_plan.zones] if "zone_plan" in has else None
    yield from _objects(message.object_list, objects, zones, f"{prefix}object_list.objects")
    if "constraint_list" in has:
        for index, sentence in enumerate(message.constraint_list.sentences):
            at = f"{prefix}constraint_list.sentences[{index}].subject_ids"
            yield from _unknown(sentence.subject_ids, objects, "an object", at)
            named = [one.object_id for fact in sentence.meaning.facts for slot in (fact.movers, fact.targets, fact.others)
                     for one in slot if one.object_id]
            yield from _unknown(named, objects, "an object", f"{prefix}constraint_list.sentences[{index}].meaning")
    if isinstance(message, v1.LayoutGraph):
        yield from _graph(message, objects, prefix)


def _unknown(names: Iterable[str], known: list[str], what: str, at: str) -> Iterator[str]:
    for index, name in enumerate(names):
        if name not in known:
            yield f"{at}[{index}]: \"{name}\" is not {what} of this message"


def _objects(message: v1.ObjectList, ids: list[str], zones: list[str] | None, at: str) -> Iterator[str]:
    for index, item in enumerate(message.objects):
        standing = item.role in (v1.ObjectRole.OBJECT_ROLE_PRIMARY, v1.ObjectRole.OBJECT_ROLE_SECONDARY)
        if standing and item.kind not in (v1.ObjectKind.OBJECT_KIND_UNSPECIFIED, v1.ObjectKind.OBJECT_KIND_FLOOR):
            yield f"{at}[{index}].kind: primaries and secondaries stand on the floor"
        if standing and not item.zone_id:
            yield f"{at}[{index}].zone_id: is empty; every primary and secondary belongs to a zone"
        if item.zone_id and zones is not None and item.zone_id not in zones:
            yield f"{at}[{index}].zone_id: \"{item.zone_id}\" is not a zone of this message"
        if item.host_id and (item.host_id not in ids or item.host_id == item.id):
            yield f"{at}[{index}].host_id: \"{item.host_id}\" is not another object of this message"


def _placements(placements: Iterable[v1.Placement], objects: list[str], at: str) -> Iterator[str]:
    for index, placement in enumerate(placements):
        if placement.object_id not in objects:
            yield f"{at}[{index}].object_id: \"{placement.object_id}\" is not an object of this message"


def _graph(graph: v1.LayoutGraph, objects: list[str], prefix: str) -> Iterator[str]:
    sentences = [sentence.id for sentence in graph.constraint_list.sentences]
    for index, edge in enumerate(graph.edges):
        if edge.sentence_id and edge.sentence_id not in sentences:
            yield f"{prefix}edges[{index}].sentence_id: \"{edge.sentence_id}\" is not a sentence of this message"
    yield from _placements(graph.pinned_placements, objects, f"{prefix}pinned_placements")
    corners = graph.room.floor.vertices
    for index, pin in enumerate(graph.pinned_placements):
        for name, value in (("x_m", pin.x_m), ("y_m", pin.y_m)):
            most = max((getattr(corner, name) for corner in corners), default=0) + _PIN_MARGIN_M
            if not -_PIN_MARGIN_M <= value <= most:
                at = f"{prefix}pinned_placements[{index}].{name}"
                yield f"{at}: {value:.17g} is outside [{-_PIN_MARGIN_M}, {most:.17g}]"


def _room(room: v1.Room, prefix: str) -> Iterator[str]:
    corners = [(corner.x_m, corner.y_m) for corner in room.floor.vertices]
    if len(corners) < 3 or not all(map(math.isfinite, (value for corner in corners for value in corner))):
        return  # said already
    edges = list(zip(corners, corners[1:] + corners[:1]))
    if not _is_simple(edges):
        yield f"{prefix}floor: is not simple; no two edges may cross or touch but neighbours in their shared corner"
        return
    if sum(a[0] * b[1] - a[1] * b[0] for a, b in edges) <= 0:
        yield f"{prefix}floor: runs clockwise; must be counter-clockwise"
    for name, values in (("x_m", [x for x, _ in corners]), ("y_m", [y for _, y in corners])):
        if abs(min(values)) > _TOLERANCE_M or not 1 <= max(values) - min(values) <= 100:
            yield f"{prefix}floor: {name} is in [{min(values):.6g}, {max(values):.6g}]; must be in [0, 1 to 100]"
    if len(room.walls) != len(corners):
        yield f"{prefix}walls: has {len(room.walls)} walls for a floor of {len(corners)} edges; one per edge"
        return
    lengths = {wall.name: math.dist(*edge) for wall, edge in zip(room.walls, edges)}
    for index, opening in enumerate(room.openings):
        yield from _on_wall(opening, "width_m", lengths, f"{prefix}openings[{index}]")
        if opening.kind == v1.OpeningKind.OPENING_KIND_DOOR and not opening.HasField("leaf"):
            yield f"{prefix}openings[{index}].leaf: is not set; a door says how it opens"
        if opening.head_height_m <= opening.sill_height_m or opening.head_height_m > room.height_m:
            yield (f"{prefix}openings[{index}].head_height_m: {opening.head_height_m:.17g} is outside "
                   f"({opening.sill_height_m:.17g}, {room.height_m:.17g}]")
    for index, socket in enumerate(room.sockets):
        yield from _on_wall(socket, "offset_m", lengths, f"{prefix}sockets[{index}]")


def _is_simple(edges: list[tuple[Point, Point]]) -> bool:
    for i, (a, b) in enumerate(edges):
        if math.dist(a, b) < _TOLERANCE_M:
            return False
        for c, d in edges[i + 2 : len(edges) - (i == 0)]:  # the neighbours touch
            apart = any(max(a[k], b[k]) < min(c[k], d[k]) or max(c[k], d[k]) < min(a[k], b[k]) for k in (0, 1))
            crosses = _side(a, b, c) * _side(a, b, d) <= 0 and _side(c, d, a) * _side(c, d, b) <= 0
            if crosses and not apart:  # of two on one line only their extents say whether they touch
                return False
    return True


def _side(a: Point, b: Point, p: Point) -> float:
    """Positive when p is left of the line from a to b, negative when right."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _on_wall(item: Any, last: str, lengths: dict[str, float], at: str) -> Iterator[str]:
    """An opening or a socket; `last` is the field that decides where it ends along its wall."""
    if item.wall not in lengths:
        yield f"{at}.wall: \"{item.wall}\" is not a wall of this room; it has {', '.join(lengths)}"
        return
    before_m = item.offset_m if last == "width_m" else 0.0
    most = lengths[item.wall] - before_m
    if getattr(item, last) > most + _TOLERANCE_M:
        yield (f"{at}.{last}: {getattr(item, last):.17g} does not fit wall \"{item.wall}\" "
               f"({lengths[item.wall]:.6g} m from {before_m:.6g} m); at most {max(most, 0):.6g}")
