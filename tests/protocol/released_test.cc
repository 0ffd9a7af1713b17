// SPDX-License-Identifier: GPL-3.0-or-later
// Packages flair.v1 and flair.handbook.v1 never break: what is in released.binpb stays valid, judged by buf. See
// docs/decisions/0016.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

fs::path Protos() { return fs::path(FLAIR_SOURCE_DIR) / "protos"; }
fs::path Released() { return fs::path(FLAIR_SOURCE_DIR) / "tests/protocol/released.binpb"; }

Finished Buf(const std::vector<std::string>& arguments) {
  static const NpmFolder npm("buf", fs::path(FLAIR_SOURCE_DIR) / "tests/protocol",
                             {"package.json", "package-lock.json"});
  // npm installs the one of the two that runs on this machine.
  const fs::path packages = npm.path() / "node_modules/@bufbuild";
  const fs::path x64 = packages / "buf-linux-x64/bin/buf";
  std::vector<std::string> command = {fs::exists(x64) ? x64 : packages / "buf-linux-aarch64/bin/buf"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return npm.Run(command);
}

Finished Breaking(const fs::path& protos) { return Buf({"breaking", protos, "--against", Released()}); }

TEST(ReleasedProtocol, LintFindsNothing) {
  const Finished lint = Buf({"lint", Protos()});
  EXPECT_EQ(lint.exit_code, 0) << lint.out << lint.err;
}

TEST(ReleasedProtocol, NothingInItBreaks) {
  const Finished breaking = Breaking(Protos());
  EXPECT_EQ(breaking.exit_code, 0) << breaking.out << breaking.err;
}

// What is added is promised from then on.
TEST(ReleasedProtocol, HoldsAllThatThePackagesHave) {
  const char* const update = std::getenv("FLAIR_UPDATE_GOLDENS");
  if (update != nullptr && std::string_view(update) == "1") {
    const Finished breaking = Breaking(Protos());
    ASSERT_EQ(breaking.exit_code, 0) << "a change that breaks is never released:\n" << breaking.out << breaking.err;
    WriteAll(Released(), ReadAll(FLAIR_CURRENT_PROTOCOL));
  }
  EXPECT_TRUE(ReadAll(Released()) == ReadAll(FLAIR_CURRENT_PROTOCOL))
      << Released() << " is older than the packages; once the change is reviewed:\n"
      << "FLAIR_UPDATE_GOLDENS=1 ./flair test --filter ReleasedProtocol";
}

// Or else the tests above would prove nothing.
struct Break {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
  const char* said;
};

void PrintTo(const Break& change, std::ostream* out) {
  *out << change.file << ": " << change.from << " -> " << change.to;
}

class Breaks : public ::testing::TestWithParam<Break> {};

TEST_P(Breaks, AreFoundAndNamed) {
  const Break& change = GetParam();
  const TestFolder folder;
  fs::copy(Protos(), folder / "protos", fs::copy_options::recursive);
  const fs::path path = folder / "protos" / "flair/v1" / change.file;
  std::string text = ReadAll(path);
  const size_t at = text.find(change.from);
  ASSERT_NE(at, std::string::npos) << path << " has no " << change.from;
  text.replace(at, std::string_view(change.from).size(), change.to);
  WriteAll(path, text);
  const Finished breaking = Breaking(folder / "protos");
  EXPECT_NE(breaking.exit_code, 0);
  EXPECT_THAT(breaking.out + breaking.err, HasSubstr(change.said));
}

INSTANTIATE_TEST_SUITE_P(
    ReleasedProtocol, Breaks,
    ::testing::Values(
        Break{"AnotherType", "brief.proto", "string text = 1;", "bytes text = 1;", "Field \"1\""},
        Break{"AnotherName", "brief.proto", "string text = 1;", "string words = 1;", "from \"text\" to \"words\""},
        Break{"AnotherNumber", "placement.proto", "double x_m = 2;", "double x_m = 9;", "\"2\" with name \"x_m\""},
        Break{"OneForMany", "room.proto", "repeated Wall walls = 4;", "Wall walls = 4;", "Field \"4\""},
        Break{"ACallLess", "optimizer_service.proto", "rpc Evaluate(EvaluateRequest) returns (EvaluateResponse);", "",
              "RPC \"Evaluate\""},
        Break{"AnotherValue", "preview.proto", "PREVIEW_FORMAT_PNG = 1;", "PREVIEW_FORMAT_JPG = 1;",
              "PREVIEW_FORMAT_PNG"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace flair::testing
