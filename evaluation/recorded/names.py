# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of a text, and which of a room's objects it speaks of."""

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import NamedTuple

_DATA = json.loads((Path(__file__).parent / "words.json").read_text(encoding="utf-8"))
LISTS = {name: frozenset(words) for name, words in _DATA["lists"].items()}
SAYS = {function: frozenset(words) for function, words in _DATA["says"].items()}

# "0.5m" is one word, "living_area" are two.
_WORD = re.compile(r"[^\W_]+(?:(?<=\d)\.(?=\d)[^\W_]+)*")
_LONGEST_NAME_WORDS = 6


class Word(NamedTuple):
    begin: int
    end: int
    # In lower case, singular.
    key: str


@cache
def singular(word: str) -> str:
    """The same for both forms of a noun, which is all that names need."""
    for plural, one in _DATA["irregular"].items():
        if word.endswith(plural):
            return word.removesuffix(plural) + one
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if re.search(r"(ss|x|z|ch|sh)es$", word):
        return word[:-2]
    return word if len(word) < 3 or word.endswith(("ss", "us", "is")) else word.removesuffix("s")


def words_of(text: str) -> list[Word]:
    return [Word(found.start(), found.end(), singular(found[0].lower())) for found in _WORD.finditer(text)]


def keys_of(text: str) -> list[str]:
    return [word.key for word in words_of(text)]


def name_key(name: str) -> str:
    """Equal for "Nightstands", "nightstand_2" and "night stand": a number behind a name only tells equal things
    apart."""
    keys = keys_of(name)
    return "".join(key for i, key in enumerate(keys) if i == 0 or not key.isdigit())


def has_word_of(name: str, text: str) -> bool:
    return not LISTS[name].isdisjoint(keys_of(text))


def is_size(text: str) -> bool:
    """Nothing but a size: "0.3m x 0.3m (each)"; or no words at all."""
    return all(key[0].isdigit() or key in LISTS["size words"] for key in keys_of(text))


def has_size(text: str) -> bool:
    return any(key[0].isdigit() and key.endswith("m") for key in keys_of(text))


def likeness(a: str, b: str) -> float:
    """Share of the words of the shorter text that the longer one has too."""
    first, second = (set(keys_of(text)) - LISTS["empty words"] for text in (a, b))
    least = min(len(first), len(second))
    return len(first & second) / least if least else 0


def split_sentences(line: str) -> list[str]:
    """A sentence ends before a capital letter, not within parentheses and not in "e.g. Beams"."""
    sentences, begin, depth = [], 0, 0
    for i, c in enumerate(line):
        depth = depth + 1 if c == "(" else max(0, depth - 1) if c == ")" else depth
        abbreviated = i >= 2 and line[i - 2] == "."
        if depth == 0 and not abbreviated and re.match(r"[.!?] [A-Z]", line[i:i + 3]):
            sentences.append(line[begin:i + 1])
            begin = i + 1
    sentences.append(line[begin:])
    return [sentence.strip()[:390] for sentence in sentences if sentence.strip()]


@dataclass(frozen=True)
class Thing:
    """An object of the room, with the name, size and zone that it was recorded with."""

    id: str
    name: str
    # "primary", "secondary" or "tertiary"; "floor", "wall", "ceiling" or "surface".
    role: str
    kind: str
    zone: str = ""
    width_m: float = 0
    depth_m: float = 0

    @property
    def key(self) -> str:
        return name_key(self.name)

    def like(self, other: "Thing") -> bool:
        mine = (self.key, self.zone, self.kind, self.width_m, self.depth_m)
        return mine == (other.key, other.zone, other.kind, other.width_m, other.depth_m)


@dataclass
class Mention:
    """One place of a text that names things; their indices."""

    begin: int
    end: int
    things: list[int] = field(default_factory=list)


def _size_behind(text: str) -> tuple[float, ...]:
    """The two lengths of " (1.5m x 0.6m)" or " - Width: 0.5m, Length: 0.4m", which must follow at once."""
    sizes: list[float] = []
    for key in keys_of(text.split("\n")[0][:60]):
        number = re.match(r"\d+(?:\.\d+)?", key)
        if number:
            sizes.append(float(number[0]))
        elif key not in LISTS["size words"]:
            break
        if len(sizes) == 2:
            return tuple(sizes)
    return ()


class Names:
    """Finds the names of things in texts."""

    def __init__(self, things: Iterable[Thing]) -> None:
        self.things = list(things)
        self._by_key: dict[str, list[int]] = {}
        self._words: dict[str, list[str]] = {}
        for i, thing in enumerate(self.things):
            self._by_key.setdefault(thing.key, []).append(i)
            self._words.setdefault(thing.key, keys_of(thing.name))

    def find(self, text: str, zone: str = "") -> list[Mention]:
        """Longest names first, plurals too, "TV-stand" for "tv stand". A size or a number behind a name chooses among
        equal names, and so does the zone."""
        words, mentions, i = words_of(text), [], 0
        while i < len(words):
            for count in range(min(_LONGEST_NAME_WORDS, len(words) - i), 0, -1):
                named = self._by_key.get("".join(word.key for word in words[i:i + count]))
                if named:
                    end = words[i + count - 1].end
                    mentions.append(Mention(words[i].begin, end, self._choose(text[end:], zone, named)))
                    i += count - 1
                    break
            i += 1
        return mentions

    def find_loosely(self, text: str, zone: str = "") -> list[Mention]:
        """The same, or else where the text has a word of one name alone: "Alchemical Table" for "alchemy table"."""
        mentions = self.find(text, zone)
        if mentions:
            return mentions
        for word in words_of(text):
            named = [key for key, words in self._words.items() if len(word.key) > 2 and word.key in words]
            if len(named) == 1:
                things = self._choose(text[word.end:], zone, self._by_key[named[0]])
                if all(mention.things != things for mention in mentions):
                    mentions.append(Mention(word.begin, word.end, things))
        return mentions

    def _choose(self, behind: str, zone: str, named: list[int]) -> list[int]:
        chosen = named
        if len(chosen) < 2:
            return chosen
        size = _size_behind(behind)
        if size:
            def of_size(thing: Thing) -> bool:
                sides = sorted((thing.width_m, thing.depth_m))
                return all(abs(a - b) < 0.005 for a, b in zip(sides, sorted(size)))

            chosen = [i for i in chosen if of_size(self.things[i])] or chosen
        if zone:
            chosen = [i for i in chosen if self.things[i].zone == zone] or chosen
        number = re.match(r"[ (#]*(\d{1,2})(?!\w|\.\d)", behind)
        if number and 1 <= int(number[1]) <= len(chosen):
            return [chosen[int(number[1]) - 1]]
        return chosen


def find_zone(text: str, zones: list[str]) -> str:
    """The zone that the first words of a text name, such as "Living Area:"."""
    keys = keys_of(text)[:3]
    begins = {"".join(keys[:count]) for count in range(1, len(keys) + 1)}
    return next((zone for zone in zones if name_key(zone) in begins), "")
