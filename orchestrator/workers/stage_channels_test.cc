// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_channels.h"

#include <gmock/gmock.h>

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Addresses, AreListedWithCommas) {
  const StageAddresses addresses = *ParseStageAddresses("a:1, 10.0.0.1:2,unix:/run/x,dns:///workers:50053,[::1]:7");
  EXPECT_THAT(addresses.workers, ElementsAre("a:1", "10.0.0.1:2", "unix:/run/x", "[::1]:7"));
  ASSERT_EQ(addresses.names.size(), 1u);
  EXPECT_EQ(addresses.names[0].host, "workers");
  EXPECT_EQ(addresses.names[0].port, 50053);
}

TEST(Addresses, OfOtherFormsAreNamed) {
  for (const char* bad : {"", "a", "a:", ":1", "a:0", "a:65536", "a:1x", "unix:", "dns:///", "dns:///a", "dns:///:1",
                          "http://a:1", "dns://server/a:1", "a:1,", "a:1,,b:2"}) {
    const absl::Status status = ParseStageAddresses(bad).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << bad;
    EXPECT_THAT(std::string(status.message()), HasSubstr("expected HOST:PORT, unix:PATH or dns:///NAME:PORT")) << bad;
  }
}

TEST(Addresses, OfTheMachineItselfAreKnown) {
  EXPECT_THAT(*LookUpHost("127.0.0.3"), ElementsAre("127.0.0.3"));
  EXPECT_THAT(*LookUpHost("localhost"), ::testing::Contains("127.0.0.1"));
  EXPECT_EQ(LookUpHost("no-such-name.invalid").status().code(), absl::StatusCode::kUnavailable);
}

TEST(Addresses, HaveBracketsWhereTheyHaveColons) {
  EXPECT_EQ(JoinHostPort("10.0.0.1", 7), "10.0.0.1:7");
  EXPECT_EQ(JoinHostPort("fd00::7", 7), "[fd00::7]:7");
}

}  // namespace
}  // namespace flair::orchestrator
