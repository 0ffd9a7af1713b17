#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A language worker in Python that invents nothing: it hands out rooms of a folder. Serves flair.v1.LanguageService.

    python3 examples/python_language/main.py --listen 127.0.0.1:50061
    flair design "A music room." --language 127.0.0.1:50061 --out out/music
"""

import argparse
import sys
from collections.abc import Callable, Iterable, MutableSequence
from pathlib import Path
from typing import Any

import grpc

from flair import v1
from flair.stage import Refusal, Stage, answers, digest_of, require, serve

from library import BadLibrary, Described, choose, read_library

HERE = Path(__file__).resolve().parent
Context = grpc.ServicerContext


def note(code: str, message: str) -> v1.Diagnostic:
    return v1.Diagnostic(severity=v1.Severity.SEVERITY_NOTE, code=code, message=message)


class Language(v1.LanguageServiceServicer):
    """What the brief brings is kept; the rest is that of the room that its words name."""

    def __init__(self, rooms: list[Described], producer: v1.Producer) -> None:
        self._rooms = rooms
        self._producer = producer

    def _room(self, brief: v1.Brief) -> Described:
        room = choose(self._rooms, brief.text, brief.seed)
        if room is None:
            names = ", ".join(f'"{room.room.room_type}"' for room in self._rooms)
            message = f'brief.text: "{brief.text[:200]}" names none of the rooms here: {names}'
            raise Refusal(grpc.StatusCode.NOT_FOUND, message)
        return room

    @answers
    def DescribeRoom(self, request: v1.DescribeRoomRequest, context: Context) -> v1.DescribeRoomResponse:
        require(request, "brief")
        if request.brief.HasField("room"):
            return v1.DescribeRoomResponse(producer=self._producer, room=request.brief.room)
        described = self._room(request.brief)
        response = v1.DescribeRoomResponse(producer=self._producer, room=described.room)
        remark = f'this is the room "{described.name}" of a folder; nothing else of the brief was read'
        response.room.diagnostics.append(note("from_folder", remark))
        return response

    @answers
    def PlanZones(self, request: v1.PlanZonesRequest, context: Context) -> v1.PlanZonesResponse:
        require(request, "brief", "room")
        brief, response = request.brief, v1.PlanZonesResponse(producer=self._producer)
        response.zone_plan.CopyFrom(brief.zone_plan if brief.HasField("zone_plan") else self._room(brief).zone_plan)
        known = {zone.id for zone in response.zone_plan.zones}
        for name in dict.fromkeys(item.zone_id for item in brief.object_list.objects):
            if name and name not in known:  # objects without their zones: these are planned too
                response.zone_plan.zones.add(id=name, name=name.replace("_", " "))
        return response

    @answers
    def ListObjects(self, request: v1.ListObjectsRequest, context: Context) -> v1.ListObjectsResponse:
        require(request, "brief", "room", "zone_plan")
        brief = request.brief
        objects = brief.object_list if brief.HasField("object_list") else self._room(brief).object_list
        zones = [zone.id for zone in request.zone_plan.zones]
        for item in objects.objects:
            if item.zone_id and item.zone_id not in zones:
                message = f'zone_plan.zones: "{item.zone_id}" is missing, to which "{item.id}" belongs; add that zone'
                raise Refusal(grpc.StatusCode.INVALID_ARGUMENT, message)
        return v1.ListObjectsResponse(producer=self._producer, object_list=objects)

    @answers
    def ChooseStyle(self, request: v1.ChooseStyleRequest, context: Context) -> v1.ChooseStyleResponse:
        require(request, "brief", "room", "zone_plan", "object_list")
        response = v1.ChooseStyleResponse(producer=self._producer, style_sheet=self._room(request.brief).style_sheet)
        known = ids_of(request.object_list.objects) | ids_of(request.room.openings)
        keep_only(response.style_sheet.objects, lambda item: item.subject_id in known)
        return response

    @answers
    def ListConstraints(self, request: v1.ListConstraintsRequest, context: Context) -> v1.ListConstraintsResponse:
        require(request, "brief", "room", "zone_plan", "object_list")
        brief, known = request.brief, ids_of(request.object_list.objects)
        sentences = brief.constraint_list if brief.HasField("constraint_list") else self._room(brief).constraint_list
        response = v1.ListConstraintsResponse(producer=self._producer, constraint_list=sentences)
        removed = keep_only(response.constraint_list.sentences, lambda item: known.issuperset(item.subject_ids))
        if removed:
            remark = f"left out, as they are about absent objects: {', '.join(item.text for item in removed)}"
            response.constraint_list.diagnostics.append(note("absent_object", remark))
        return response

    @answers
    def CleanConstraints(self, request: v1.CleanConstraintsRequest, context: Context) -> v1.CleanConstraintsResponse:
        """Rooms of the folder are clean already."""
        require(request, "room", "object_list", "constraint_list")
        return v1.CleanConstraintsResponse(producer=self._producer, constraint_list=request.constraint_list)


def ids_of(items: Iterable[Any]) -> set[str]:
    return {item.id for item in items}


def keep_only(items: MutableSequence[Any], wanted: Callable[[Any], bool]) -> list[Any]:
    """Removes what is not wanted from a repeated field and returns it."""
    removed = [item for item in items if not wanted(item)]
    for item in removed:
        items.remove(item)
    return removed


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--listen", default="127.0.0.1:50061", metavar="HOST:PORT", help="port 0 takes a free one")
    parser.add_argument("--rooms", type=Path, default=HERE / "rooms", metavar="FOLDER", help="rooms to hand out")
    arguments = parser.parse_args()
    try:
        rooms = read_library(arguments.rooms)
    except BadLibrary as error:
        sys.exit(f"python-language: {error}")
    configuration = digest_of(list(arguments.rooms.glob("*/*.json")))
    producer = v1.Producer(program="python-language", method="folder", version="1", configuration_digest=configuration)
    worker = v1.GetWorkerResponse(
        program=producer.program,
        revision=digest_of(list(HERE.glob("*.py"))) + "/" + configuration,
        protocols=["flair.v1"],
        capabilities=[v1.Capability.CAPABILITY_DETERMINISTIC],
        configuration_digest=configuration,
    )
    stage = Stage(worker, "flair.v1.LanguageService",
                  lambda server: v1.add_LanguageServiceServicer_to_server(Language(rooms, producer), server))
    serve(stage, arguments.listen)


if __name__ == "__main__":
    main()
