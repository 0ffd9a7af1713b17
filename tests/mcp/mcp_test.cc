// SPDX-License-Identifier: GPL-3.0-or-later
// flair mcp before the clients that the protocol's makers publish; see mcp.mjs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

TEST(OfficialClients, DesignEditExplainDrawWriteAndCancel) {
  const NpmFolder clients("mcp_clients", std::filesystem::path(FLAIR_SOURCE_DIR) / "tests/mcp",
                          {"package.json", "package-lock.json", "mcp.mjs"});
  const TestFolder folder;
  const Finished finished = clients.Run(
      {"node", (clients.path() / "mcp.mjs").string(), ProgramPath("flair").string(), folder.path().string()});
  EXPECT_EQ(finished.exit_code, 0) << finished.out << finished.err;
}

}  // namespace
}  // namespace flair::testing
