# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the calls that the recorded model translated its sentences to back to the sentences of a translation prompt.

A recording does not say which call is of which sentence: a call goes to the sentence about its objects whose words name
what the function does, the feature and the distance best."""

from lists import Conversion
from names import LISTS, SAYS, keys_of, name_key
from prompts import Asked, Listed, PromptIds, read_asked, read_listed
from room import Call, Room, is_rug

_OF_A_WALL = {"against_wall", "near_wall", "in_corner"}
# What the prompt of a pass says of its sentences.
_PASSES = {"about one object and the room": "intra", "about objects among each other": "inter",
           "where small things": "tertiary"}


def _names_feature(value: str, words: set[str]) -> bool:
    """Whether a sentence of these words names the feature that a value is; other values need not be named."""
    return value not in ("door", "window", "socket") or not LISTS[value].isdisjoint(words)


class _Sentence:
    def __init__(self, asked: Asked, names: dict[str, str]) -> None:
        self.asked, self.names = asked, names
        self.keys = keys_of(asked.text)
        self.words = set(self.keys)
        self.calls: list[str] = []

    def about(self, thing: str) -> bool:
        """Whether the sentence stands under the object, or names it."""
        if thing in self.asked.subjects:
            return True
        name = self.names.get(thing)
        # All places at which some words together are the name.
        return name is not None and any(
            "".join(self.keys[begin:end]) == name
            for begin in range(len(self.keys)) for end in range(begin + 1, min(begin + 7, len(self.keys) + 1)))

    def score(self, call: Call, things: list[str], others: list[str], items: bool) -> float:
        """How well it says the call of `things` with the other values; 0 when it does not."""
        if not things or not all(map(self.about, things)):
            return 0
        if not all(_names_feature(value, self.words) for value in others):
            return 0  # a feature that the sentence does not name is not what it is about
        said = len(self.words & SAYS.get(call.function, frozenset()))
        # An item's sentence is the only one about it, in whatever words.
        first = self.asked.subjects[:1] == things[:1]
        if said == 0 and not (items and first):
            return 0
        named = sum(key in self.words or f"{key}m" in self.words for value in others for key in keys_of(value))
        # Of equal ones that with fewer calls.
        return said + 0.5 + 3 * named + (0.5 if first else 0) - 0.1 * len(self.calls)


def _pass_of(call: Call, room: Room) -> str:
    """Which pass a call is for, by its objects. Rugs are items, whatever they were listed with."""
    items = {thing.id for thing in room.things if thing.role == "tertiary" or is_rug(thing.name)}
    pieces = {thing.id for thing in room.things} - items
    values = call.values()
    if not items.isdisjoint(values):
        return "tertiary"
    return "inter" if sum(value in pieces for value in values) > 1 else "intra"


def _text_of(call: Call, ids: dict[str, str]) -> str:
    """As an answer writes it: "near(object=sofa, target=shelf, max_distance_m=1)"."""
    arguments = []
    for name, values in call.arguments:
        listed = ", ".join(ids.get(value) or value for value in values)
        arguments.append(f"{name}={listed if len(values) == 1 else f'[{listed}]'}")
    return f"{call.function}({', '.join(arguments)})"


def pass_of_prompt(prompt: str) -> str:
    return next(name for words, name in _PASSES.items() if words in prompt)


def find_calls(room: Room, prompt: str, conversion: Conversion) -> dict:
    """The answer to the prompt of a pass; every sentence gets an entry."""
    wanted = pass_of_prompt(prompt)
    listed: list[Listed] = read_listed(prompt)
    prompt_ids = PromptIds(room.things, listed, loosely=True)
    ids = {thing.id: prompt_ids.id_of(i) for i, thing in enumerate(room.things)}
    names = {one: name_key(line.name) for line in listed for one in line.ids}
    sentences = [_Sentence(asked, names) for asked in read_asked(prompt)]
    for call in room.calls:
        own = _pass_of(call, room) == wanted
        # A sentence about a pair may say of one of them where its wall is.
        if not own and not (wanted == "inter" and call.function in _OF_A_WALL):
            continue
        things = [ids[value] for value in call.values() if value in ids]
        others = [value for value in call.values() if value not in ids]
        known = f"\n- {call.function}(" in prompt
        takers = [sentence for sentence in sentences if known and all(things) and (own or "wall" in sentence.words)]
        best, score = None, 0.0
        for sentence in takers:
            here = sentence.score(call, things, others, wanted == "tertiary")
            if here > score:
                best, score = sentence, here
        if best is not None:
            best.calls.append(_text_of(call, ids))
        if own and best is not None:
            conversion.convert()
        elif own:
            reason = ("its object was left out" if not all(things) else
                      "no sentence says it" if known else "is for another pass")
            conversion.keep("calls", 0, _text_of(call, ids), reason)
    return {"sentences": [f"{one.asked.id}: {'; '.join(one.calls) or 'none(not recorded)'}" for one in sentences]}
