// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// Brings what the brief asks for into the program of its kind of room: wishes with the seats that belong to them, what
// it refuses, one piece for each person, and nothing else where it says so.
void ApplyWishes(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program);

}  // namespace flair::language
