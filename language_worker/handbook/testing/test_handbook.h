// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: the handbook of the source tree, loaded once, and what it makes of a brief. What fails there fails the
// test that asks.
#pragma once

#include <cstdint>
#include <string>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

const Handbook& TheHandbook();

BriefFacts FactsOf(const std::string& text);

v1::Room RoomOf(const std::string& text, std::int64_t seed = 0);

}  // namespace flair::language
