// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: rooms in the recorded format, written for them.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "language_worker/handbook/handbook.h"
#include "language_worker/recorded/recorded_room.h"

namespace flair::language {

// The text of testdata/NAME.json.
inline std::string RecordedText(const std::string& name) {
  std::ifstream file(std::string(FLAIR_SOURCE_DIR "/language_worker/recorded/testdata/") + name + ".json");
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// The room; ends the test program when it cannot be read.
RecordedRoom TestRoom(const std::string& name);
const Handbook& TestHandbook();

}  // namespace flair::language
