// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/test_room.h"

#include <cstdio>
#include <cstdlib>

#include "language_worker/handbook/loading/load_handbook.h"

namespace flair::language {

RecordedRoom TestRoom(const std::string& name) {
  absl::StatusOr<RecordedRoom> room = ReadRecordedRoom(RecordedText(name));
  if (!room.ok()) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), room.status().ToString().c_str());
    std::abort();
  }
  return *std::move(room);
}

const Handbook& TestHandbook() {
  static const auto handbook = LoadHandbook(DefaultHandbookFolder());
  if (!handbook.ok()) std::abort();
  return **handbook;
}

}  // namespace flair::language
