# SPDX-License-Identifier: GPL-3.0-or-later
"""The ranges that the comments of the protos state, by full name of the field without its package."""

from dataclasses import dataclass
from math import tau


@dataclass(frozen=True)
class Range:
    """Numbers from `least` to `most`; an end that is open does not belong to it."""

    least: float
    most: float
    open_least: bool = False
    open_most: bool = False

    def holds(self, value: float) -> bool:
        above = value > self.least if self.open_least else value >= self.least
        return above and (value < self.most if self.open_most else value <= self.most)

    def __str__(self) -> str:
        return f"{'(' if self.open_least else '['}{self.least:.17g}, {self.most:.17g}{')' if self.open_most else ']'}"


_SEED = Range(0, 2**53, open_most=True)
_EXTENT_M = Range(0, 20, open_least=True)
_FACTOR = Range(0, 1e9)
_COORDINATE_M = Range(-1000, 1000)
_LENGTH_M = Range(0, 100)

NUMBERS = {
    "Brief.seed": _SEED,
    "Room.height_m": Range(2, 12),
    "Opening.offset_m": _LENGTH_M,
    "Opening.width_m": Range(0, 100, open_least=True),
    "Opening.sill_height_m": _LENGTH_M,
    "Opening.head_height_m": Range(0, 12, open_least=True),
    "DoorLeaf.swing_angle_rad": Range(0, 3.141592653589794),
    "Socket.offset_m": _LENGTH_M,
    "Socket.height_m": Range(0, 12),
    "Object.width_m": _EXTENT_M,
    "Object.depth_m": _EXTENT_M,
    "Object.height_m": Range(0, 12, open_least=True),
    "Object.elevation_m": Range(0, 12),
    "Object.rim_sides_m": Range(0, 10),
    "Object.rim_ends_m": Range(0, 10),
    "Colour.red": Range(0, 255),
    "Colour.green": Range(0, 255),
    "Colour.blue": Range(0, 255),
    "Sentence.weight": Range(0, 10, open_least=True),
    "Measure.min_m": _LENGTH_M,
    "Measure.max_m": _LENGTH_M,
    "ConstraintEdge.weight": Range(0, 100, open_least=True),
    "Placement.x_m": _COORDINATE_M,
    "Placement.y_m": _COORDINATE_M,
    "Placement.z_m": _COORDINATE_M,
    "Placement.theta_rad": Range(0, tau, open_most=True),
    "SolveOptions.seed": _SEED,
    "SolveOptions.max_restart_count": Range(1, 10000),
    "SolveOptions.thread_count": Range(1, 256),
    "SolveOptions.path_width_m": Range(0, 2),
    "SolveOptions.variant_count": Range(1, 32),
    "Tolerances.relative": Range(0, 1e9, open_least=True),
    "Tolerances.absolute": Range(0, 1e9, open_least=True),
    "Tolerances.max_evaluation_count": Range(1, 100000),
    "Lambdas.door_overlap": _FACTOR,
    "Lambdas.wall_attraction_divisor": Range(0, 1e9, open_least=True),
    "Lambdas.no_overlap": _FACTOR,
    "Lambdas.balanced": _FACTOR,
    "Lambdas.in_bounds": _FACTOR,
    "Lambdas.zone": _FACTOR,
    "Lambdas.tertiary_in_bounds": _FACTOR,
    "Lambdas.on_wall": _FACTOR,
    "ModelBudget.call_count": Range(0, 100000),
    "ModelBudget.token_count": Range(0, 1e9),
    "ModelBudget.cost_usd": Range(0, 1e6),
}

# Characters of a text.
TEXTS = {
    "Brief.text": (1, 4000),
    "Room.room_type": (1, 200),
    "Room.title": (0, 4000),
    "Opening.description": (0, 2000),
    "Zone.name": (1, 100),
    "Zone.purpose": (0, 2000),
    "Object.name": (1, 200),
    "Object.description": (0, 4000),
    "Object.placement": (0, 4000),
    "Omission.name": (1, 1000),
    "Omission.reason": (1, 4000),
    "Sentence.text": (1, 4000),
    "Sentence.reason": (0, 4000),
    "StyleSheet.name": (0, 200),
    "StyleSheet.summary": (0, 4000),
    "Diagnostic.message": (1, 10000),
    "Finding.message": (1, 10000),
}

# Items of a repeated field.
COUNTS = {
    "Polygon.vertices": (3, 200),
    "Room.openings": (0, 100),
    "Room.sockets": (0, 200),
    "ZonePlan.zones": (1, 50),
    "ObjectList.objects": (1, 250),
    "ConstraintList.sentences": (0, 10000),
    "Meaning.facts": (0, 32),
    "Fact.movers": (0, 250),
    "Fact.targets": (0, 250),
    "Fact.others": (0, 250),
    "LayoutGraph.edges": (0, 4000),
}

# Names of 1 to 64 of a-z, 0-9 and "_" that no other item of the same list has.
IDS = {"Wall.name", "Opening.id", "Socket.id", "Zone.id", "Object.id", "Sentence.id", "ConstraintEdge.id",
       "ObjectStyle.subject_id", "Placement.object_id", "Argument.name"}

# Enums that may be left out.
OPTIONAL_ENUMS = {"SolveOptions.misfit_policy", "SolveOptions.groups", "DoorLeaf.hinge", "Sentence.origin",
                  "Fact.strength", "Participant.side"}

# Messages that are checked as if they were there when they are not.
REQUIRED = {"Room.floor", "LayoutGraph.room", "LayoutGraph.zone_plan", "LayoutGraph.object_list"}
