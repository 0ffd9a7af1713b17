# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder of rooms: one folder each, with five files of proto3 JSON.

    rooms/music_room/room.json         flair.v1.Room
                     zones.json        flair.v1.ZonePlan
                     objects.json      flair.v1.ObjectList
                     style.json        flair.v1.StyleSheet
                     constraints.json  flair.v1.ConstraintList
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from google.protobuf import json_format
from google.protobuf.message import Message

from flair import v1
from flair.stage import problems_in

_M = TypeVar("_M", bound=Message)


class BadLibrary(Exception):
    """The folder cannot be used; the message names the file and what is wrong with it."""


@dataclass(frozen=True)
class Described:
    """A room with all that belongs to it, checked."""

    name: str
    room: v1.Room
    zone_plan: v1.ZonePlan
    object_list: v1.ObjectList
    style_sheet: v1.StyleSheet
    constraint_list: v1.ConstraintList


def read_library(folder: Path) -> list[Described]:
    """All rooms of a folder, by name."""
    rooms = [_read_room(path) for path in sorted(folder.iterdir()) if path.is_dir()] if folder.is_dir() else []
    if not rooms:
        raise BadLibrary(f"{folder}: no rooms; each is a folder with room.json and four files more")
    return rooms


def choose(rooms: list[Described], text: str, seed: int) -> Described | None:
    """The room whose type the text names in the most words, such as "music room"; None when it names none.

    Where several fit equally well, the seed decides.
    """
    said = _words(text)
    fitting = [room for room in rooms if _words(room.room.room_type) <= said]
    most = max((len(_words(room.room.room_type)) for room in fitting), default=0)
    best = [room for room in fitting if len(_words(room.room.room_type)) == most]
    return best[seed % len(best)] if best else None


def _words(text: str) -> set[str]:
    return set(re.findall(r"\w+", text.lower()))


def _read_room(folder: Path) -> Described:
    described = Described(
        name=folder.name,
        room=_read(folder / "room.json", v1.Room()),
        zone_plan=_read(folder / "zones.json", v1.ZonePlan()),
        object_list=_read(folder / "objects.json", v1.ObjectList()),
        style_sheet=_read(folder / "style.json", v1.StyleSheet()),
        constraint_list=_read(folder / "constraints.json", v1.ConstraintList()),
    )
    # A brief has all parts that refer to each other, so its checks are the right ones.
    whole = v1.Brief(text=described.room.room_type, room=described.room, zone_plan=described.zone_plan,
                     object_list=described.object_list, constraint_list=described.constraint_list)
    if problems := problems_in(whole) + problems_in(described.style_sheet, "style_sheet"):
        raise BadLibrary(f"{folder}: {'; '.join(problems[:5])}")
    return described


def _read(path: Path, message: _M) -> _M:
    try:
        return json_format.Parse(path.read_text(encoding="utf-8"), message)
    except (OSError, UnicodeDecodeError, json_format.ParseError) as error:
        raise BadLibrary(f"{path}: {error}") from error
