# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person should know of a solve: what does not fit, what was not taken and what was not done as asked."""

from collections import Counter
from collections.abc import Iterator

from flair import v1

from attaching import collide
from functions import Poses
from geometry import common_m2, rectangle
from problem import Problem
from scene import Scene

# Less is rounding.
_LEAST_M2 = 1e-6
_IGNORED_OPTIONS = {
    "lambdas": "the terms of this optimizer have factors of their own",
    "tolerances": "its search takes a fixed number of steps",
    "find_contradictions": "it does not look for contradictions",
}


def remarks(
    problem: Problem, poses: Poses, stages: list[v1.StageOutcome], options: v1.SolveOptions
) -> Iterator[v1.Diagnostic]:
    yield from _misfits(problem.scene, poses)
    types = Counter(edge.type for edge in problem.scene.graph.edges if edge.id in problem.dropped)
    for name, count in types.items():
        reason = next(problem.dropped[edge.id] for edge in problem.scene.graph.edges
                      if edge.type == name and edge.id in problem.dropped)
        yield _remark(v1.Severity.SEVERITY_WARNING, "not_taken", f"{count} calls of {name} were not taken: {reason}")
    if any(stage.stopped_early for stage in stages):
        yield _remark(v1.Severity.SEVERITY_WARNING, "time_limit", "the time limit ended the search; the best so far")
    yield from _ignored(options)
    by_rule = [item.id for i, item in enumerate(problem.scene.objects) if not problem.scene.stands(i)]
    if by_rule:
        yield _remark(v1.Severity.SEVERITY_NOTE, "placed_by_rule",
                      f"{', '.join(by_rule)}: placed at what carries them, by fixed rules, after the search")
    yield _remark(v1.Severity.SEVERITY_NOTE, "not_measured",
                  "pathway_cost_m3 is not measured by this optimizer; its 0 means nothing")


def _remark(severity: int, code: str, message: str, subject_id: str = "") -> v1.Diagnostic:
    return v1.Diagnostic(severity=severity, code=code, message=message, subject_id=subject_id)


def _misfits(scene: Scene, poses: Poses) -> Iterator[v1.Diagnostic]:
    outlines = [rectangle(pose, item.width_m, item.depth_m) for pose, item in zip(poses, scene.objects)]
    for i, item in enumerate(scene.objects):
        wrongs = {f'overlaps "{scene.objects[k].id}"': common_m2(outlines[i], outlines[k])
                  for k in range(i) if collide(scene, i, k)}
        if scene.stands(i):
            wrongs["stands in the way of a door"] = max(
                (common_m2(outlines[i], area) for area in scene.door_areas), default=0.0)
        outside = item.width_m * item.depth_m - common_m2(scene.floor, outlines[i])
        wrongs["reaches out of the room"] = outside
        for wrong, area in wrongs.items():
            if area > _LEAST_M2:
                yield _remark(v1.Severity.SEVERITY_WARNING, "does_not_fit",
                              f'"{item.id}" ({item.width_m:.2f} m x {item.depth_m:.2f} m) {wrong} by {area:.3f} m2: '
                              "leave something out, take smaller pieces or more restarts", item.id)


def _ignored(options: v1.SolveOptions) -> Iterator[v1.Diagnostic]:
    reasons = [f"{name}: {reason}" for name, reason in _IGNORED_OPTIONS.items()
               if name in {field.name for field, _ in options.ListFields()}]
    if options.variant_count > 1:
        reasons.append(f"variant_count {options.variant_count}: it makes one layout")
    if options.misfit_policy == v1.MisfitPolicy.MISFIT_POLICY_LEAVE_OUT:
        reasons.append("misfit_policy LEAVE_OUT: it places all objects")
    for reason in reasons:
        yield _remark(v1.Severity.SEVERITY_NOTE, "option_ignored", f"options.{reason}")
