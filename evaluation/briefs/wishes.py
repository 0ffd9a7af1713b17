# SPDX-License-Identifier: GPL-3.0-or-later
"""Briefs with their wishes, read from a file of JSON lines; every fault is told with file, line and field."""

import json
import re
from dataclasses import dataclass
from pathlib import Path

import checks
import things
from plan import Plan


class BadExam(Exception):
    """A file of briefs that cannot be used; says where and what would be right."""


@dataclass(frozen=True)
class Brief:
    id: str
    text: str
    wishes: list[checks.Wish]


@dataclass(frozen=True)
class Exam:
    """`misses_hidden`: whoever works on the designer does not look at what this set finds."""

    name: str
    briefs: list[Brief]
    misses_hidden: bool = False


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value >= 0


def _one_of(*allowed: str):
    right = f"one of {', '.join(allowed)} would be right"
    return lambda value: "" if value in allowed else f"is {json.dumps(value)}; {right}"


def _number(value: object) -> str:
    return "" if _is_number(value) else f"is {json.dumps(value)}; a number from 0 would be right"


def _flag(value: object) -> str:
    return "" if isinstance(value, bool) else f"is {json.dumps(value)}; true or false would be right"


def _text(value: object) -> str:
    return "" if isinstance(value, str) and value else f"is {json.dumps(value)}; a text would be right"


def _sides(value: object) -> str:
    good = isinstance(value, list) and len(value) == 2 and all(map(_is_number, value))
    return "" if good else f"is {json.dumps(value)}; two lengths such as [3, 5] would be right"


def _walls(value: object) -> str:
    good = isinstance(value, list) and value and all(one in checks.WALLS for one in value)
    return "" if good else f"is {json.dumps(value)}; a list of {', '.join(checks.WALLS)} would be right"


def _target(value: object) -> str:
    return "" if value in checks.OPENINGS else things.fault_of_selector(value)


def _ends(value: object) -> str:
    if not isinstance(value, list) or len(value) != 2:
        return f"is {json.dumps(value)}; two ends such as [\"sofa\", \"window\"] would be right"
    return next((fault for fault in map(_target, value) if fault), "")


_WALL = _one_of(*checks.WALLS, *checks.SIDES, "any", "longest")
_FAULTS = {"things": things.fault_of_selector, "text": _text, "number": _number, "sides": _sides, "walls": _walls,
           "target": _target, "ends": _ends, "wall": _WALL, "opening": _one_of(*checks.OPENINGS),
           "hand": _one_of(*checks.SIDES, "either")}
_OPTION_FAULTS = {"side": _one_of(*checks.SIDES), "opening": _one_of(*checks.OPENINGS), "back": _flag, "middle": _flag,
                  "widest": _flag, "each_other": _flag, "all": _flag}


def _fault_of_remark(words: object) -> str:
    good = isinstance(words, list) and words and all(isinstance(word, str) and word.strip() for word in words)
    return "" if good else f"is {json.dumps(words)}; a list of words that a remark on it would have would be right"


def fault_of_wish(wish: object) -> str:
    """What is wrong with it; empty when nothing is."""
    if not isinstance(wish, dict):
        return "is no object"
    check = checks.CHECKS.get(wish.get("check"))
    if check is None:
        return f"check is {json.dumps(wish.get('check'))}; one of {', '.join(checks.CHECKS)} would be right"
    faults = {"wish": _text, "remark": _fault_of_remark, **{name: _FAULTS[kind] for name, kind in check.fields.items()}}
    for name, fault_of in faults.items():
        fault = fault_of(wish[name]) if name in wish else "is missing"
        if fault:
            return f"{name} {fault}"
    bounds = checks.BOUNDS if check.counts else ()
    for name in wish.keys() - faults.keys() - {"check"}:
        if name not in check.options and name not in bounds:
            may = ", ".join([*faults, *check.options, *bounds])
            return f"{name} is no field of the check {wish['check']}; known are {may}"
        fault = _OPTION_FAULTS.get(name, _number)(wish[name])
        if fault:
            return f"{name} {fault}"
    if check.counts and wish["check"] in ("count", "seats") and not any(name in wish for name in checks.NUMBERS):
        return f"says no number; {', '.join(checks.NUMBERS)} would be right"
    return ""


def _read_brief(line: dict, where: str, known: set[str]) -> Brief:
    for name in ("id", "brief"):
        fault = _text(line.get(name))
        if fault:
            raise BadExam(f"{where}: {name} {fault}")
    if line["id"] in known:
        raise BadExam(f"{where}: id {line['id']} is that of an earlier brief")
    if not isinstance(line.get("wishes"), list) or not line["wishes"]:
        raise BadExam(f"{where}: wishes is {json.dumps(line.get('wishes'))}; a list of wishes would be right")
    for number, wish in enumerate(line["wishes"], 1):
        fault = fault_of_wish(wish)
        if fault:
            raise BadExam(f"{where}: wish {number}: {fault}")
    return Brief(line["id"], line["brief"], line["wishes"])


def read_exam(path: Path) -> Exam:
    """One brief a line; a first line with `set` names the set and says whether its misses are shown or hidden."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadExam(f"{path}: {error}") from error
    name, hidden = path.stem, False
    briefs: list[Brief] = []
    for number, text in enumerate(lines, 1):
        if not text.strip():
            continue
        where = f"{path}:{number}"
        try:
            line = json.loads(text)
        except json.JSONDecodeError as error:
            raise BadExam(f"{where}: {error.msg} at column {error.colno}; a JSON object would be right") from error
        if not isinstance(line, dict):
            raise BadExam(f"{where}: is no JSON object")
        if number == 1 and "set" in line:
            fault = _one_of("shown", "hidden")(line.get("misses", "shown"))
            if fault:
                raise BadExam(f"{where}: misses {fault}")
            name, hidden = line["set"], line.get("misses") == "hidden"
            continue
        briefs.append(_read_brief(line, where, {brief.id for brief in briefs}))
    if not briefs:
        right = '{"id": "d01", "brief": "...", "wishes": [...]}'
        raise BadExam(f"{path}: has no brief; a line such as {right} would be right")
    return Exam(name, briefs, hidden)


def remark_on(plan: Plan, wish: checks.Wish) -> str:
    """The first remark that has one of the wish's words, as a whole word or its plural; empty when none has."""
    words = "|".join(re.escape(word) for word in wish["remark"])
    pattern = re.compile(rf"\b(?:{words})(?:s|es)?\b", re.IGNORECASE)
    return next((remark for remark in plan.remarks if pattern.search(remark.replace("_", " "))), "")
