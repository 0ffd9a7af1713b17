// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/batch_flags.h"

#include <gtest/gtest.h>

namespace flair::cli {
namespace {

TEST(BatchFlags, AFolderRemembersServersWithoutTheirCredentials) {
  BatchFlags flags;
  flags.engine.address = "nats://user:secret@one:4222,nats://two:4222";
  BatchPlace place;
  FillPlace(flags, place);
  EXPECT_EQ(place.engine, "nats://one:4222,nats://two:4222");
  EXPECT_EQ(place.store, "") << "elsewhere";
}

}  // namespace
}  // namespace flair::cli
