# SPDX-License-Identifier: GPL-3.0-or-later
"""A layout graph with its calls bound, and what poses cost in it: all that Evaluate needs."""

from collections.abc import Iterable

from flair import v1

from functions import SATISFIED_M2, Bound, Function, Poses, bind
from geometry import Pose
from scene import Scene
from terms import DEFAULT_PATH_WIDTH_M, FACTORS, Terms


class Problem:
    """A graph with its calls bound. What could not be bound is in `dropped`, by edge, with the reason."""

    def __init__(self, graph: v1.LayoutGraph, options: v1.SolveOptions, functions: dict[str, Function]) -> None:
        self.scene = Scene(graph)
        self.calls: dict[str, Bound] = {}
        self.dropped: dict[str, str] = {}
        for edge in graph.edges:
            bound = bind(edge, functions, self.scene)
            if isinstance(bound, Bound):
                self.calls[edge.id] = bound
            else:
                self.dropped[edge.id] = bound
        width = options.path_width_m if options.HasField("path_width_m") else DEFAULT_PATH_WIDTH_M
        self.terms = Terms(self.scene, list(self.calls.values()), width)

    def poses(self, placements: Iterable[v1.Placement]) -> Poses:
        """The poses of placements that were checked, by object; None for objects that have no placement."""
        poses: Poses = [None] * len(self.scene.objects)
        for item in placements:
            poses[self.scene.index[item.object_id]] = Pose(item.x_m, item.y_m, item.theta_rad)
        return poses

    def edge_outcomes(self, poses: Poses) -> list[v1.EdgeOutcome]:
        return [self._edge_outcome(edge, poses) for edge in self.scene.graph.edges]

    def _edge_outcome(self, edge: v1.ConstraintEdge, poses: Poses) -> v1.EdgeOutcome:
        outcome = v1.EdgeOutcome(edge_id=edge.id, status=v1.OutcomeStatus.OUTCOME_STATUS_DROPPED)
        call = self.calls.get(edge.id)
        missing = [] if call is None else [self.scene.objects[i].id for i in call.objects if poses[i] is None]
        if call is None or missing:
            outcome.reason = self.dropped[edge.id] if call is None else f'object "{missing[0]}" is not placed'
            return outcome
        outcome.cost = call.cost(self.scene, poses)
        outcome.weighted_cost = outcome.cost * edge.weight
        if outcome.cost <= SATISFIED_M2:
            outcome.status = v1.OutcomeStatus.OUTCOME_STATUS_SATISFIED
        else:
            outcome.status = v1.OutcomeStatus.OUTCOME_STATUS_VIOLATED
            outcome.reason = f'"{edge.type}" is not met: its cost is {outcome.cost:.3g} m2; at most {SATISFIED_M2:g} is'
        return outcome

    def term_outcomes(self, poses: Poses) -> list[v1.TermOutcome]:
        at = {i: self.terms.place(i, pose) for i, pose in enumerate(poses) if pose is not None and self.scene.stands(i)}
        costs = dict.fromkeys(FACTORS, 0.0)
        parts = [self.terms.of_one(i, at[i]) for i in at]
        parts += [self.terms.of_two(i, k, at[i], at[k]) for i in at for k in at if i < k]
        for term, cost in (item for part in parts for item in part.items()):
            costs[term] += cost
        return [v1.TermOutcome(term=term, cost=cost, factor=FACTORS[term]) for term, cost in costs.items()]
