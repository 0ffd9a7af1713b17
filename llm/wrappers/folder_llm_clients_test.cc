// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept in folders: the files, and the clients that cache, record and replay.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "llm/testing/test_llm_client.h"
#include "llm/wrappers/llm_wrappers.h"

namespace flair::llm {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class AnswerFolderTest : public ::testing::Test {
 protected:
  AnswerFolderTest() {
    char name[] = "/tmp/flair_answers_XXXXXX";
    path_ = ::mkdtemp(name);
  }
  ~AnswerFolderTest() override { std::filesystem::remove_all(path_); }

  static ChatAnswer Answer(const std::string& text) {
    ChatAnswer answer;
    answer.text = text;
    answer.finish = FinishReason::kLength;
    answer.model = "m-2024";
    answer.usage = {1234, 56, 7, true};
    answer.cost_usd = 0.0123456789012345;
    return answer;
  }
  static void ExpectSame(const ChatAnswer& a, const ChatAnswer& b) {
    EXPECT_EQ(RecordJson({}, a), RecordJson({}, b));
    EXPECT_EQ(a.cost_usd, b.cost_usd);
  }
  // Asks, letting `model` answer with `text` when it is asked at all.
  static absl::StatusOr<ChatAnswer> Ask(LlmClient& client, const ChatRequest& request, TestLlmClient* model,
                                        const std::string& text) {
    runtime::CallContext call;
    if (model != nullptr) model->answer = [&text](size_t) { return Answer(text); };
    return client.Ask(request, call);
  }

  std::string path_;
};

TEST_F(AnswerFolderTest, GivesBackWhatWasPutToTheBit) {
  const AnswerFolder folder(path_ + "/new/folder");
  ASSERT_TRUE(folder.Put(AskFor("zones"), Answer("{\"a\": \"\\u00e9 \xc3\xa9\"}\n")).ok());
  const auto found = folder.Find(AskFor("zones"));
  ASSERT_TRUE(found.ok() && found->has_value()) << found.status();
  ExpectSame(**found, Answer("{\"a\": \"\\u00e9 \xc3\xa9\"}\n"));
}

TEST_F(AnswerFolderTest, KeepsTheFirstAnswerToARequest) {
  const AnswerFolder folder(path_);
  ASSERT_TRUE(folder.Put(AskFor("zones"), Answer("first")).ok());
  EXPECT_EQ(folder.Put(AskFor("zones"), Answer("second"))->text, "first");
}

TEST_F(AnswerFolderTest, WhateverDecidesTheAnswerMakesAnotherFile) {
  const ChatRequest request = AskFor("zones");
  std::vector<ChatRequest> others(6, request);
  others[0].messages[0].text += " ";
  others[1].messages[0].role = Role::kSystem;
  others[2].schema = "{}";
  others[3].schema_name = "x";
  others[4].max_output_token_count = 5;
  others[5].seed = 1;
  for (const ChatRequest& other : others) EXPECT_NE(AnswerFolder::FileName(request), AnswerFolder::FileName(other));
}

TEST_F(AnswerFolderTest, FileNamesStayInTheFolderWhateverTheStep) {
  for (const char* step : {"../../etc/passwd", "/abs", "a/b", "", "...", "\n\xff", "objects.floor/repair"}) {
    ChatRequest request = AskFor("x");
    request.step = step;
    const std::string name = AnswerFolder::FileName(request);
    EXPECT_EQ(name.find('/'), std::string::npos) << name;
    EXPECT_NE(name.front(), '.') << name;
  }
}

TEST_F(AnswerFolderTest, ADamagedFileIsAnErrorThatNamesFileAndField) {
  const AnswerFolder folder(path_);
  const std::string file = path_ + "/" + AnswerFolder::FileName(AskFor("zones"));
  const std::string good = RecordJson(AskFor("zones"), Answer("x"));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "JSON object"},
      {good.substr(0, good.size() / 2), "JSON object"},
      {"[1]", "JSON object"},
      {"{}", "answer: expected an object"},
      {R"({"answer": {"text": 5}})", "answer.text: expected a text"},
      {R"({"answer": {"text": "", "finish": "x", "model": "", "cost_usd": 0, "usage": {}}})", "answer.finish"},
      {R"({"answer": {"text": "", "finish": "stop", "model": "", "cost_usd": 0, "usage": {"input_token_count": -1}}})",
       "answer.usage.input_token_count"}};
  for (const auto& [text, expected] : cases) {
    std::ofstream(file) << text;
    const auto found = folder.Find(AskFor("zones"));
    EXPECT_TRUE(absl::IsDataLoss(found.status())) << text;
    EXPECT_THAT(std::string(found.status().message()), HasSubstr(file));
    EXPECT_THAT(std::string(found.status().message()), HasSubstr(expected));
  }
}

TEST_F(AnswerFolderTest, ARecordingReplaysAndAMissingAnswerNamesItsRequest) {
  auto* model = new TestLlmClient();
  auto recording = MakeRecordingClient(std::unique_ptr<LlmClient>(model), path_);
  ASSERT_TRUE(recording.ok()) << recording.status();
  const auto asked = Ask(**recording, AskFor("zones"), model, "yes");
  ASSERT_TRUE(asked.ok()) << asked.status();
  auto replaying = MakeReplayingClient(path_);
  ASSERT_TRUE(replaying.ok()) << replaying.status();
  EXPECT_EQ((*replaying)->identity(), "held@test");
  ExpectSame(*Ask(**replaying, AskFor("zones"), nullptr, ""), *asked);
  const absl::Status missing = Ask(**replaying, AskFor("style"), nullptr, "").status();
  EXPECT_TRUE(absl::IsNotFound(missing));
  EXPECT_THAT(std::string(missing.message()), HasSubstr("\"style\""));
  EXPECT_THAT(std::string(missing.message()), HasSubstr(AnswerFolder::FileName(AskFor("style"))));
}

TEST_F(AnswerFolderTest, FilesOfRequestsWithoutASeedAreNamedAsBeforeThereWereSeeds) {
  EXPECT_EQ(AnswerFolder::FileName(AskFor("zones")), "zones-e6b24ea649792278.json");
}

TEST_F(AnswerFolderTest, ARecordingOfOneSeedIsNoneOfAnotherButOneWithoutASeedIsOfAny) {
  ChatRequest seven = AskFor("zones"), eight = AskFor("zones");
  seven.seed = 7;
  eight.seed = 8;
  const AnswerFolder folder(path_);
  ASSERT_TRUE(folder.ClaimFor("held@test").ok());
  ASSERT_TRUE(folder.Put(seven, Answer("of seven")).ok());
  auto replaying = MakeReplayingClient(path_);
  ASSERT_TRUE(replaying.ok()) << replaying.status();
  EXPECT_EQ(Ask(**replaying, seven, nullptr, "")->text, "of seven");
  const absl::Status missing = Ask(**replaying, eight, nullptr, "").status();
  EXPECT_TRUE(absl::IsNotFound(missing));
  EXPECT_THAT(std::string(missing.message()), HasSubstr("step \"zones\" with seed 8: expected the file"));
  ASSERT_TRUE(folder.Put(AskFor("zones"), Answer("of any")).ok());
  EXPECT_EQ(Ask(**replaying, eight, nullptr, "")->text, "of any");
  EXPECT_EQ(Ask(**replaying, seven, nullptr, "")->text, "of seven");
}

TEST_F(AnswerFolderTest, ACacheAsksAgainForAnotherSeed) {
  auto* model = new TestLlmClient();
  const auto cache = MakeCachingClient(std::unique_ptr<LlmClient>(model), path_);
  ChatRequest seven = AskFor("zones");
  seven.seed = 7;
  EXPECT_EQ(Ask(*cache, AskFor("zones"), model, "of none")->text, "of none");
  EXPECT_EQ(Ask(*cache, seven, model, "of seven")->text, "of seven");
  EXPECT_EQ(Ask(*cache, seven, model, "again")->text, "of seven");
  EXPECT_THAT(model->requests, SizeIs(2));
}

TEST_F(AnswerFolderTest, ARecordingIsNotAskedTwiceForTheSame) {
  auto* model = new TestLlmClient();
  auto recording = MakeRecordingClient(std::unique_ptr<LlmClient>(model), path_);
  EXPECT_EQ(Ask(**recording, AskFor("zones"), model, "first")->text, "first");
  EXPECT_EQ(Ask(**recording, AskFor("zones"), model, "second")->text, "first");
  EXPECT_THAT(model->requests, SizeIs(1));
}

TEST_F(AnswerFolderTest, ARecordingOfAnotherModelIsRefused) {
  ASSERT_TRUE(AnswerFolder(path_).ClaimFor("other@there").ok());
  const auto recording = MakeRecordingClient(std::make_unique<TestLlmClient>(), path_);
  EXPECT_TRUE(absl::IsFailedPrecondition(recording.status()));
  EXPECT_THAT(std::string(recording.status().message()), HasSubstr("other@there"));
}

TEST_F(AnswerFolderTest, AFolderWithoutARecordingIsNotReplayed) {
  EXPECT_TRUE(absl::IsNotFound(MakeReplayingClient(path_).status()));
  EXPECT_TRUE(absl::IsNotFound(MakeReplayingClient(path_ + "/none").status()));
}

TEST_F(AnswerFolderTest, ARecordingThatCannotBeWrittenFailsTheCall) {
  auto* model = new TestLlmClient();
  auto recording = MakeRecordingClient(std::unique_ptr<LlmClient>(model), path_ + "/r");
  ASSERT_TRUE(recording.ok());
  std::filesystem::remove_all(path_ + "/r");
  std::ofstream(path_ + "/r") << "a file where the folder was";
  EXPECT_FALSE(Ask(**recording, AskFor("zones"), model, "lost").ok());
}

TEST_F(AnswerFolderTest, ACacheAsksOnceAndForgetsNothingButErrors) {
  auto* model = new TestLlmClient();
  const auto cache = MakeCachingClient(std::unique_ptr<LlmClient>(model), path_);
  runtime::CallContext call;
  model->answer = [](size_t) { return absl::UnavailableError("down"); };
  EXPECT_TRUE(absl::IsUnavailable(cache->Ask(AskFor("zones"), call).status()));
  EXPECT_EQ(Ask(*cache, AskFor("zones"), model, "up")->text, "up");
  EXPECT_EQ(Ask(*cache, AskFor("zones"), model, "again")->text, "up");
  EXPECT_THAT(model->requests, SizeIs(2));
}

TEST_F(AnswerFolderTest, ACacheThatCannotBeUsedIsAsIfEmpty) {
  std::ofstream(path_ + "/c") << "a file";
  auto* model = new TestLlmClient();
  const auto cache = MakeCachingClient(std::unique_ptr<LlmClient>(model), path_ + "/c");
  EXPECT_EQ(Ask(*cache, AskFor("zones"), model, "a")->text, "a");
  EXPECT_EQ(Ask(*cache, AskFor("zones"), model, "b")->text, "b");
}

}  // namespace
}  // namespace flair::llm
