// SPDX-License-Identifier: GPL-3.0-or-later
// Who may call the orchestrator and what they see there: five real programs with TLS, callers with tokens.
#include <gmock/gmock.h>

#include "tests/security/attacks.h"
#include "tests/security/secure_programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kText[] = "A bedroom that is 3m x 4m.";
constexpr char kAlice[] = "flair_token-of-alice-0123456789abcdefghijklmn";
constexpr char kBob[] = "flair_token-of-bob-0123456789abcdefghijklmnop";
constexpr char kRoot[] = "flair_token-of-root-0123456789abcdefghijklmno";

class Tokens : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    programs_ = new SecurePrograms(TokenEntry("alice", kAlice) + TokenEntry("bob", kBob) +
                                   TokenEntry("root", kRoot, "operator: true"));
  }
  static void TearDownTestSuite() {
    delete programs_;
    programs_ = nullptr;
  }
  static OrchestratorCaller Caller(const std::string& token) {
    return {programs_->orchestrator(), programs_->With(token)};
  }

  static SecurePrograms* programs_;
};

SecurePrograms* Tokens::programs_ = nullptr;

TEST_F(Tokens, NothingIsAnsweredWithoutOne) {
  for (const std::string token : {"", "flair_token-of-nobody-0123456789abcdefghijk"}) {
    OrchestratorCaller stranger = Caller(token);
    auto answers = stranger.AskAbout("j", "b", std::string(64, 'a'));
    answers.merge(stranger.AskForAny());
    EXPECT_EQ(answers.size(), 19u);
    for (const auto& [rpc, status] : answers) {
      EXPECT_EQ(status.code(), absl::StatusCode::kUnauthenticated) << rpc << " with \"" << token << "\": " << status;
      EXPECT_THAT(std::string(status.message()), Not(HasSubstr("nobody"))) << rpc;
    }
  }
}

TEST_F(Tokens, WhatIsAnothersIsNotThere) {
  OrchestratorCaller alice = Caller(kAlice);
  const auto queued = alice.CreateJob(kText, "r1");
  ASSERT_TRUE(queued.ok()) << queued.status();
  EXPECT_EQ(queued->owner(), "alice");
  const auto job = alice.EndOf(queued->id());
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->state(), v1::JOB_STATE_SUCCEEDED) << job->error();
  const auto batch = alice.CreateBatch(kText, "b1");
  ASSERT_TRUE(batch.ok()) << batch.status();
  const std::string artifact = job->artifacts(job->artifacts_size() - 1).id();

  OrchestratorCaller bob = Caller(kBob);
  const auto hidden = bob.AskAbout(job->id(), batch->id(), artifact);
  // Word for word what is said of things that never were.
  const std::string nothing(64, 'f');
  const auto nowhere = bob.AskAbout("20200101T000000-none", "20200101T000000-none", nothing);
  const auto with_its_id = [&](std::string message, const std::string& id) {
    const size_t at = message.find(id);
    return at == std::string::npos ? message : message.replace(at, id.size(), "ID");
  };
  for (const auto& [rpc, status] : hidden) {
    EXPECT_EQ(status.code(), absl::StatusCode::kNotFound) << rpc << ": " << status;
    const std::string id = rpc == "GetArtifact"                     ? artifact
                           : rpc.find("Batch") != std::string::npos ? batch->id()
                                                                    : job->id();
    const std::string other = rpc == "GetArtifact" ? nothing : "20200101T000000-none";
    EXPECT_EQ(with_its_id(std::string(status.message()), id),
              with_its_id(std::string(nowhere.at(rpc).message()), other))
        << rpc;
  }
  EXPECT_EQ(bob.ListJobs()->jobs_size(), 0);
  EXPECT_EQ(bob.ListBatches()->batches_size(), 0);
  EXPECT_GE(alice.ListJobs()->jobs_size(), 1);

  // The same request id is another request.
  const auto own = bob.CreateJob(kText, "r1");
  ASSERT_TRUE(own.ok()) << own.status();
  EXPECT_NE(own->id(), job->id());
  EXPECT_EQ(own->owner(), "bob");

  OrchestratorCaller root = Caller(kRoot);
  for (const auto& [rpc, status] : root.AskAbout(job->id(), batch->id(), artifact)) {
    EXPECT_NE(status.code(), absl::StatusCode::kNotFound) << rpc << ": " << status;
    EXPECT_NE(status.code(), absl::StatusCode::kUnauthenticated) << rpc;
  }
}

TEST_F(Tokens, OnlyOperatorsSeeTheCluster) {
  EXPECT_EQ(Caller(kAlice).AskForAny().at("GetCluster").code(), absl::StatusCode::kPermissionDenied);
  const absl::Status root = Caller(kRoot).AskForAny().at("GetCluster");
  EXPECT_TRUE(root.ok()) << root;
}

TEST_F(Tokens, IdsReachNoFile) {
  // Beside the store, where a way out of its folders would lead to.
  WriteAll(programs_->folder() / "secret.pb", "secret");
  const std::vector<std::string> ids = {"../secret",
                                        "../../secret.pb",
                                        programs_->folder() / "secret.pb",
                                        "/etc/passwd",
                                        "..",
                                        ".",
                                        "",
                                        std::string("a\0b", 3),
                                        std::string(100000, 'a'),
                                        "a/../../secret",
                                        "..\\secret",
                                        "%2e%2e%2fsecret",
                                        "file:///etc/passwd",
                                        "~/.ssh/id_rsa",
                                        "\n\r\x1b[31m",
                                        std::string(64, 'A'),
                                        "' OR 1=1 --"};
  for (const char* token : {kAlice, kRoot}) {
    OrchestratorCaller caller = Caller(token);
    for (const std::string& id : ids) {
      for (const auto& [rpc, status] : caller.AskAbout(id, id, id)) {
        EXPECT_TRUE(absl::IsNotFound(status) || absl::IsInvalidArgument(status))
            << rpc << " of \"" << id.substr(0, 40) << "\": " << status;
        EXPECT_LT(status.message().size(), 1000u) << rpc;
      }
    }
  }
}

TEST(Quota, CallsAMinuteAndOpenJobsAreLimitedPerCaller) {
  SecurePrograms programs(TokenEntry("calls", kAlice, "calls_per_minute_limit: 3") +
                          TokenEntry("jobs", kBob, "open_job_limit: 1"));
  OrchestratorCaller calls(programs.orchestrator(), programs.With(kAlice));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(calls.ListJobs().ok()) << i;
  const absl::Status fourth = calls.ListJobs().status();
  EXPECT_EQ(fourth.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(fourth.message()), HasSubstr("\"calls\" has made the 3 calls a minute that it may"));

  OrchestratorCaller jobs(programs.orchestrator(), programs.With(kBob));
  const absl::Status two = jobs.CreateBatch(kText, "two", 2).status();
  EXPECT_EQ(two.code(), absl::StatusCode::kResourceExhausted) << two;
  EXPECT_THAT(std::string(two.message()), HasSubstr("limit of 1 for \"jobs\""));
  const auto one = jobs.CreateBatch(kText, "one", 1);
  ASSERT_TRUE(one.ok()) << one.status();
  // Whoever asks again, because no answer came, gets what there is.
  const auto again = jobs.CreateBatch(kText, "one", 1);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->id(), one->id());
}

}  // namespace
}  // namespace flair::testing
