# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of layouts of one recorded room, ours and its authors', and what judges said of them."""

import copy
import json
import math
import random
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

OURS, RECORDED = "ours", "recorded"
ANSWERS = ("left", "right", "equal")


class BadPairs(Exception):
    """A file that is not as it should be."""


def read_json(path: Path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise BadPairs(f"{path}: {error}") from error


def _poses(room: dict) -> dict[str, list[float]]:
    """The recorded pose of each piece by the id that `flair-dev import` gives it."""
    solution, poses = room["solution"], {}
    for role in ("primary", "secondary"):
        for piece, pose in zip(room[role], solution[role], strict=True):
            poses[f"floor_{piece['index']}"] = pose
    for piece, pose in zip(room["tertiary"], solution["tertiary"], strict=True):
        poses[f"item_{piece['index']}"] = pose
    return poses


def recorded_layout(ours: dict, room: dict) -> dict:
    """Our layout artifact with the poses that the room's authors recorded; heights stay as ours are.

    Raises BadPairs when a piece of ours has no recorded pose.
    """
    layout = copy.deepcopy(ours)
    poses = _poses(room)
    for placement in layout["solved_layout"]["placements"]:
        pose = poses.get(placement["object_id"])
        if pose is None:
            raise BadPairs(f"{room.get('name', 'room')}: no recorded pose of {placement['object_id']}")
        placement["x_m"], placement["y_m"], theta_rad = pose
        # Recorded headings are what the authors' solver ended with: 94.2 instead of 0.
        placement["theta_rad"] = theta_rad % math.tau
    return layout


def deal_sides(names: list[str], seed: int) -> dict[str, dict[str, str]]:
    """Which of the two is on which side of each room's pair: by chance, but the same for a seed."""
    chance = random.Random(seed)
    key = {}
    for name in sorted(names):
        sides = [OURS, RECORDED]
        chance.shuffle(sides)
        key[name] = dict(zip(("left", "right"), sides, strict=True))
    return key


@dataclass(frozen=True)
class Tally:
    """Answers by what was chosen, and rooms by the majority of their judges."""

    answers: Counter
    rooms: Counter
    verdicts: dict[str, Counter]


def count(key: dict, judgements: list[dict]) -> Tally:
    """Raises BadPairs for an answer about an unknown room, or that is none of left, right and equal."""
    verdicts: dict[str, Counter] = {}
    for judgement in judgements:
        room, answer = judgement.get("room"), judgement.get("answer")
        if room not in key:
            raise BadPairs(f"room {room!r} is not in the key")
        if answer not in ANSWERS:
            raise BadPairs(f"{room}: answer {answer!r}; one of {', '.join(ANSWERS)} would be right")
        verdicts.setdefault(room, Counter())[key[room].get(answer, answer)] += 1
    rooms = Counter()
    for votes in verdicts.values():
        difference = votes[OURS] - votes[RECORDED]
        rooms[OURS if difference > 0 else RECORDED if difference < 0 else "equal"] += 1
    return Tally(sum(verdicts.values(), Counter()), rooms, verdicts)


def text(tally: Tally) -> str:
    """A table: a line a room, then the sums."""
    lines = [f"{'room':<28}{'ours':>6}{'recorded':>10}{'equal':>7}"]
    for room, votes in [*sorted(tally.verdicts.items()), ("all answers", tally.answers), ("rooms", tally.rooms)]:
        lines.append(f"{room:<28}{votes[OURS]:>6}{votes[RECORDED]:>10}{votes['equal']:>7}")
    return "\n".join(lines) + "\n"
