# SPDX-License-Identifier: GPL-3.0-or-later
"""From a problem to a solved layout: restarts of the search, then what hangs and lies on things, then an account."""

import time
from collections.abc import Callable

from flair import v1

from annealing import Annealing, Outcome
from attaching import attach
from functions import Poses
from measures import measure
from problem import Problem
from remarks import remarks
from zones import zone_regions

DEFAULT_RESTART_COUNT = 3


def solve(problem: Problem, options: v1.SolveOptions, require_caller: Callable[[], None]) -> v1.SolveResponse:
    """The best of all restarts. `require_caller` raises when nobody waits for the answer any more."""
    scene, pinned = problem.scene, problem.poses(problem.scene.graph.pinned_placements)
    movable = [i for i in range(len(pinned)) if pinned[i] is None and scene.stands(i)]
    limit_s = options.time_limit.ToTimedelta().total_seconds() if options.HasField("time_limit") else None
    began_s = time.monotonic()

    def out_of_time() -> bool:
        require_caller()
        return limit_s is not None and time.monotonic() - began_s >= limit_s

    wanted = options.max_restart_count if options.HasField("max_restart_count") else DEFAULT_RESTART_COUNT
    outcomes: list[Outcome] = []
    while len(outcomes) < wanted and not (outcomes and outcomes[-1].stopped):
        seed = f"{options.seed} {len(outcomes)}"
        run = Annealing(scene, problem.terms, list(problem.calls.values()), pinned, movable, seed)
        outcomes.append(run.run(out_of_time))
    best = min(range(len(outcomes)), key=lambda k: (outcomes[k].cost, k))
    searched_s = time.monotonic()
    poses = attach(scene, outcomes[best].poses, require_caller)
    stages = [v1.StageOutcome(stage="primary", restart_count=len(outcomes), best_restart=best, seed=options.seed,
                              evaluation_count=sum(outcome.step_count for outcome in outcomes),
                              cost=outcomes[best].cost, stopped_early=outcomes[-1].stopped),
              v1.StageOutcome(stage="tertiary", restart_count=1, seed=options.seed)]
    response = v1.SolveResponse(solved_layout=_layout(problem, poses, stages, options))
    response.stage_durations.add().FromNanoseconds(int((searched_s - began_s) * 1e9))
    response.stage_durations.add().FromNanoseconds(int((time.monotonic() - searched_s) * 1e9))
    return response


def _layout(problem: Problem, poses: Poses, stages: list[v1.StageOutcome], options: v1.SolveOptions) -> v1.SolvedLayout:
    scene, edges, terms = problem.scene, problem.edge_outcomes(poses), problem.term_outcomes(poses)
    placements = [v1.Placement(object_id=item.id, x_m=pose.x_m, y_m=pose.y_m, z_m=scene.underside_m(i),
                               theta_rad=pose.heading_rad)
                  for i, (item, pose) in enumerate(zip(scene.objects, poses))]
    return v1.SolvedLayout(
        graph=scene.graph, placements=placements, zone_regions=zone_regions(scene, poses), edge_outcomes=edges,
        term_outcomes=terms, stage_outcomes=stages, metrics=measure(scene, poses),
        total_cost=sum(edge.weighted_cost for edge in edges) + sum(term.cost * term.factor for term in terms),
        diagnostics=list(remarks(problem, poses, stages, options)))
