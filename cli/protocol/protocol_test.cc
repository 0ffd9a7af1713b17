// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/protocol/protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ProtocolText, FindsServicesCallsMessagesAndEnumsInAnyCase) {
  EXPECT_THAT(ProtocolEntryText("optimizerservice").value(), StartsWith("service OptimizerService\n"));
  EXPECT_THAT(ProtocolEntryText("solve").value(), HasSubstr("Solve(SolveRequest) -> SolveResponse\n"));
  EXPECT_THAT(ProtocolEntryText("Room").value(), HasSubstr("\n  walls = 4: list of Wall\n      One per edge"));
  EXPECT_THAT(ProtocolEntryText("OPENINGKIND").value(), HasSubstr("\n  OPENING_KIND_DOOR = 1\n"));
  EXPECT_EQ(ProtocolEntryText("Table").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ProtocolEntryText("").status().code(), absl::StatusCode::kNotFound);
}

TEST(ProtocolText, TheOverviewNamesEveryCall) {
  const std::string overview = ProtocolOverview();
  for (const char* name : {"DescribeRoom", "Translate", "SolveRestarts", "ExportScene", "WatchJob", "GetWorker"}) {
    EXPECT_THAT(overview, HasSubstr(std::string("\n  ") + name + " "));
  }
}

}  // namespace
}  // namespace flair::cli
