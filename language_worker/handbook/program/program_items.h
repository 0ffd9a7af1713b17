// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// Questions to a program that is being made.

// Whether a class stands on the floor and is not walked over.
bool IsFloorPiece(const hb::Furniture& furniture);

bool Lists(const std::vector<ProgramItem>& items, const std::string& name);
bool Lists(const RoomProgram& program, const std::string& name);

bool HasZone(const RoomProgram& program, const std::string& name);

// The zone where a class belongs when nothing says so; empty when there are none.
std::string HomeOf(const hb::Furniture& furniture, const RoomProgram& program);

// How many can sit, or lie, on a piece of its usual size; 0 when it is for none.
int PlacesOn(const hb::Furniture& furniture);

// Takes a class out of a program.
void Remove(const std::string& name, RoomProgram& program);

}  // namespace flair::language
