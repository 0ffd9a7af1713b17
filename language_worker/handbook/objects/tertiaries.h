// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// A tertiary to be made: its class and the floor object that it belongs to (null: the room itself).
struct HostedPiece {
  const ProgramItem* item = nullptr;
  const v1::Object* host = nullptr;
};

// Shares the tertiaries of a program out over the floor objects that can carry them, most wanted first, at most
// `program.max_tertiaries` and every requested one. Pieces whose host is missing or full are left out.
std::vector<HostedPiece> ShareOut(const RoomProgram& program, const v1::ObjectList& floor_objects, const v1::Room& room,
                                  const Handbook& handbook);

// Where a class may be put when the entry says nothing: its hosts, else the partners of its first sentence.
std::vector<std::string> HostClasses(const ProgramItem& item, const RoomProgram& program);

}  // namespace flair::language
