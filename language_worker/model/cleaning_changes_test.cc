// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "language_worker/model/model_handlers.h"
#include "llm/answers/read_answer.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

v1::ConstraintList List() {
  v1::ConstraintList list;
  for (const char* id : {"s1", "s2", "s3", "s4a"}) {
    v1::Sentence& sentence = *list.add_sentences();
    sentence.set_id(id);
    sentence.set_text("The bed is at a wall.");
    sentence.set_scope(std::string(id) == "s4a" ? v1::SENTENCE_SCOPE_INTER : v1::SENTENCE_SCOPE_INTRA);
  }
  list.add_sentences()->set_id("t1");
  list.mutable_sentences(4)->set_scope(v1::SENTENCE_SCOPE_TERTIARY);
  return list;
}

// "s1,s2>A.|B.(why)" of each change; faults behind them.
std::vector<std::string> Read(const std::string& text) {
  const v1::ConstraintList list = List();
  model::v1::CleaningAnswer answer;
  std::vector<llm::Fault> faults = llm::ReadAnswer(text, {}, answer);
  std::vector<std::string> said;
  for (const Change& change : ReadChanges(answer, IndexOf(list), &faults)) {
    said.push_back(fmt::format("{}>{}", fmt::join(change.from, ","), fmt::join(change.to, "|")));
    if (!change.reason.empty()) said.back() += "(" + change.reason + ")";
  }
  for (const llm::Fault& fault : faults) said.push_back(fault.Sentence());
  return said;
}

TEST(CleaningChanges, AreReadFromLines) {
  EXPECT_THAT(Read(R"x({"changes":["s1: The bed: here.","s2, s3: It is near.","s4a: none(contradicts s1)"]})x"),
              ElementsAre("s1>The bed: here.", "s2,s3>It is near.", "s4a>(contradicts s1)"));
}

TEST(CleaningChanges, LinesAboutTheSameSentenceAreItsParts) {
  EXPECT_THAT(Read(R"({"changes":["s1: One.","s2: Other.","s1: Two."]})"), ElementsAre("s1>One.|Two.", "s2>Other."));
}

TEST(CleaningChanges, AreReadFromObjectsAndOtherLinesToo) {
  EXPECT_THAT(Read(R"({"changes":[{"from":["s1","s2"],"to":["One."]},{"from":"S3","to":["A.","B."]}]})"),
              ElementsAre("s1,s2>One.", "s3>A.|B."));
  EXPECT_THAT(Read(R"({"changes":["- [s1] One.","s2 + s3: \"Two.\"","s4a - none: vague"]})"),
              ElementsAre("s1>One.", "s2,s3>Two.\"", "s4a>(vague)"));
}

TEST(CleaningChanges, EveryWordForNoneRemovesAndSentencesThatBeginSoStay) {
  for (const char* none : {"none", "None.", "none()", "", "-", "(none)", "removed", "null"}) {
    EXPECT_THAT(Read(fmt::format(R"({{"changes":["s1: {}"]}})", none)), ElementsAre("s1>")) << none;
  }
  EXPECT_THAT(Read(R"({"changes":["s1: Nothing stands before the door."]})"),
              ElementsAre("s1>Nothing stands before the door."));
}

TEST(CleaningChanges, OneThatLeavesItsSentenceAsItIsIsNone) {
  EXPECT_THAT(Read(R"({"changes":["s1: The bed is at a wall."]})"), IsEmpty());
}

TEST(CleaningChanges, WhatMakesNoSenseIsLeftOutWithItsReason) {
  EXPECT_THAT(Read(R"({"changes":["s99: One.","s1: One."]})"),
              ElementsAre("s1>One.", "changes[0]: names \"s99\", which is no sentence of the list"));
  EXPECT_THAT(Read(R"({"changes":["t1: One."]})"), ElementsAre(HasSubstr("changes[0]: names \"t1\"")));
  EXPECT_THAT(Read(R"({"changes":["The bed is here."]})"), ElementsAre(HasSubstr("changes[0]: names \"The\"")));
  EXPECT_THAT(Read(R"({"changes":["s1, s2: One.","s2: Two."]})"),
              ElementsAre("s1,s2>One.", "changes[1]: changes s2, which another one changes"));
  EXPECT_THAT(Read(R"({"changes":["s1: none","s1: Two."]})"), ElementsAre("s1>", HasSubstr("changes[1]: changes s1")));
  EXPECT_THAT(Read(R"({"changes":["s1, s4a: One."]})"), ElementsAre(HasSubstr("changes[0]: joins sentences")));
  EXPECT_THAT(Read(R"({"changes":[{"from":"s1, s2","to":["One.","Two."]}]})"),
              ElementsAre(HasSubstr("changes[0]: makes several sentences of several")));
  EXPECT_THAT(Read(R"({"changes":[": One."]})"), ElementsAre(HasSubstr("changes[0]: names")));
}

}  // namespace
}  // namespace flair::language
