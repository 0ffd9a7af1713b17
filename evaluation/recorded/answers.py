# SPDX-License-Identifier: GPL-3.0-or-later
"""A recorded room as typed answers to the questions of a design.

What the recording has no figure for (heights) is the handbook's, and so are looks that it does not tell, by which the
design completes an answer. Nothing else is added."""

import re

from call_sentences import find_calls, pass_of_prompt
from handbook import colour_in, height_of, kind_of_room, turned
from lists import Conversion, Place, Sentence, read_constraints, read_looks, read_places
from names import Names, Thing, singular
from prompts import PromptIds, read_listed
from room import Room

# Limits of the answers, see protos/flair/model/v1/constraint_answers.proto.
_MOST_PER_OBJECT, _MOST_PAIRS, _MOST_OF_A_PAIR = 12, 200, 8
_WALL_WHEN_TURNED = {"south": "west", "west": "south", "north": "east", "east": "north"}


def _name_for(thing: Thing, count: int) -> str:
    """"dining chair", also of "dining chairs", four times."""
    words = " ".join(thing.name.lower().replace("_", " ").split()).split(" ")
    if count > 1 and not words[-1].endswith("ss"):
        words[-1] = singular(words[-1])
    return " ".join(words)[:60]


class Answers:
    """`conversions` tells, by step, what became of the texts that were asked for so far."""

    def __init__(self, room: Room) -> None:
        self.room = room
        self.conversions: dict[str, Conversion] = {}
        self._names = Names(room.floor)
        self._turned = turned(room.brief, room.width_m, room.depth_m)

    def to(self, form: str, prompt: str) -> dict:
        """The answer of that form, which is the name of its schema, to a question. It has all that the schema requires:
        who leaves something out is told the schema in every prompt from then on."""
        return getattr(self, f"_{form}")(prompt)

    def _conversion(self, step: str) -> Conversion:
        self.conversions[step] = Conversion()
        return self.conversions[step]

    def _room_answer(self, _: str) -> dict:
        room, size = self.room, (self.room.width_m, self.room.depth_m)
        openings = []
        for opening in room.openings:
            window = opening["kind"] == "OPENING_KIND_WINDOW"
            position = self._position(opening["wall"], opening.get("offset_m", 0) + opening["width_m"] / 2)
            openings.append({"kind": "window" if window else "door", "wall": self._wall(opening["wall"]),
                             "position": position, "width_m": round(opening["width_m"], 4),
                             "swing": None if window else "inward"})
        sockets = [{"wall": self._wall(socket["wall"]), "position": self._position(socket["wall"], socket["offset_m"])}
                   for socket in room.sockets]
        width_m, depth_m = reversed(size) if self._turned else size
        return {"room_type": kind_of_room(room.brief), "width_m": width_m, "depth_m": depth_m, "height_m": None,
                "openings": openings, "sockets": sockets}

    def _wall(self, wall: str) -> str:
        return _WALL_WHEN_TURNED[wall] if self._turned else wall

    def _position(self, wall: str, offset_m: float) -> float:
        """Along a wall, as answers count: from its west or south end."""
        position = offset_m / (self.room.width_m if wall in ("south", "north") else self.room.depth_m)
        return round(min(max(1 - position if wall in ("north", "west") else position, 0), 1), 4)

    def _zones_answer(self, _: str) -> dict:
        zones = []
        for zone, name in self.room.zones.items():
            things = [_name_for(thing, 1) for thing in self.room.floor if (thing.zone, thing.role) == (zone, "primary")]
            zones.append({"name": name, "purpose": f"Lives by the {', '.join(things)}." if things else f"For {name}."})
        return {"zones": zones}

    def _floor_objects_answer(self, _: str) -> dict:
        groups: list[list[Thing]] = []
        for thing in self.room.floor:
            same = next((group for group in groups if group[0].like(thing)), None)
            if same is None:
                groups.append([thing])
            else:
                same.append(thing)
        return {"objects": [{"name": _name_for(thing, len(group)), "zone": thing.zone,
                             "primary": thing.role == "primary", "count": len(group), **_size_of(thing)}
                            for group in groups for thing in group[:1]], "left_out": []}

    def _tertiaries_answer(self, prompt: str) -> dict:
        conversion, things = self._conversion("tertiaries"), self.room.tertiaries
        ids = PromptIds(self.room.floor, read_listed(prompt))
        places = read_places(self.room.texts.get("tertiary", ""), things, self._names, conversion)
        answers: list[dict] = []
        for i, (thing, place) in enumerate(zip(things, places)):
            if i > 0 and place.line and place.line == places[i - 1].line and thing.like(things[i - 1]):
                answers[-1]["count"] += 1  # several of a kind that one item lists
                continue
            hosts = ids.names_of(place.hosts) or ids.names_of(self._host_by_calls(thing))
            answers.append(_tertiary(thing, place, hosts))
            if not place.text:
                conversion.keep("tertiary", 0, thing.name, "is in no item of the text; it goes where its call says")
        return {"objects": answers}

    def _host_by_calls(self, item: Thing) -> list[int]:
        """What the recorded model's own call put an item onto, beside or under."""
        for call in self.room.calls:
            values = call.values()
            hosts = [i for i, thing in enumerate(self.room.floor) if thing.id in values]
            if item.id in values and hosts:
                return hosts[-1:]
        return []

    def _sentences(self, form: str, conversion: Conversion) -> list[Sentence]:
        """Of two texts, of the primaries and of the secondaries, as the recorded model cleaned them if it did."""
        floor, texts, intra = self.room.floor, self.room.texts, form == "intra"
        primary = {i for i, thing in enumerate(floor) if thing.role == "primary"}
        found = {}
        for role in ("primary", "secondary"):
            source = f"{role}_{form}_clean" if texts.get(f"{role}_{form}_clean") else f"{role}_{form}"
            found[role] = read_constraints(source, texts.get(source, ""), intra, self._names, list(self.room.zones),
                                           conversion)
        # The first text is of the primaries: a secondary of the same name is not meant.
        for sentence in found["primary"]:
            meant = {floor[i].key for i in sentence.things if i in primary}
            sentence.things = [i for i in sentence.things if i in primary or floor[i].key not in meant]
        # And the other way round.
        for sentence in found["secondary"] if intra else []:
            sentence.things = [i for i in sentence.things if i not in primary] or sentence.things
        return found["primary"] + found["secondary"]

    def _intra_answer(self, prompt: str) -> dict:
        conversion, ids = self._conversion("intra"), PromptIds(self.room.floor, read_listed(prompt))
        objects: list[dict] = []
        for sentence in self._sentences("intra", conversion):
            names = ids.names_of(sentence.things)
            if not names:
                conversion.unconvert("intra", sentence.text, "its object was left out")
            for name in names:
                kind = "must" if sentence.must else "should"
                free = [one for one in objects if one["object"] == name and len(one[kind]) < _MOST_PER_OBJECT]
                if not free:
                    free = [{"object": name, "must": [], "should": []}]
                    objects += free
                free[0][kind].append(sentence.text)
        return {"objects": objects}

    def _inter_answer(self, prompt: str) -> dict:
        conversion, ids = self._conversion("inter"), PromptIds(self.room.floor, read_listed(prompt))
        pairs: list[dict] = []
        for sentence in self._sentences("inter", conversion):
            names, kind = ids.names_of(sentence.things)[:_MOST_OF_A_PAIR], "must" if sentence.must else "should"
            if not names or len(pairs) == _MOST_PAIRS:
                conversion.unconvert("inter", sentence.text, "one too many" if names else "its objects were left out")
                continue
            if not pairs or pairs[-1]["objects"] != names or len(pairs[-1][kind]) == _MOST_PER_OBJECT:
                pairs.append({"objects": names, "must": [], "should": []})
            pairs[-1][kind].append(sentence.text)
        return {"constraints": pairs}

    def _cleaning_answer(self, _: str) -> dict:
        """The sentences are those that the recorded model had cleaned."""
        return {"changes": []}

    def _style_answer(self, prompt: str) -> dict:
        listed = re.search(r"To be described, each once:\n(.*)", prompt)
        subjects, surfaces = listed[1].split(", ") if listed else [], ["walls", "floor"]
        looks = read_looks(self.room.texts.get("style", ""), [*surfaces, *subjects], colour_in)
        finishes = {name: {"material": said[:100], "colour": colour_in(said)} for name, said in looks.items()}
        return {"name": "recorded", "summary": "As the model wrote it.",
                "palette": list(dict.fromkeys(finish["colour"] for finish in finishes.values()))[:4],
                "surfaces": [{"surface": name, **finishes[name]} for name in surfaces if name in finishes],
                "looks": [{"of": [name], **finishes[name]} for name in subjects if name in finishes]}

    def _calls_answer(self, prompt: str) -> dict:
        return find_calls(self.room, prompt, self._conversion(f"translation.{pass_of_prompt(prompt)}"))


def _size_of(thing: Thing) -> dict:
    return {"width_m": thing.width_m, "depth_m": thing.depth_m, "height_m": height_of(thing)}


def _tertiary(thing: Thing, place: Place, hosts: list[str]) -> dict:
    name = _name_for(thing, 1)
    where = "on" if thing.kind == "surface" else "near"
    usual = f"The {name} is {where} the {hosts[0]}." if hosts else f"The {name} goes where it fits."
    return {"name": name, "kind": thing.kind, "at": hosts[0] if hosts else None, "count": 1, **_size_of(thing),
            "placement": place.text or usual}
