// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that no model should write: whatever stands in a recording, its conversion ends and its answers are read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "language_worker/model/model_tools.h"
#include "language_worker/recorded/import_answers.h"
#include "language_worker/recorded/recorded_text.h"
#include "language_worker/recorded/testing/test_room.h"

namespace flair::language {
namespace {

// Pieces from which texts are made: marks, names, numbers, halves of characters.
const std::vector<std::string> kPieces = {"#",
                                          "### ",
                                          "- ",
                                          "* ",
                                          "**",
                                          "`",
                                          "1. ",
                                          "99) ",
                                          "\n",
                                          "\n\n",
                                          "\n   ",
                                          "\t",
                                          ":",
                                          ": ",
                                          "(",
                                          ")",
                                          "desk",
                                          "bookshelves",
                                          "armchair 2",
                                          "Bookshelf (1.0m x 0.3m)",
                                          "should",
                                          "Placement:",
                                          "Colour:",
                                          "walnut",
                                          "0.5m",
                                          "1e999m",
                                          "x",
                                          ".",
                                          ". A",
                                          "e.g. ",
                                          "\xc3",
                                          "\xe2\x80\x99",
                                          "\xff",
                                          "\r",
                                          "Reading:",
                                          "window",
                                          "wall",
                                          "Summary",
                                          "- Object: desk_lamp",
                                          "<brief>",
                                          "\"",
                                          "\\",
                                          "s1 [desk] \"x\"",
                                          "2x",
                                          "working",
                                          "Avoid placement near:"};

std::string RandomText(std::mt19937_64& random) {
  std::string text;
  const size_t count = random() % 120;
  for (size_t i = 0; i < count; ++i) text += kPieces[random() % kPieces.size()] + (random() % 3 == 0 ? " " : "");
  return text;
}

// The text with a few pieces put in, taken out or repeated.
std::string Changed(std::string text, std::mt19937_64& random) {
  for (size_t i = 0, count = 1 + random() % 12; i < count && !text.empty(); ++i) {
    const size_t at = random() % text.size();
    if (random() % 2 == 0) {
      text.insert(at, kPieces[random() % kPieces.size()]);
    } else {
      text.erase(at, random() % 20);
    }
  }
  return text;
}

// Reads one text in every way; says what would break an answer.
void ReadAll(const RecordedRoom& room, const std::string& text) {
  const std::vector<const v1::Object*> objects = room.FloorObjects();
  const ObjectNames names(objects);
  const std::vector<std::string> zones = {"working", "reading"};
  Conversion conversion;
  for (const auto kind : {ConstraintTextKind::kIntra, ConstraintTextKind::kInter}) {
    for (const RecordedSentence& sentence : ReadConstraintText({"t", text, kind, names, zones}, conversion)) {
      ASSERT_FALSE(sentence.text.empty());
      ASSERT_LE(sentence.text.size(), 400u);
      ASSERT_FALSE(sentence.objects.empty());
      for (const int object : sentence.objects) ASSERT_LT(static_cast<size_t>(object), objects.size());
    }
  }
  const std::vector<const v1::Object*> tertiaries = room.Tertiaries();
  const auto placements = ReadTertiaryText(text, tertiaries, names, conversion);
  ASSERT_EQ(placements.size(), tertiaries.size());
  for (const RecordedPlacement& placement : placements) ASSERT_LE(placement.text.size(), 400u);
  ASSERT_LE(conversion.converted, conversion.lines);
}

TEST(HostileText, AnyBytesAreRead) {
  const RecordedRoom room = TestRoom("study");
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = RandomText(random);
    ReadAll(room, text);
    if (HasFatalFailure()) FAIL() << "run " << i << ": " << ::testing::PrintToString(text);
  }
}

TEST(HostileText, ChangedTextsOfARoomAreRead) {
  const RecordedRoom room = TestRoom("study");
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    for (const auto& [name, text] : room.texts) {
      const std::string changed = Changed(text, random);
      ReadAll(room, changed);
      if (HasFatalFailure()) FAIL() << "run " << i << ": " << ::testing::PrintToString(changed);
    }
  }
}

TEST(HostileText, DeepListsAndLongLinesTakeNoLongTime) {
  const RecordedRoom room = TestRoom("study");
  std::string deep, wide = "- ";
  for (int i = 0; i < 3000; ++i) deep += std::string(static_cast<size_t>(i), ' ') + "- desk:\n";
  for (int i = 0; i < 200000; ++i) wide += "desk ";
  ReadAll(room, deep);
  ReadAll(room, wide);
}

TEST(HostileText, ThePhaseEndsInObjectsAndSentencesOrSaysWhichStepHadNone) {
  const auto prompts = llm::PromptLibrary::Load(DefaultPromptsFolder(), {}, LanguagePrompts());
  ASSERT_TRUE(prompts.ok());
  std::mt19937_64 random(6);
  for (int i = 0; i < 20; ++i) {
    RecordedRoom room = TestRoom(i % 2 == 0 ? "study" : "washroom");
    for (auto& [name, text] : room.texts) text = i < 4 ? RandomText(random) : Changed(text, random);
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / ("hostile_" + std::to_string(i));
    std::filesystem::remove_all(folder);
    const auto imported = ImportAnswers(room, TestHandbook(), *prompts, folder);
    std::filesystem::remove_all(folder);
    if (imported.ok()) {
      EXPECT_GE(imported->objects.objects_size(), 5);
    } else {
      EXPECT_EQ(imported.status().code(), absl::StatusCode::kDataLoss) << imported.status();
      EXPECT_THAT(std::string(imported.status().message()), ::testing::HasSubstr("step \""));
    }
  }
}

}  // namespace
}  // namespace flair::language
