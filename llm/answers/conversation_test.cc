// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/conversation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "flair/model/v1/room_answers.pb.h"
#include "llm/answers/read_answer.h"
#include "llm/testing/fake_llm_client.h"

namespace flair::llm {
namespace {

namespace fs = std::filesystem;
using model::v1::ZonesAnswer;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

const char* const kGood = R"({"zones":[{"name":"sleeping","purpose":"Sleep."}]})";
const char* const kOneBad = R"({"zones":[{"name":"sleeping","purpose":"Sleep."},{"name":"dressing"}]})";

class ConversationTest : public ::testing::Test {
 protected:
  ConversationTest() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const fs::path folder = fs::path(::testing::TempDir()) / ("conversation_" + name);
    fs::create_directories(folder);
    std::ofstream(folder / "repair.txt") << "Wrong:\n{{faults}}\nAnswer again.";
    prompts_ = *PromptLibrary::Load(folder, {}, {RepairPrompt()});
    fs::remove_all(folder);
  }

  static Question Ask(const std::string& step = "zones") {
    return {
        .step = step, .system = "You design rooms.", .text = "Plan zones.", .answer = &ZonesAnswer::default_instance()};
  }
  Conversation Talk() { return Conversation(client_, prompts_, options_, call_); }
  static std::vector<std::string> Names(const Reply& reply) {
    std::vector<std::string> names;
    for (const auto& zone : reply.As<ZonesAnswer>().zones()) names.push_back(zone.name());
    return names;
  }

  FakeLlmClient client_;
  PromptLibrary prompts_;
  v1::ModelOptions options_;
  runtime::CallContext call_;
};

TEST_F(ConversationTest, AGoodAnswerTakesOneCall) {
  client_.Answer("zones", kGood);
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
  ASSERT_EQ(client_.requests().size(), 1U);
  const ChatRequest request = client_.requests()[0];
  EXPECT_EQ(request.schema_name, "zones_answer");
  EXPECT_THAT(request.schema, HasSubstr("\"purpose\""));
  ASSERT_EQ(request.messages.size(), 2U);
  EXPECT_EQ(request.messages[0].role, Role::kSystem);
  ASSERT_EQ(talk.calls().size(), 1U);
  const v1::ModelCall& call = talk.calls()[0];
  EXPECT_EQ(call.step(), "zones");
  EXPECT_EQ(call.model(), "fake-1");
  EXPECT_EQ(call.prompt_version(), prompts_.version());
  EXPECT_EQ(call.answer(), kGood);
  EXPECT_EQ(call.messages(1).text(), "Plan zones.");
  EXPECT_EQ(call.usage().call_count(), 1);
  EXPECT_THAT(call.faults(), IsEmpty());
}

TEST_F(ConversationTest, ARepairQuotesTheFaultsOfElements) {
  client_.Answer("zones", kOneBad);
  client_.Answer("zones/repair",
                 R"({"zones":[{"name":"sleeping","purpose":"Sleep."},{"name":"dressing","purpose":"Dress."}]})");
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping", "dressing"));
  EXPECT_EQ(reply->As<ZonesAnswer>().zones(1).purpose(), "Dress.");
  EXPECT_THAT(reply->faults, IsEmpty());
  const auto messages = client_.requests().at(1).messages;
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages[1].text, "Plan zones.");
  EXPECT_EQ(messages[2].role, Role::kAssistant);
  EXPECT_EQ(messages[2].text, kOneBad);
  EXPECT_EQ(messages[3].text, "Wrong:\n- zones[1].purpose: is missing; a text would be right\n\nAnswer again.");
  ASSERT_EQ(talk.calls().size(), 2U);
  EXPECT_THAT(talk.calls()[0].faults(), ElementsAre("zones[1].purpose: is missing; a text would be right"));
  EXPECT_THAT(talk.calls()[1].faults(), IsEmpty());
}

TEST_F(ConversationTest, ARepairHasNoControlCharacters) {
  for (const std::string first : {std::string("{\"zones\":[\x1b[31m\0\r\n\t\"a\x7f", 22),
                                  std::string("{\"zones\":[{\"name\x07\":\"a\x01\\u0000\"},{\"purpose\":5}]}")}) {
    FakeLlmClient client;
    client.Answer("zones", first);
    client.Answer("zones/repair", kGood);
    ASSERT_TRUE(Conversation(client, prompts_, options_, call_).Ask(Ask()).ok());
    const std::vector<Message> messages = client.requests().at(1).messages;
    for (const Message& message : messages) {
      EXPECT_EQ(WithoutControls(message.text, "\n\t"), message.text);
    }
  }
}

TEST_F(ConversationTest, ARepairOfTheWholeQuotesTheFaultsAndTheFirstAnswer) {
  const std::string none = R"({"zones":[]})";
  client_.Answer("zones", none);
  client_.Answer("zones/repair", kGood);
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
  const auto messages = client_.requests().at(1).messages;
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages[2].text, none);
  EXPECT_EQ(messages[3].text, "Wrong:\n- zones: has 0 elements; at least 1\n\nAnswer again.");
}

TEST_F(ConversationTest, WhatStaysWrongIsLeftOut) {
  client_.Answer("zones", kOneBad);
  client_.Answer("zones/repair", kOneBad);
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
  ASSERT_EQ(reply->faults.size(), 1U);
  EXPECT_EQ(client_.requests().size(), 2U);
}

TEST_F(ConversationTest, ARepairThatMadeItWorseIsNotTaken) {
  client_.Answer("zones", kOneBad);
  client_.Answer("zones/repair", "I'm sorry, I cannot do that.");
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
}

TEST_F(ConversationTest, ARepairThatWasAskedToBeShorterIsTaken) {
  std::string many = "{\"zones\":[";
  for (int i = 0; i < 30; ++i) many += R"({"name":"sleeping","purpose":"Sleep."},)";
  client_.Answer("zones", many + "]}");
  client_.Answer("zones/repair", kGood);
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
}

TEST_F(ConversationTest, UselessAnswersEndWithTheStepAndTheFaults) {
  client_.Answer("zones", "I'm sorry.", FinishReason::kRefused);
  client_.Answer("zones/repair", "");
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  EXPECT_EQ(reply.status().code(), absl::StatusCode::kDataLoss);
  EXPECT_EQ(
      reply.status().message(),
      "step \"zones\": the model's answer is of no use, also after a repair: is empty; one JSON object would be right");
  EXPECT_FALSE(talk.MayStandIn(reply.status())) << "nobody allowed it";
  EXPECT_THAT(talk.calls()[0].faults(), ElementsAre("is a refusal: \"I'm sorry.\""));
}

TEST_F(ConversationTest, AnAnswerCutOffAtItsLimitIsRepairedElseItsWholeElementsAreTaken) {
  const std::string cut = std::string(kOneBad).substr(0, 60);
  client_.Answer("zones", cut, FinishReason::kLength);
  client_.Answer("zones/repair", cut, FinishReason::kLength);
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("sleeping"));
  EXPECT_THAT(talk.calls()[0].faults(), ElementsAre(HasSubstr("ended after"), HasSubstr("was cut off")));
}

TEST_F(ConversationTest, TheCallersCheckIsAskedForBothAnswers) {
  client_.Answer("zones", kGood);
  client_.Answer("zones/repair", R"({"zones":[{"name":"working","purpose":"Work."}]})");
  Question question = Ask();
  question.check = CheckOf<ZonesAnswer>([](ZonesAnswer& answer) {
    std::vector<Fault> faults;
    if (answer.zones(0).name() == "sleeping") faults.push_back({"zones[0].name", "is for bedrooms"});
    return faults;
  });
  Conversation talk = Talk();
  const auto reply = talk.Ask(question);
  ASSERT_TRUE(reply.ok()) << reply.status();
  EXPECT_THAT(Names(*reply), ElementsAre("working"));
  EXPECT_THAT(client_.requests()[1].messages[3].text, HasSubstr("- zones[0].name: is for bedrooms"));
}

TEST_F(ConversationTest, MendedFaultsAreToldButNotAskedAbout) {
  client_.Answer("zones", kGood);
  Question question = Ask();
  question.check = CheckOf<ZonesAnswer>([](ZonesAnswer& answer) {
    answer.mutable_zones(0)->set_name("sleep");
    return std::vector<Fault>{{"zones[0].name", "shortened", FaultKind::kMended}};
  });
  Conversation talk = Talk();
  const auto reply = talk.Ask(question);
  EXPECT_THAT(Names(*reply), ElementsAre("sleep"));
  EXPECT_THAT(talk.calls()[0].faults(), ElementsAre("zones[0].name: shortened"));
  EXPECT_EQ(client_.requests().size(), 1U);
}

TEST_F(ConversationTest, QuestionsAreAskedTogetherAndRepairedEachOnItsOwn) {
  client_.Answer("a", kGood);
  client_.Answer("b", "nothing");
  client_.Answer("b/repair", kGood);
  client_.Answer("c", absl::UnavailableError("no route"));
  Conversation talk = Talk();
  const std::vector<Question> questions = {Ask("a"), Ask("b"), Ask("c")};
  const auto replies = talk.AskAll(questions);
  EXPECT_TRUE(replies[0].ok());
  EXPECT_TRUE(replies[1].ok());
  EXPECT_EQ(replies[2].status(), absl::AbortedError("step \"c\": no route"));
  std::vector<std::string> steps;
  for (const v1::ModelCall& call : talk.calls()) steps.push_back(call.step());
  EXPECT_THAT(steps, ElementsAre("a", "b", "b/repair"));
}

TEST_F(ConversationTest, BudgetsEndItBeforeTheCallThatExceedsThem) {
  options_.set_stand_in_allowed(true);
  const auto ask = [&](const char* what) {
    client_.Answer("zones", kOneBad);
    Conversation talk = Talk();
    const auto reply = talk.Ask(Ask());
    EXPECT_EQ(reply.status().code(), absl::StatusCode::kFailedPrecondition) << what;
    EXPECT_FALSE(talk.MayStandIn(reply.status()));
    return std::string(reply.status().message());
  };
  options_.mutable_budget()->set_call_count(1);
  EXPECT_EQ(ask("calls"), "step \"zones\": the budget of calls is spent: 1 more is needed, 0 are left");
  options_.mutable_budget()->clear_call_count();
  options_.mutable_budget()->set_token_count(20);
  EXPECT_THAT(ask("tokens"),
              MatchesRegex(".*the budget of tokens is spent: about [0-9]+ more are needed, 20 are left"));
  options_.mutable_budget()->clear_token_count();
  options_.mutable_budget()->set_cost_usd(0);
  EXPECT_THAT(ask("money"), HasSubstr("the budget of US dollars is spent: nothing is left"));
  EXPECT_EQ(client_.requests().size(), 1U) << "only the first had a call left";
}

TEST_F(ConversationTest, TextsCanBeLeftOut) {
  options_.set_texts_omitted(true);
  client_.Answer("zones", "I'd rather not.");
  client_.Answer("zones/repair", "Still not.");
  Conversation talk = Talk();
  const auto reply = talk.Ask(Ask());
  EXPECT_THAT(reply.status().message(), HasSubstr("has no JSON; it says \"…\"; one JSON object"));
  for (const v1::ModelCall& call : talk.calls()) {
    EXPECT_EQ(call.answer(), "");
    EXPECT_EQ(call.messages_size(), 0);
    EXPECT_GT(call.usage().input_token_count(), 0);
    EXPECT_THAT(call.faults(), ElementsAre(HasSubstr("it says \"…\"; one JSON")));
  }
  EXPECT_THAT(client_.requests()[1].messages[3].text, HasSubstr("rather not")) << "the model itself is told";
}

TEST_F(ConversationTest, ItsSeedGoesWithQuestionAndRepair) {
  client_.Answer("zones", "Let me think.");
  client_.Answer("zones/repair", kGood);
  Conversation talk(client_, prompts_, options_, call_, 42);
  ASSERT_TRUE(talk.Ask(Ask()).ok());
  for (const ChatRequest& request : client_.requests()) EXPECT_EQ(request.seed, 42) << request.step;
}

TEST_F(ConversationTest, AQuestionThatTheServerDoesNotTakeIsTheModelsFailure) {
  options_.set_stand_in_allowed(true);
  client_.Answer("zones", absl::InvalidArgumentError("HTTP 400, context too long"));
  Conversation talk = Talk();
  const absl::Status status = talk.Ask(Ask()).status();
  EXPECT_EQ(status, absl::AbortedError("step \"zones\": HTTP 400, context too long"));
  EXPECT_TRUE(talk.MayStandIn(status));
}

TEST_F(ConversationTest, AnAnswerWithoutTextBecauseOfItsLimitSaysSo) {
  for (const char* step : {"zones", "zones/repair"}) client_.Answer(step, "", FinishReason::kLength);
  Conversation talk = Talk();
  EXPECT_THAT(talk.Ask(Ask()).status().message(), HasSubstr("thoughts included (max_output_token_count)"));
}

TEST_F(ConversationTest, ACancelledCallAsksNothing) {
  call_.cancellation().Cancel();
  Conversation talk = Talk();
  EXPECT_EQ(talk.Ask(Ask()).status().code(), absl::StatusCode::kCancelled);
  EXPECT_THAT(client_.requests(), IsEmpty());
}

}  // namespace
}  // namespace flair::llm
