# SPDX-License-Identifier: GPL-3.0-or-later
"""Short texts about artifacts, for terminals and logs. `flair inspect` says more."""

import math
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

from google.protobuf.message import Message

from flair import v1


def inspect(message: Message) -> str:
    """A few lines about an artifact or about what one holds. A message without a form of its own says its kind."""
    return "\n".join(_lines(message))


def _lines(message: Message) -> Iterator[str]:
    if isinstance(message, v1.Artifact):
        kind = message.WhichOneof("content")
        producer = message.producer
        made = f"made by {producer.program} ({producer.method} {producer.version})".replace(" )", ")")
        yield f"{kind or 'empty artifact'} {message.id[:12]}, {made}"
        if kind:
            yield from _lines(getattr(message, kind))
        return
    yield from _FORMS.get(type(message), lambda other: [type(other).__name__])(message)


def _brief(brief: v1.Brief) -> Iterator[str]:
    yield f'"{brief.text}", seed {brief.seed}'


def _room(room: v1.Room) -> Iterator[str]:
    xs, ys = [p.x_m for p in room.floor.vertices], [p.y_m for p in room.floor.vertices]
    kinds = Counter(v1.OpeningKind.Name(item.kind).removeprefix("OPENING_KIND_").lower() for item in room.openings)
    yield f"{room.room_type}, {max(xs):.3g} m x {max(ys):.3g} m, {len(room.walls)} walls, {room.height_m:.3g} m high"
    yield ", ".join(f"{count} {kind}{'s' if count > 1 else ''}" for kind, count in kinds.items()) or "no openings"


def _zones(plan: v1.ZonePlan) -> Iterator[str]:
    for zone in plan.zones:
        yield f"{zone.id:16} {zone.purpose}"


def _objects(objects: v1.ObjectList) -> Iterator[str]:
    for item in objects.objects:
        role = v1.ObjectRole.Name(item.role).removeprefix("OBJECT_ROLE_").lower()
        size = f"{item.width_m:.2f} x {item.depth_m:.2f} x {item.height_m:.2f} m"
        yield f"{item.id:20} {role:10} {item.zone_id:14} {size}"
    for omission in objects.omissions:
        yield f"left out: {omission.name}: {omission.reason}"


def _style(sheet: v1.StyleSheet) -> Iterator[str]:
    yield f"{sheet.name}: {sheet.summary}"
    yield "colours: " + ", ".join(colour.name for colour in sheet.palette)


def _sentences(constraints: v1.ConstraintList) -> Iterator[str]:
    for sentence in constraints.sentences:
        yield f"{sentence.id:5} {sentence.text}"


def _graph(graph: v1.LayoutGraph) -> Iterator[str]:
    yield f"{len(graph.object_list.objects)} objects, {len(graph.edges)} calls of {graph.catalog_library}"
    for edge in graph.edges:
        yield f"{edge.id:5} {_call(edge)}"


def _call(edge: v1.ConstraintEdge) -> str:
    return f"{edge.type}({', '.join(f'{item.name}={_value(item.value)}' for item in edge.arguments)})"


def _value(value: v1.ArgumentValue) -> str:
    if value.WhichOneof("value") == "texts":
        return "+".join(value.texts.items)
    given: Any = getattr(value, value.WhichOneof("value") or "text")
    return f"{given:g}" if isinstance(given, float) else str(given)


def _layout(layout: v1.SolvedLayout) -> Iterator[str]:
    status = v1.OutcomeStatus
    counts = Counter(outcome.status for outcome in layout.edge_outcomes)
    yield (f"{len(layout.placements)} objects placed; {counts[status.OUTCOME_STATUS_SATISFIED]} constraints hold, "
           f"{counts[status.OUTCOME_STATUS_VIOLATED]} do not, {counts[status.OUTCOME_STATUS_DROPPED]} dropped")
    metrics = layout.metrics
    yield f"OOB {metrics.oob_percent:.3f} %, OOR {metrics.oor_percent:.3f} %, cost {layout.total_cost:.4g}"
    if metrics.use_count:
        yield f"{metrics.met_use_count} of {metrics.use_count} uses met"
    yield from (f"wrong: {finding.message}" for finding in metrics.findings
                if finding.kind != v1.FindingKind.FINDING_KIND_USE_NOT_MET)
    for place in layout.placements:
        turn_deg = math.degrees(place.theta_rad)
        yield f"{place.object_id:20} at {place.x_m:.2f}, {place.y_m:.2f} m, turned {turn_deg:.0f} deg"
    yield from (f"not met: {outcome.reason}" for outcome in layout.edge_outcomes if outcome.reason)


def _preview(preview: v1.Preview) -> Iterator[str]:
    name = v1.PreviewFormat.Name(preview.format).removeprefix("PREVIEW_FORMAT_")
    yield f"{name}, {preview.width_px} x {preview.height_px} px, {len(preview.image)} bytes"


def _report(report: v1.Report) -> Iterator[str]:
    counts = report.constraints
    yield (f"{counts.satisfied_count} constraints hold, {counts.violated_count} do not, "
           f"{counts.dropped_count} dropped, {counts.untranslated_count} sentences not translated")
    for timing in report.stage_timings:
        took_s = timing.duration.seconds + timing.duration.nanos * 1e-9
        yield f"{timing.stage:12} {took_s:.3f} s{' (reused)' if timing.reused else ''}"


_FORMS: dict[type[Message], Callable[[Any], Iterator[str]]] = {
    v1.Brief: _brief,
    v1.ConstraintList: _sentences,
    v1.LayoutGraph: _graph,
    v1.ObjectList: _objects,
    v1.Preview: _preview,
    v1.Report: _report,
    v1.Room: _room,
    v1.SolvedLayout: _layout,
    v1.StyleSheet: _style,
    v1.ZonePlan: _zones,
}
