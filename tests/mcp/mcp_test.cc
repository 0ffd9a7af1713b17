// SPDX-License-Identifier: GPL-3.0-or-later
// flair mcp before the clients that the protocol's makers publish; see mcp.mjs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

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

// A checkout whose machine lacks a package and whose flair is not built, with tools that read all they get and say
// much.
TEST(FirstStart, LeavesStandardInputAndOutputToTheProgram) {
  namespace fs = std::filesystem;
  const TestFolder folder;
  const fs::path root = folder / "checkout", tools = folder / "tools";
  const auto write = [](const fs::path& path, const std::string& content) {
    fs::create_directories(path.parent_path());
    WriteAll(path, "#!/bin/sh\n" + content);
    fs::permissions(path, fs::perms::owner_all);
  };
  fs::create_directories(root / "cmake");
  fs::copy_file(fs::path(FLAIR_SOURCE_DIR) / "flair", root / "flair");
  WriteAll(root / "cmake/packages.txt", "some-package\n");
  const std::string greedy = "cat\necho \"$0 says much\"\n";
  write(tools / "dpkg-query", "exit 1\n");
  write(tools / "sudo", greedy + "exec \"$@\"\n");
  write(tools / "apt-get", greedy);
  write(tools / "cmake", greedy + "touch build/release/build.ninja\n");
  write(tools / "ninja",
        greedy + "mkdir -p \"$2/bin\"; cp \"" + (tools / "program").string() + "\" \"$2/bin/flair\"\n");
  write(tools / "program", "echo \"$@\"; cat\n");
  Process process("/bin/sh", {"-c", "printf 'first\\nsecond\\n' | '" + (root / "flair").string() + "' mcp --root ."},
                  {{"PATH", tools.string() + ":" + std::getenv("PATH")}, {"FLAIR_PRESET", "release"}});
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "mcp --root .\nfirst\nsecond\n") << finished.err;
  EXPECT_THAT(finished.err, ::testing::HasSubstr("installing 1 Debian packages"));
}

}  // namespace
}  // namespace flair::testing
