// SPDX-License-Identifier: GPL-3.0-or-later
// Tokens and keys are where they belong and nowhere else.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/security/secure_programs.h"
#include "worker_runtime/files/files.h"

namespace flair::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr char kText[] = "A bedroom that is 3m x 4m.";
constexpr char kToken[] = "flair_secret-of-alice-0123456789abcdefghijklm";

// Every file below a folder, without those that hold the secrets by right.
std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() != ".key" && entry.path().extension() != ".token") {
      files.push_back(entry.path());
    }
  }
  return files;
}

// A line of the key that is in no other file.
std::string SecretOf(const std::filesystem::path& key_file) {
  const std::string text = ReadAll(key_file);
  const size_t first = text.find('\n') + 1;
  return text.substr(first, text.find('\n', first) - first);
}

TEST(Secrets, AreInNoLogErrorArtifactOrArgument) {
  SecurePrograms programs(TokenEntry("alice", kToken), "debug");
  const std::string token_file = programs.folder() / "alice.token";
  WriteAll(token_file, std::string(kToken) + "\n");
  const std::string wrong_file = programs.folder() / "wrong.token";
  WriteAll(wrong_file, "flair_secret-of-nobody-0123456789abcdefghijk");

  std::vector<std::string> design = {"design", kText, "--out", programs.folder() / "out"};
  std::ranges::copy(programs.Flags(token_file), std::back_inserter(design));
  const Finished designed = RunProgram("flair", design);
  EXPECT_EQ(designed.exit_code, 0) << designed.err;
  std::vector<std::string> jobs = {"jobs"};
  std::ranges::copy(programs.Flags(wrong_file), std::back_inserter(jobs));
  const Finished refused = RunProgram("flair", jobs);
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.err, HasSubstr("this orchestrator does not know the token"));

  std::vector<std::string> said = {designed.out + designed.err, refused.out + refused.err};
  for (ServerProgram* program : programs.programs()) {
    said.push_back(ReadAll("/proc/" + std::to_string(program->process().pid()) + "/cmdline"));
    program->process().Signal(SIGTERM);
    const Finished finished = program->process().Wait();
    EXPECT_NE(finished.err, "") << "nothing was logged";
    said.push_back(finished.out + finished.err);
  }
  for (const auto& file : FilesBelow(programs.folder())) said.push_back(ReadAll(file));
  EXPECT_GT(said.size(), 30u);
  std::vector<std::string> secrets = {"secret-of-"};
  for (const char* name : {"language", "orchestrator"}) {
    secrets.push_back(SecretOf(programs.folder() / (std::string(name) + ".key")));
  }
  for (const std::string& text : said) {
    for (const std::string& secret : secrets) {
      EXPECT_EQ(text.find(secret), std::string::npos) << text.substr(0, 200);
    }
  }
}

TEST(Secrets, ATokenIsMadeOnceAndShownOnce) {
  const TestFolder folder;
  const std::string file = folder / "alice.token";
  const Finished made = RunProgram(
      "flair", {"token", "new", "alice", "--token-out", file, "--open-jobs", "5", "--calls-per-minute", "60"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string token = ReadAll(file).substr(0, ReadAll(file).find('\n'));
  EXPECT_THAT(token, StartsWith("flair_"));
  EXPECT_GE(token.size(), 48u);
  EXPECT_THAT(made.out, AllOf(HasSubstr("name: \"alice\""), HasSubstr(runtime::Sha256Hex(token)),
                              HasSubstr("open_job_limit: 5"), HasSubstr("calls_per_minute_limit: 60")));
  EXPECT_THAT(made.out + made.err, Not(HasSubstr(token)));
  struct stat permissions = {};
  ASSERT_EQ(::stat(file.c_str(), &permissions), 0);
  EXPECT_EQ(permissions.st_mode & 0777, 0600);
  EXPECT_NE(RunProgram("flair", {"token", "new", "bob", "--token-out", file}).exit_code, 0);
  EXPECT_EQ(ReadAll(file).substr(0, token.size()), token);

  const Finished shown = RunProgram("flair", {"token", "new", "bob"});
  EXPECT_THAT(shown.out, Not(HasSubstr("flair_")));
  EXPECT_THAT(shown.err, HasSubstr("flair_"));
  EXPECT_NE(RunProgram("flair", {"token", "new", "bob"}).err, shown.err);
  const Finished bad = RunProgram("flair", {"token", "new", "a/b"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("tokens[0].name: expected 1 to 64 letters"));
}

TEST(Secrets, FlagsThatCannotBeUsedAreNamedWithoutTheSecret) {
  const TestFolder folder;
  WriteAll(folder / "two.token", "secret one\nsecret two\n");
  WriteAll(folder / "empty.token", "\n");
  const auto jobs = [](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"jobs", "--orchestrator", "127.0.0.1:1"});
    const Finished finished = RunProgram("flair", flags);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    return finished.err;
  };
  const std::string two = folder / "two.token";
  EXPECT_THAT(jobs({"--token-file", two}),
              AllOf(HasSubstr("--token-file " + two + ": not a token"), Not(HasSubstr("secret"))));
  EXPECT_THAT(jobs({"--token-file", folder / "empty.token"}), HasSubstr("holds no token"));
  EXPECT_THAT(jobs({"--token-file", folder / "none"}), HasSubstr("cannot be read"));
  EXPECT_THAT(jobs({"--tls-authority", two}), HasSubstr("--tls-authority: " + two + ": holds no certificate"));
  EXPECT_THAT(jobs({"--tls-certificate", two}), HasSubstr("--tls-certificate " + two + ": needs --tls-key too"));
  const Finished plain = RunProgram("flair", {"jobs", "--orchestrator", "10.1.2.3:50050"}, {{"FLAIR_TOKEN", kToken}});
  EXPECT_EQ(plain.exit_code, 2);
  EXPECT_THAT(plain.err, AllOf(HasSubstr("the token in plain text"), Not(HasSubstr("secret"))));
}

}  // namespace
}  // namespace flair::testing
