// SPDX-License-Identifier: GPL-3.0-or-later
// The whole language phase over rooms in the recorded format.
#include "language_worker/recorded/import_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "language_worker/model/model_tools.h"
#include "language_worker/recorded/testing/test_room.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ImportAnswersTest : public ::testing::Test {
 protected:
  ImportAnswersTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
  }
  ~ImportAnswersTest() override { std::filesystem::remove_all(folder_); }

  ImportedAnswers Import(const std::string& name) {
    const RecordedRoom room = TestRoom(name);
    const auto prompts = llm::PromptLibrary::Load(DefaultPromptsFolder(), {}, LanguagePrompts());
    EXPECT_TRUE(prompts.ok()) << prompts.status();
    auto imported = ImportAnswers(room, TestHandbook(), *prompts, folder_);
    EXPECT_TRUE(imported.ok()) << imported.status();
    return imported.ok() ? *std::move(imported) : ImportedAnswers();
  }

  const std::filesystem::path folder_;
};

std::vector<std::string> Ids(const v1::ObjectList& list) {
  std::vector<std::string> ids;
  for (const v1::Object& object : list.objects()) ids.push_back(object.id());
  return ids;
}

// "subjects: text"
std::vector<std::string> Sentences(const v1::ConstraintList& list, v1::SentenceScope scope) {
  std::vector<std::string> lines;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.scope() != scope) continue;
    std::string line;
    for (const std::string& id : sentence.subject_ids()) line += (line.empty() ? "" : " ") + id;
    lines.push_back(line + ": " + sentence.text());
  }
  return lines;
}

const v1::Object& Find(const ImportedAnswers& imported, const std::string& id) {
  for (const v1::Object& object : imported.objects.objects()) {
    if (object.id() == id) return object;
  }
  ADD_FAILURE() << "no " << id;
  return v1::Object::default_instance();
}

TEST_F(ImportAnswersTest, AllObjectsComeThroughWithIdsSizesAndHosts) {
  const ImportedAnswers imported = Import("study");
  EXPECT_THAT(Ids(imported.objects), ElementsAre("desk", "armchair", "desk_chair", "bookshelf", "bookshelf_2",
                                                 "desk_lamp", "painting", "rug", "books_1", "books_2"));
  EXPECT_EQ(Find(imported, "bookshelf").width_m(), 1.0);
  EXPECT_GT(Find(imported, "bookshelf").height_m(), 1.0) << "the handbook knows how high";
  EXPECT_EQ(Find(imported, "desk_lamp").host_id(), "desk");
  EXPECT_EQ(Find(imported, "painting").placement(), "On the wall above the desk.");
  EXPECT_EQ(Find(imported, "rug").host_id(), "armchair");
  EXPECT_TRUE(Find(imported, "rug").walk_over());
  EXPECT_EQ(imported.room.openings_size(), 2);
  EXPECT_EQ(imported.room.sockets_size(), 1);
}

TEST_F(ImportAnswersTest, SentencesBelongToTheirObjectsAndAreCleanedAsRecorded) {
  const ImportedAnswers imported = Import("study");
  EXPECT_THAT(Sentences(imported.constraints, v1::SENTENCE_SCOPE_INTRA),
              ElementsAre("desk: Must not block the window.", "desk: Must not block the door.",
                          "desk: Should be against a wall.", "desk: Near a power socket.",
                          "armchair: The front should be accessible.", "armchair: Avoid placement near doors.",
                          "desk_chair: Should be accessible from the back.", "bookshelf: Should be against a wall.",
                          "bookshelf_2: Should be in a corner."));
  EXPECT_THAT(Sentences(imported.constraints, v1::SENTENCE_SCOPE_INTER),
              ElementsAre("desk armchair: The desk should be at least 0.6m away from the armchair.",
                          "desk desk_chair: The desk chair should be in front of the desk.",
                          "desk desk_chair: The desk chair should face the desk.",
                          "armchair: Should be placed beside the bookshelf."));
}

TEST_F(ImportAnswersTest, WhatHasNoPlaceIsToldWithItsLine) {
  const ImportedAnswers imported = Import("study");
  std::vector<std::string> remarks;
  for (const auto& [step, conversion] : imported.conversions) {
    EXPECT_LE(conversion.converted, conversion.lines) << step;
    for (const ConversionRemark& remark : conversion.remarks) remarks.push_back(remark.source + ": " + remark.text);
  }
  EXPECT_THAT(remarks, ElementsAre("primary_inter_clean: There should be room to walk everywhere.",
                                   "tertiary: Wind Chime: By the window."));
}

TEST_F(ImportAnswersTest, ARoomRecordedTheOtherWayRoundIsTurnedAsItsBriefSays) {
  const ImportedAnswers imported = Import("washroom");
  EXPECT_EQ(imported.room.floor().vertices(2).x_m(), 3);
  EXPECT_EQ(imported.room.floor().vertices(2).y_m(), 2);
  ASSERT_EQ(imported.room.openings_size(), 2);
  EXPECT_EQ(imported.room.openings(0).wall(), "south");
  EXPECT_EQ(imported.room.openings(1).wall(), "north");
}

TEST_F(ImportAnswersTest, MatsLieOnTheFloorAndTheirSentencesAreNotLostWithoutAWord) {
  const ImportedAnswers imported = Import("washroom");
  EXPECT_EQ(Find(imported, "bath_mat").role(), v1::OBJECT_ROLE_TERTIARY);
  std::vector<std::string> remarks;
  for (const auto& [step, conversion] : imported.conversions) {
    for (const ConversionRemark& remark : conversion.remarks) remarks.push_back(remark.text);
  }
  EXPECT_THAT(remarks, Contains("Placed on the floor."));
  EXPECT_EQ(Find(imported, "soap_dish").host_id(), "washbasin") << "as its call says: the text has no item of it";
  EXPECT_EQ(Find(imported, "mirror").host_id(), "washbasin");
  EXPECT_EQ(Find(imported, "ceilinglight").kind(), v1::OBJECT_KIND_CEILING);
}

TEST_F(ImportAnswersTest, EachStepIsAskedOnceAndWrittenDown) {
  const ImportedAnswers imported = Import("study");
  EXPECT_EQ(imported.calls.size(), 8u);
  for (const v1::ModelCall& call : imported.calls) {
    EXPECT_THAT(call.step(), Not(HasSubstr("repair")));
    EXPECT_THAT(call.faults(), IsEmpty()) << call.step();
    EXPECT_GT(call.usage().output_token_count(), 0);
  }
  const auto count = std::distance(std::filesystem::directory_iterator(folder_), {});
  EXPECT_EQ(count, 9) << "eight answers and the identity";
}

TEST_F(ImportAnswersTest, ImportingAgainGivesTheSame) {
  const ImportedAnswers first = Import("washroom");
  const ImportedAnswers again = Import("washroom");
  EXPECT_EQ(first.constraints.SerializeAsString(), again.constraints.SerializeAsString());
  EXPECT_EQ(first.objects.SerializeAsString(), again.objects.SerializeAsString());
}

}  // namespace
}  // namespace flair::language
