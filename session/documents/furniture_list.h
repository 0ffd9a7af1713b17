// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/solved_layout.pb.h"

namespace flair::session {

// What stands, lies and hangs in the room, as a table for spreadsheets (RFC 4180): those that are alike and in the same
// part of it in one row. Nothing in it is a formula.
std::string FurnitureCsv(const v1::SolvedLayout& layout);

}  // namespace flair::session
