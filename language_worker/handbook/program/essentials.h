// SPDX-License-Identifier: GPL-3.0-or-later
// What a room cannot do without: a bedroom its bed.
#pragma once

#include "flair/v1/object_list.pb.h"
#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// Adds the essentials of the room's kinds and changes that nothing has brought, unless the brief refuses them.
void BringEssentials(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice,
                     RoomProgram& program);

// Says of every line of the program how many of it are essential, and moves essential tertiaries to the front.
void MarkEssentials(const Handbook& handbook, RoomProgram& program);

// Adds a remark for each essential that is not among the objects, before all other remarks. Objects may bear names that
// a stranger gave them.
void TellMissingEssentials(const RoomProgram& program, const Handbook& handbook, v1::ObjectList& list);

}  // namespace flair::language
