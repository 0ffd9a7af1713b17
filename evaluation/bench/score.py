# SPDX-License-Identifier: GPL-3.0-or-later
"""How translations of labelled sentences compare with the labels."""

from collections import Counter

from labels import Bullet, Call
from tables import Table, counted

# Correct: all calls of an alternative are made and none besides, or none where nothing is wanted. Wrong: a call is made
# that no alternative names. Missed: other clauses of the sentence gave calls, or a part of this one's. Refused: the
# sentence gave no call at all.
OUTCOMES = ("correct", "wrong", "missed", "refused")

# Labels give centimetres; readers of feet come within this.
_SAME_LENGTH_M = 1e-6
_SYMMETRIC = {"near", "away_from", "parallel", "perpendicular", "next_to"}
_SWAPPED = {"object": "target", "target": "object", "object_side": "target_side", "target_side": "object_side"}
_BETWEEN_SWAPPED = {"first": "second", "second": "first"}


def made_call(edge: dict) -> Call:
    """An edge of a graph, as JSON has it."""
    def value(given: dict) -> object:
        return given["texts"].get("items", []) if "texts" in given else next(iter(given.values()), "")

    return Call(edge["type"], {one["name"]: value(one["value"]) for one in edge.get("arguments", [])})


def _same_value(made: object, wanted: object) -> bool:
    if isinstance(wanted, list):
        return isinstance(made, list) and set(made) == set(wanted)
    if isinstance(wanted, float):
        return isinstance(made, (int, float)) and abs(made - wanted) < _SAME_LENGTH_M
    return made == wanted


def _same_arguments(made: dict, gold: dict) -> bool:
    def same(name: str, wanted: object) -> bool:
        if name in made:
            return _same_value(made[name], wanted)
        return wanted is False or (name == "sides" and wanted == ["front"])

    return all(same(name, wanted) for name, wanted in gold.items())


def meets(made: Call, gold: Call) -> bool:
    """The same type, and each labelled argument the same. Types that mean the same both ways may swap their objects
    with their sides; sides and surrounding objects are sets; against_wall and near_wall without a labelled side mean
    the back, accessible without sides the front."""
    if made.type != gold.type:
        return False
    if made.type in ("against_wall", "near_wall") and "side" not in gold.arguments:
        if made.arguments.get("side", "back") != "back":
            return False
    both_ways = gold.type in _SYMMETRIC or (gold.type == "facing" and gold.arguments.get("both") is True)
    swaps = _SWAPPED if both_ways else _BETWEEN_SWAPPED if gold.type == "between" else {}
    swapped = {swaps.get(name, name): value for name, value in made.arguments.items()}
    return _same_arguments(made.arguments, gold.arguments) or (bool(swaps) and _same_arguments(swapped, gold.arguments))


def outcomes_of(bullet: Bullet, made: list[Call]) -> list[str]:
    """One for each label. A call that no label of the bullet names counts once: against the first clause that is not
    met, else against the last one to be refused, else against the last."""
    def met(alternatives: list[list[Call]]) -> bool:
        return not alternatives or any(all(any(meets(one, gold) for one in made) for gold in calls)
                                       for calls in alternatives)

    outcomes = ["correct" if met(label.alternatives) else "missed" if made else "refused" for label in bullet.labels]
    named = [gold for label in bullet.labels for calls in label.alternatives for gold in calls]
    if not all(any(meets(one, gold) for gold in named) for one in made):
        unmet = [i for i, outcome in enumerate(outcomes) if outcome != "correct"]
        refused = [i for i, label in enumerate(bullet.labels) if not label.alternatives]
        outcomes[unmet[0] if unmet else refused[-1] if refused else -1] = "wrong"
    return outcomes


class Score:
    """By kind of table: "function", "room", "list"; functions are the reference's, "refuse" for what is to be
    refused."""

    def __init__(self) -> None:
        self.by: dict[str, dict[str, Counter]] = {"function": {}, "room": {}, "list": {}}
        self.all: Counter = Counter()
        # Sentences that gave neither a call nor a remark.
        self.silent = 0
        # Every sentence of which something is not correct: what is accepted, what was made, what was remarked.
        self.misses = ""

    def add(self, room: str, bullet: Bullet, sentence_id: str, graph: dict) -> None:
        made = [made_call(edge) for edge in graph.get("edges", []) if edge.get("sentence_id") == sentence_id]
        remarks = [one for one in graph.get("diagnostics", []) if one.get("subject_id") == sentence_id]
        self.silent += not made and not remarks
        outcomes = outcomes_of(bullet, made)
        for label, outcome in zip(bullet.labels, outcomes):
            self.all[outcome] += 1
            for kind, name in (("function", label.function), ("room", room), ("list", bullet.list)):
                self.by[kind].setdefault(name, Counter())[outcome] += 1
        if set(outcomes) != {"correct"}:
            self.misses += f"{room} {bullet.list}: {bullet.text}\n"
            for label in bullet.labels:
                wanted = " or ".join(" and ".join(call.text() for call in calls) for calls in label.alternatives)
                self.misses += f"  wanted   {wanted or 'nothing'}\n"
            self.misses += "".join(f"  made     {call.text()}\n" for call in made)
            self.misses += "".join(f"  remarked {one['code']}: {one['message']}\n" for one in remarks)

    def text(self) -> str:
        parts = []
        for kind, tallies in self.by.items():
            table = Table([kind, "labels", *OUTCOMES, "correct %"], max(12, *map(len, tallies)))
            last = {"all": self.all} if kind == "list" else {}
            parts.append(table.header() + "".join(
                table.row([name, str(tally.total()), *(str(tally[outcome]) for outcome in OUTCOMES),
                           f"{100 * tally['correct'] / tally.total():.1f}"])
                for name, tally in [*sorted(tallies.items()), *last.items()]))
        silent = f"{counted(self.silent, 'sentence')} gave neither a call nor a remark\n" if self.silent else ""
        share = 100 * self.all["correct"] / self.all.total()
        return "\n".join(parts) + f"{silent}{share:.1f} % of {self.all.total()} labels correct\n"
