// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <spdlog/sinks/ostream_sink.h>

#include <fstream>
#include <sstream>

#include "orchestrator/access/access_control.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Entry(const std::string& name, const std::string& token, const std::string& more = "") {
  return "tokens { name: \"" + name + "\" sha256: \"" + runtime::Sha256Hex(token) + "\" " + more + " }\n";
}

class Access : public ::testing::Test {
 protected:
  void Write(const std::string& text) {
    // As a new file, so that its stamp differs however little time has passed.
    const std::string fresh = path_ + ".new";
    std::ofstream(fresh) << text;
    std::rename(fresh.c_str(), path_.c_str());
  }
  void Open(const std::string& text) {
    Write(text);
    auto access = AccessControl::Open(path_, clock_, logger_);
    ASSERT_TRUE(access.ok()) << access.status();
    access_ = *std::move(access);
  }
  absl::Status Problem(const std::string& text) {
    Write(text);
    return ReadTokenList(path_).status();
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/tokens.textproto";
  runtime::FakeClock clock_;
  std::ostringstream log_;
  std::shared_ptr<spdlog::logger> logger_ =
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(log_));
  std::unique_ptr<AccessControl> access_;
};

TEST_F(Access, WithoutAFileEverybodyMayDoEverything) {
  const auto access = AccessControl::Open("", clock_, logger_);
  const auto caller = (*access)->Admit(std::nullopt);
  EXPECT_EQ(caller->name, "");
  EXPECT_TRUE(caller->MaySee("alice"));
  EXPECT_EQ(caller->OwnerFilter(), std::nullopt);
  EXPECT_EQ(caller->RequestKey("r1"), "r1");
}

TEST_F(Access, ATokenIsGoodUntilItsLastDayIsOver) {
  const absl::Time begin = absl::FromCivil(absl::CivilDay(2027, 12, 31), absl::UTCTimeZone());
  clock_.Advance(begin - clock_.Now());
  Open(Entry("alice", "secret-a", "last_day: \"2027-12-31\"") + Entry("bob", "secret-b"));
  clock_.Advance(absl::Hours(24) - absl::Seconds(1));
  EXPECT_TRUE(access_->Admit("Bearer secret-a").ok());
  clock_.Advance(absl::Seconds(1));
  EXPECT_EQ(access_->Admit("Bearer secret-a").status(),
            absl::UnauthenticatedError("the token of \"alice\" was good until 2027-12-31; ask for a new one"));
  EXPECT_TRUE(access_->Admit("Bearer secret-b").ok());
  EXPECT_THAT(std::string(Problem(Entry("alice", "secret-a", "last_day: \"31.12.2027\"")).message()),
              HasSubstr("tokens[0].last_day: \"31.12.2027\" is no day; expected one such as \"2027-12-31\""));
}

TEST_F(Access, ATokenSaysWhoCalls) {
  Open(Entry("alice", "secret-a", "open_job_limit: 7") + Entry("root", "secret-r", "operator: true"));
  const auto alice = access_->Admit("Bearer secret-a");
  ASSERT_TRUE(alice.ok()) << alice.status();
  EXPECT_EQ(alice->name, "alice");
  EXPECT_EQ(alice->open_job_limit, 7);
  EXPECT_TRUE(alice->MaySee("alice"));
  EXPECT_FALSE(alice->MaySee("bob"));
  EXPECT_FALSE(alice->MaySee(""));
  EXPECT_EQ(alice->OwnerFilter(), "alice");
  EXPECT_EQ(alice->RequestKey("r1"), "alice/r1");
  EXPECT_EQ(alice->CheckOperator("GetCluster").code(), absl::StatusCode::kPermissionDenied);
  const auto root = access_->Admit("bearer secret-r");
  EXPECT_TRUE(root->MaySee("alice"));
  EXPECT_TRUE(root->CheckOperator("GetCluster").ok());
}

TEST_F(Access, RefusesEverythingElseWithoutRepeatingIt) {
  Open(Entry("alice", "secret-a"));
  for (const char* header : {"Bearer secret-b", "Bearer ", "Bearer  secret-a", "Bearer secret-a ", "Basic secret-a",
                             "secret-a", "", "Bearersecret-a", "Bearer SECRET-A"}) {
    const absl::Status status = access_->Admit(header).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kUnauthenticated) << header;
    EXPECT_THAT(std::string(status.message()), Not(HasSubstr("secret"))) << header;
  }
  EXPECT_EQ(access_->Admit(std::nullopt).status().code(), absl::StatusCode::kUnauthenticated);
  EXPECT_EQ(access_->Admit("Bearer " + std::string(100000, 'x')).status().code(), absl::StatusCode::kUnauthenticated);
  EXPECT_EQ(access_->Admit("Bearer " + runtime::Sha256Hex("secret-a")).status().code(),
            absl::StatusCode::kUnauthenticated);
}

TEST_F(Access, CallsAMinuteAreLimitedByName) {
  Open(Entry("alice", "old", "calls_per_minute_limit: 2") + Entry("alice", "new", "calls_per_minute_limit: 2") +
       Entry("bob", "b", "calls_per_minute_limit: 2"));
  EXPECT_TRUE(access_->Admit("Bearer old").ok());
  EXPECT_TRUE(access_->Admit("Bearer new").ok());
  const absl::Status third = access_->Admit("Bearer old").status();
  EXPECT_EQ(third.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(third.message()), AllOf(HasSubstr("\"alice\""), HasSubstr("2 calls"), HasSubstr("30 s")));
  EXPECT_TRUE(access_->Admit("Bearer b").ok());
  clock_.Advance(absl::Seconds(30));
  EXPECT_TRUE(access_->Admit("Bearer old").ok());
  EXPECT_FALSE(access_->Admit("Bearer old").ok());
  clock_.Advance(absl::Hours(10));
  EXPECT_TRUE(access_->Admit("Bearer old").ok());
  EXPECT_TRUE(access_->Admit("Bearer old").ok());
  EXPECT_FALSE(access_->Admit("Bearer old").ok());
}

TEST_F(Access, TheFileIsReadAgainWhenItChanges) {
  Open(Entry("alice", "old"));
  Write(Entry("alice", "new"));
  EXPECT_TRUE(access_->Admit("Bearer old").ok());
  clock_.Advance(absl::Seconds(2));
  EXPECT_FALSE(access_->Admit("Bearer old").ok());
  EXPECT_TRUE(access_->Admit("Bearer new").ok());
}

TEST_F(Access, AFileThatBecomesBadIsLoggedAndChangesNothing) {
  Open(Entry("alice", "a"));
  Write("tokens { name: \"alice\" sha256: \"short\" }");
  clock_.Advance(absl::Seconds(2));
  EXPECT_TRUE(access_->Admit("Bearer a").ok());
  EXPECT_THAT(log_.str(), AllOf(HasSubstr("tokens_path"), HasSubstr(path_ + ":1: tokens[0].sha256: expected")));
  std::remove(path_.c_str());
  clock_.Advance(absl::Seconds(2));
  EXPECT_TRUE(access_->Admit("Bearer a").ok());
}

TEST_F(Access, OpenJobsAreLimited) {
  const Caller caller = {.name = "alice", .sees_all = false, .open_job_limit = 10};
  EXPECT_TRUE(caller.CheckOpenJobs(9, 1).ok());
  const absl::Status status = caller.CheckOpenJobs(9, 2);
  EXPECT_EQ(status.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(status.message()), AllOf(HasSubstr("9 of your jobs"), HasSubstr("limit of 10")));
  EXPECT_TRUE(Caller().CheckOpenJobs(1000000, 1).ok());
}

TEST_F(Access, NamesWhatIsWrongInTheFile) {
  const auto message = [&](const std::string& text) { return std::string(Problem(text).message()); };
  EXPECT_THAT(message(""), HasSubstr("tokens: there are none"));
  EXPECT_THAT(message(Entry("a", "1") + Entry("a/b", "2")), HasSubstr(path_ + ":2: tokens[1].name: expected 1 to 64"));
  EXPECT_THAT(message("tokens { name: \"a\" sha256: \"hunter2\" }"),
              AllOf(HasSubstr("tokens[0].sha256: expected"), Not(HasSubstr("hunter2"))));
  EXPECT_THAT(message(Entry("a", "1") + Entry("b", "1")), HasSubstr("tokens[1].sha256: is also that of tokens[0]"));
  EXPECT_THAT(message(Entry("a", "1") + Entry("a", "2", "operator: true")), HasSubstr("tokens[1]: has other limits"));
  EXPECT_THAT(message(Entry("a", "1", "open_job_limit: -1")), HasSubstr("tokens[0].open_job_limit: -1"));
  EXPECT_THAT(message(Entry("a", "1", "calls_per_minute_limit: 2000000")), HasSubstr("calls_per_minute_limit"));
  EXPECT_EQ(ReadTokenList(path_ + ".none").status().code(), absl::StatusCode::kNotFound);
}

}  // namespace
}  // namespace flair::orchestrator
