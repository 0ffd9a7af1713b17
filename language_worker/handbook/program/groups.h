// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// How many can sit round a table of that size: 0.6 m each along its sides, one at each end that is wide enough; round
// ones by their circumference.
int SeatsRound(const hb::Furniture& table, double width_m, double depth_m);

// The least width from `start_m` on at which that many can sit round a table of that depth.
double WidthForSeats(const hb::Furniture& table, int seats, double start_m, double depth_m);

// Says which seats belong to which pieces, takes as many tables as the people need, and gives every table with its
// chairs, and every row of what stands in rows, a zone of its own: they are placed together.
void SplitIntoGroups(double area_m2, const Handbook& handbook, RoomProgram& program);

}  // namespace flair::language
