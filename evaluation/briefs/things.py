# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces a wish speaks of: names with `*`, or a group of names such as "@bed"."""

from fnmatch import fnmatchcase

from plan import Piece, Plan

GROUPS = {
    "@bed": ["*bed"],
    "@armchair": ["armchair", "recliner", "glider", "wing*chair", "lounge chair", "club chair", "easy chair"],
    "@sofa": ["*sofa", "loveseat"],
    "@chair": ["*chair*", "*stool"],
    "@lamp": ["*lamp*", "sconce", "lantern"],
    "@desk": ["*desk"],
    "@dining table": ["*dining table", "round table", "oval table", "square table", "trestle table", "drop-leaf table"],
    "@bookcase": ["*bookshelf*", "*bookcase*"],
    "@plant": ["*plant*"],
    "@lectern": ["lectern", "*podium"],
}
# Whatever stands on the floor and is not walked over.
STANDING = "@standing"
# What people sit on side by side, 0.6 m of width each.
LONG_SEATS = ["*sofa", "loveseat", "*bench", "*pew"]
SEATS = ["*chair*", "*stool", "recliner", "glider", "bean bag", "*seat"]
WORK_BENCHES = ["work*bench"]


def matches(name: str, patterns: list[str]) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in patterns)


def select(plan: Plan, selector: str | list[str]) -> list[Piece]:
    """Each piece once."""
    wanted = [selector] if isinstance(selector, str) else selector
    patterns = [pattern for one in wanted for pattern in GROUPS.get(one, [one])]
    return [piece for piece in plan.pieces
            if matches(piece.name, patterns) or STANDING in wanted and piece.kind == "floor" and not piece.walk_over]


def fault_of_selector(selector: object) -> str:
    """What is wrong with it; empty when nothing is."""
    wanted = [selector] if isinstance(selector, str) else selector
    if not isinstance(wanted, list) or not wanted or not all(isinstance(one, str) and one for one in wanted):
        return "is no name and no list of names, such as \"armchair\" or [\"*desk\"]"
    for one in wanted:
        if one.startswith("@") and one != STANDING and one not in GROUPS:
            return f"names the group {one}; known are {', '.join([STANDING, *GROUPS])}"
    return ""


def seat_count(plan: Plan) -> int:
    """Places for people to sit."""
    seats = 0
    for piece in plan.pieces:
        if matches(piece.name, LONG_SEATS) and not matches(piece.name, WORK_BENCHES):
            seats += max(1, int((piece.width_m + 1e-6) / 0.6))
        elif matches(piece.name, SEATS):
            seats += 1
    return seats
