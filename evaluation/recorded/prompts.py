# SPDX-License-Identifier: GPL-3.0-or-later
"""What the prompts of a design list, read back: who answers from a recording has to name objects and sentences by the
ids that the prompts use."""

import json
import re
from dataclasses import dataclass

from names import Thing, name_key

_ID = r"[^\s:,()]+"
# "- chair_1 to chair_4, together chair (dining): 0.45 x 0.5 x 0.9 m", with a star behind the names of primaries.
_STEP_LINE = re.compile(rf"- ({_ID}?)(?: to ({_ID}), together (.+?))?\*? \((.*?)\): ([\d.]+) x ([\d.]+) x ")
# "- chair_1, chair_2: "dining chair", 0.45 x 0.5, dining, on a wall"
_TRANSLATION_LINE = re.compile(rf'- ({_ID}(?:, {_ID})*): (?:"(.*?)", )?([\d.]+) x ([\d.]+), ([^,]+)')
_SENTENCE_LINE = re.compile(r'- (\S+) (".*")$')
_MOST_OF_A_GROUP = 200


@dataclass
class Listed:
    """A line of a prompt: equal objects."""

    # In order.
    ids: list[str]
    # What all of them are called together; the id of a single one.
    group: str
    # As the prompt or, where it does not tell it, the id has it.
    name: str
    zone: str
    width_m: float
    depth_m: float


@dataclass
class Asked:
    """A sentence of a prompt, with the ids in the heading above it."""

    id: str
    subjects: list[str]
    text: str


def without_number(name: str) -> str:
    """"dining_chair_3" is "dining_chair"."""
    return re.sub(r"(?<=.)_\d+$", "", name)


def _ids(first: str, last: str | None) -> list[str]:
    if last is None:
        return [first]
    base, numbers = without_number(last), [re.search(r"\d*$", name)[0] for name in (first, last)]
    if base == last or not numbers[0]:
        return []
    end = min(int(numbers[1]), int(numbers[0]) + _MOST_OF_A_GROUP)
    return [first, *(f"{base}_{number}" for number in range(int(numbers[0]) + 1, end + 1))]


def _read_listed(line: str) -> Listed | None:
    step = _STEP_LINE.match(line)
    if step:
        first, last, group, zone, width, depth = step.groups()
        ids = _ids(first, last)
        return Listed(ids, group or first, ids[0], zone, float(width), float(depth)) if ids else None
    translation = _TRANSLATION_LINE.match(line)
    if translation:
        names, name, width, depth, zone = translation.groups()
        ids = names.split(", ")
        return Listed(ids, ids[0], name or without_number(ids[0]), "" if zone == "no zone" else zone, float(width),
                      float(depth))
    return None


def read_listed(prompt: str) -> list[Listed]:
    return [listed for line in prompt.split("\n") if (listed := _read_listed(line))]


def read_asked(prompt: str) -> list[Asked]:
    asked, subjects = [], []
    for line in prompt.split("\n"):
        heading, sentence = re.fullmatch(r"\[(.*)\]", line), _SENTENCE_LINE.match(line)
        if heading:
            subjects = heading[1].split(", ") if heading[1] else []
        elif sentence:
            asked.append(Asked(sentence[1], subjects, json.loads(sentence[2])))
    return asked


class PromptIds:
    """How a prompt calls things: by name, zone and size, equal ones in their order; then, if `loosely`, by name alone,
    since sizes may have been mended. A thing that the prompt does not list was left out since."""

    def __init__(self, things: list[Thing], listed: list[Listed], loosely: bool = False) -> None:
        self._listed = listed
        self._places: list[tuple[int, str] | None] = [None] * len(things)
        free = [list(line.ids) for line in listed]
        for by_name in (False, True) if loosely else (False,):
            for i, thing in enumerate(things):
                for g, line in enumerate(listed):
                    if self._places[i] is None and free[g] and name_key(line.name) == thing.key and (
                            by_name or _same_size_and_zone(line, thing)):
                        self._places[i] = (g, free[g].pop(0))

    def id_of(self, thing: int) -> str:
        """Empty when it is not listed."""
        place = self._places[thing]
        return place[1] if place else ""

    def names_of(self, things: list[int]) -> list[str]:
        """Names that together mean the things: a group's when it is meant whole, else ids."""
        places = [place for thing in things if (place := self._places[thing])]
        groups = [group for group, _ in places]
        names = []
        for group, name in places:
            line = self._listed[group]
            names.append(line.group if groups.count(group) == len(line.ids) else name)
        return list(dict.fromkeys(names))


def _same_size_and_zone(line: Listed, thing: Thing) -> bool:
    # Prompts round to centimetres.
    near = abs(line.width_m - thing.width_m) < 0.006 and abs(line.depth_m - thing.depth_m) < 0.006
    return near and (thing.role == "tertiary" or line.zone == thing.zone)
