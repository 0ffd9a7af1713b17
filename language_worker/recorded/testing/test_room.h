// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: rooms in the recorded format, written for them.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/recorded/recorded_room.h"

namespace flair::language {

// The text of testdata/NAME.json.
inline std::string RecordedText(const std::string& name) {
  std::ifstream file(std::string(FLAIR_SOURCE_DIR "/language_worker/recorded/testdata/") + name + ".json");
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// The room; ends the test program when it cannot be read.
inline RecordedRoom TestRoom(const std::string& name) {
  absl::StatusOr<RecordedRoom> room = ReadRecordedRoom(RecordedText(name));
  if (!room.ok()) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), room.status().ToString().c_str());
    std::abort();
  }
  return *std::move(room);
}

inline const Handbook& TestHandbook() {
  static const auto handbook = LoadHandbook(DefaultHandbookFolder());
  if (!handbook.ok()) std::abort();
  return **handbook;
}

}  // namespace flair::language
