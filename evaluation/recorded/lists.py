# SPDX-License-Identifier: GPL-3.0-or-later
"""Constraints and places of small things that a model wrote as lists in free text."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field

from names import (LISTS, Mention, Names, Thing, find_zone, has_size, has_word_of, is_size, keys_of, likeness, name_key,
                   split_sentences)

_MOST_LINES, _LONGEST_LINE, _LONGEST_PLACE = 2000, 2000, 300
# Depths: headings 1 to 6, titles, plain text, then items by their indent.
_TITLE, _TEXT, _ITEM = 7, 8, 12


@dataclass
class Conversion:
    """What becomes of the lines of recorded texts: a line is converted, frames the others, or is kept with the
    reason."""

    lines: int = 0
    converted: int = 0
    remarks: list[str] = field(default_factory=list)

    def convert(self) -> None:
        self.lines += 1
        self.converted += 1

    def keep(self, source: str, line: int, text: str, reason: str) -> None:
        self.lines += 1
        self.remarks.append(f"{source}{f', line {line}' if line else ''} ({reason}): {text}")

    def unconvert(self, source: str, text: str, reason: str) -> None:
        """A sentence of a converted line has no place after all."""
        self.converted = max(0, self.converted - 1)
        self.remarks.append(f"{source} ({reason}): {text}")


@dataclass
class Line:
    """A line of Markdown that says something, without its marks."""

    number: int
    depth: int
    # It names what stands under it: a heading, a line all in bold, or one that ends in a colon.
    title: bool
    text: str
    # Index of the nearest line before it with a smaller depth; -1 for none.
    parent: int = -1
    has_children: bool = False


_MARKED = re.compile(r"(?P<indent>[ \t\r]*)(?P<hashes>#{1,6}(?!#)[ \t]*)?"
                     r"(?P<mark>•|[-*+](?=\s)|(?P<number>\d{1,3}[.)](?=[ *])))?[ \t]*(?P<rest>.*)")


def _read_line(raw: str, number: int) -> Line:
    marked = _MARKED.match(raw)
    rest = marked["rest"]
    text = re.sub(r"[*`]", "", rest).strip()
    bold = re.match(r"\*\*(?:(?!\*\*).)*\*\*[*: \t\r]*$", rest) and not text.endswith(".")
    title = bool(marked["hashes"] or bold or text.endswith(":"))
    indent = len(marked["indent"])
    if marked["hashes"]:
        depth = marked["hashes"].count("#")
    elif marked["mark"] or indent >= 2:
        # Text that is indented goes on with what is above it.
        depth = _ITEM + 4 * min(indent, 40) + (0 if marked["number"] else 2 if marked["mark"] else 3)
    else:
        depth = _TITLE if title else _TEXT
    return Line(number, depth, title, text.rstrip(": \t\r"))


def _outline(text: str, is_title: Callable[[str], bool] = lambda line: False) -> list[Line]:
    """What `is_title` says of goes above the items at its indent."""
    lines: list[Line] = []
    open_lines: list[int] = []  # those that the next one may stand under
    for number, raw in enumerate(text.split("\n")[:_MOST_LINES], 1):
        line = _read_line(raw[:_LONGEST_LINE], number)
        if not keys_of(line.text):
            continue  # "---", "```" and the like say nothing
        if line.depth >= _ITEM and is_title(line.text):
            line.depth -= 1
        while open_lines and lines[open_lines[-1]].depth >= line.depth:
            open_lines.pop()
        if open_lines:
            line.parent = open_lines[-1]
            lines[line.parent].has_children = True
        open_lines.append(len(lines))
        lines.append(line)
    return lines


def _label_of(text: str) -> str:
    """The first words of a line up to a colon."""
    label, colon, _ = text.partition(": ")
    return label if colon and len(label) <= 40 else ""


def _begins_with(name: str, text: str) -> bool:
    return bool(keys := keys_of(text)) and keys[0] in LISTS[name]


@dataclass
class Sentence:
    """A sentence with the indices of the things that it is about."""

    things: list[int]
    text: str
    must: bool = False


@dataclass
class _Context:
    """What holds for the lines under one."""

    things: list[int] = field(default_factory=list)
    zone: str = ""
    # The beginning of an unfinished sentence: "Avoid placement near:".
    beginning: str = ""


def _all_of(mentions: list[Mention]) -> list[int]:
    return list(dict.fromkeys(thing for mention in mentions for thing in mention.things))


def _at_begin(mentions: list[Mention]) -> bool:
    """After at most "The " or "4 "."""
    return bool(mentions) and mentions[0].begin <= 4


class _Constraints:
    def __init__(self, source: str, intra: bool, names: Names, zones: list[str], conversion: Conversion) -> None:
        self.source, self.intra, self.names, self.zones, self.conversion = source, intra, names, zones, conversion
        self.sentences: list[Sentence] = []

    def read(self, text: str) -> list[Sentence]:
        lines = _outline(text, self._is_name_with_size)
        contexts: list[_Context] = []
        for line in lines:
            above = contexts[line.parent] if line.parent >= 0 else _Context()
            context = _Context(above.things, above.zone, above.beginning)
            contexts.append(context)
            if self._is_title(line):
                self._open_title(line, context)
            elif line.title and line.has_children:
                context.beginning = line.text + " "
            elif line.depth >= _ITEM or (has_word_of("demands", line.text) and self.names.find(line.text)):
                self._add(line, context)
            # Else it frames a list: "Certainly! Here are ..."
        return self.sentences

    def _is_name_with_size(self, line: str) -> bool:
        """"Plant stand: 0.4m x 0.4m", whose list may stand at the same indent."""
        mentions = self.names.find(line)
        return _at_begin(mentions) and has_size(line) and is_size(line[mentions[0].end:])

    def _is_title(self, line: Line) -> bool:
        if line.depth < _TITLE:
            return True
        if has_word_of("demands", line.text):
            return False
        named = self.names.find(line.text) or find_zone(line.text, self.zones)
        return line.title or bool(line.has_children and named)

    def _open_title(self, line: Line, context: _Context) -> None:
        context.zone = find_zone(line.text, self.zones) or context.zone
        mentions = self.names.find(line.text, context.zone)
        if not self.intra:
            context.things = _all_of(mentions) or context.things
            return
        # "Distance from the bed:" is about the object above, "Floor lamp (0.4m x 0.4m)" about another one.
        if line.depth >= _ITEM and context.things and not _at_begin(mentions):
            return
        mentions = mentions or self.names.find_loosely(line.text, context.zone)
        if mentions:
            # "Workstation: Alchemy Table" names a zone first, whose name may be an object's too.
            colon = line.text.find(":")
            behind = [mention for mention in mentions if mention.begin > colon]
            context.things = (behind or mentions)[0].things

    def _add(self, line: Line, context: _Context) -> None:
        label = _label_of(line.text)
        idle = bool(label) and _begins_with("idle labels", label)
        text = context.beginning + (line.text[len(label) + 2:] if idle else line.text)
        things = context.things or self._named(text, context)
        if not things:
            self.conversion.keep(self.source, line.number, line.text, "names none of the objects")
            return
        self.conversion.convert()
        for sentence in split_sentences(text):
            own = list(context.things)
            if not own:
                # "The bookshelf ... It should be away from the sofa."
                own = [things[0]] if _begins_with("sentence pronouns", sentence) else []
                own += [thing for thing in self._named(sentence, context) if thing not in own]
            self.sentences.append(Sentence(own or things, sentence, has_word_of("musts", sentence)))

    def _named(self, text: str, context: _Context) -> list[int]:
        mentions = self.names.find_loosely(text, context.zone)
        # Of several, an intra constraint is about the first.
        return _all_of(mentions[:1] if self.intra else mentions)


def read_constraints(source: str, text: str, intra: bool, names: Names, zones: list[str],
                     conversion: Conversion) -> list[Sentence]:
    """The sentences in the order of the text. `intra`: under a heading for each thing, whose first name counts; else
    under headings for pairs, zones or nothing."""
    return _Constraints(source, intra, names, zones, conversion).read(text)


def read_looks(text: str, subjects: list[str], colour_in: Callable[[str], str]) -> dict[str, str]:
    """By subject, what is said of its colour: the first line that has one, among the line that names the subject and
    those under it."""
    lines, looks = _outline(text), {}
    for subject in subjects:
        named = Names([Thing(subject, subject, "", "")])
        for i, line in enumerate(lines):
            below = next((k for k in range(i + 1, len(lines)) if lines[k].depth <= line.depth), len(lines))
            said = [one.text for one in lines[i:below] if colour_in(one.text)] if named.find(line.text) else []
            if said:
                looks[subject] = said[0][len(_label_of(said[0])):].lstrip(": ")
                break
    return looks


@dataclass
class _Item:
    """An item of a list: what it is called, what is said of its place, the heading that it stands under."""

    line: int
    name: str
    place: str
    heading: str
    used: bool = False


@dataclass
class Place:
    """Where a small thing goes: the text, empty when there is none; the floor objects that it names; the item's line,
    the same for several of a kind."""

    text: str = ""
    hosts: list[int] = field(default_factory=list)
    line: int = 0


def _without_sizes(text: str) -> str:
    """The sentences that are not sizes, joined."""
    rest = []
    for sentence in split_sentences(text):
        # "0.2m x 0.2m - Placed on the desk"
        for gap in (" - ", " – ", ", ", ": ", ") "):
            size, found, behind = sentence.partition(gap)
            if found and is_size(size):
                sentence = behind
        if not is_size(sentence):
            rest.append(sentence)
    return " ".join(rest)


def _is_property(line: Line) -> bool:
    """"Placement:", "Dimensions (width x length):" and the like are about the item above."""
    return _begins_with("property labels", line.text if line.title else _label_of(line.text))


def _read_below(lines: list[Line], index: int, item: _Item) -> tuple[bool, bool]:
    """Adds what stands under an item to it: whether that is about it alone, and whether there are properties."""
    described = False
    for line in lines[index + 1:]:
        if line.depth <= lines[index].depth:
            break
        label, prop = _label_of(line.text), _is_property(line)
        if not prop and (label or line.has_children or has_size(line.text)):
            return False, described
        described = described or prop
        if prop and not _begins_with("where labels", label):
            continue
        more = _without_sizes(line.text[len(label) + 2:] if prop else line.text)
        if more and (prop or has_word_of("where words", more)):
            item.place = f"{item.place} {more}".strip()
    return True, described


def _read_items(text: str) -> list[_Item]:
    """A line begins an item when it has a size, a place or properties, and what stands under it is about it alone."""
    lines, items, below = _outline(text), [], -1
    for i, line in enumerate(lines):
        if has_word_of("summaries", line.text):
            break  # says all again
        if 0 <= below < line.depth:
            continue
        below = -1
        if _is_property(line) or line.depth == _TEXT:
            continue
        label = _label_of(line.text)
        item = _Item(line.number, label or line.text, _without_sizes(line.text[len(label) + 2:]) if label else "",
                     lines[line.parent].text if line.parent >= 0 else "")
        alone, described = _read_below(lines, i, item)
        described = described or (has_size(line.text) and line.depth >= _ITEM)
        placed = item.place or (line.depth >= _ITEM and has_word_of("where words", item.name))
        if alone and (described or placed):
            items.append(item)
            below = line.depth
    return items


def _score(thing: Thing, item: _Item) -> float:
    in_name = likeness(thing.name, item.name)
    if in_name > 0:
        return in_name
    if thing.key and thing.key in name_key(item.name):
        return 0.99  # "tablelamp"
    # "Wall Art: A small painting of a forest."
    return 0.4 if likeness(thing.name, f"{item.name} {item.place}") == 1 else 0


def _place_of(item: _Item, floor: Names) -> Place:
    text = item.place or item.name
    if not has_word_of("where words", text) and has_word_of("where words", item.heading):
        text = f"{item.heading}. {text}"
    if not has_word_of("where words", text):
        text = ""  # a name and a size alone
    mentions = next(filter(None, map(floor.find_loosely, (text, item.name, item.heading))), [])
    return Place(text[:_LONGEST_PLACE], mentions[0].things if mentions else [], item.line)


def read_places(text: str, things: list[Thing], floor: Names, conversion: Conversion) -> list[Place]:
    """One for each of the things, in their order. Each item is of one thing, the best first, but of several equal ones
    together."""
    items = _read_items(text)
    found: list[_Item | None] = [None] * len(things)
    # Certain ones first, so that "lamp" does not take the "floor lamp" of another.
    for least in (0.99, 0.6, 0.3):
        for i, thing in enumerate(things):
            if found[i] is None:
                free = [(_score(thing, item), item) for item in items if not item.used]
                score, best = max(free, key=lambda scored: scored[0], default=(0, None))
                # One item may list several of a kind: "Cushions (x5)".
                same = (found[k] for k in range(i) if things[k].name == thing.name)
                found[i] = best if score >= least else next(filter(None, same), None)
            if found[i] is not None:
                found[i].used = True
    for item in items:
        if item.used:
            conversion.convert()
        else:
            conversion.keep("tertiary", item.line, f"{item.name}: {item.place}", "belongs to none of the objects")
    return [_place_of(item, floor) if item else Place() for item in found]
