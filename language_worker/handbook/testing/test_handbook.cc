// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/testing/test_handbook.h"

#include <gtest/gtest.h>

#include "flair/v1/brief.pb.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/rooms/describe_room.h"

namespace flair::language {
namespace {

v1::Brief BriefOf(const std::string& text, std::int64_t seed) {
  v1::Brief brief;
  brief.set_text(text);
  brief.set_seed(seed);
  return brief;
}

}  // namespace

const Handbook& TheHandbook() {
  static const auto handbook = LoadHandbook(FLAIR_SOURCE_DIR "/language_worker/handbook/data");
  if (!handbook.ok()) ADD_FAILURE() << handbook.status();
  return **handbook;
}

BriefFacts FactsOf(const std::string& text) {
  const absl::StatusOr<BriefFacts> facts = ReadBrief(BriefOf(text, 0), TheHandbook());
  EXPECT_TRUE(facts.ok()) << text << ": " << facts.status();
  return facts.value_or(BriefFacts());
}

v1::Room RoomOf(const std::string& text, std::int64_t seed) {
  const absl::StatusOr<v1::Room> room = DescribeRoom(BriefOf(text, seed), TheHandbook());
  EXPECT_TRUE(room.ok()) << text << ": " << room.status();
  return room.value_or(v1::Room());
}

}  // namespace flair::language
