// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "language_worker/model/prompt_text.h"
#include "language_worker/recorded/import_answers.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

void AddObject(const std::string& id, const std::string& name, v1::ObjectRole role, v1::ObjectList& list) {
  v1::Object& object = *list.add_objects();
  object.set_id(id);
  object.set_name(name);
  object.set_role(role);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_zone_id("dining");
  object.set_width_m(0.5);
  object.set_depth_m(0.45);
  object.set_height_m(0.9);
}

TEST(PromptLines, ReadWhatThePromptsOfTheStepsList) {
  v1::ObjectList list;
  AddObject("dining_table", "dining table", v1::OBJECT_ROLE_PRIMARY, list);
  for (int i = 1; i <= 12; ++i) {
    AddObject("dining_chair_" + std::to_string(i), "dining chair", v1::OBJECT_ROLE_SECONDARY, list);
  }
  const std::string text = "Furniture:\n" + GroupsText(GroupObjects(list, true)) + "\nSay where it goes - now.";
  const auto objects = ReadPromptObjects(text);
  ASSERT_THAT(objects, SizeIs(2));
  EXPECT_THAT(objects[0].ids, ElementsAre("dining_table"));
  EXPECT_EQ(objects[0].group, "dining_table");
  EXPECT_EQ(objects[1].group, "dining_chair");
  ASSERT_THAT(objects[1].ids, SizeIs(12));
  EXPECT_EQ(objects[1].ids[11], "dining_chair_12");
  EXPECT_EQ(objects[1].zone_id, "dining");
  EXPECT_EQ(objects[1].width_m, 0.5);
  EXPECT_EQ(objects[1].depth_m, 0.45);
}

TEST(PromptLines, ReadSentencesUnderTheirHeadings) {
  const auto sentences = ReadPromptSentences(
      "Sentences:\n[bed, desk_2]\n- s1 \"The \\\"bed\\\" is near.\"\n- s2a \"Alone.\"\nnot [a] sentence\n[]\n- s3 "
      "bare\n- "
      "s4 \"Of none.\"\n");
  ASSERT_THAT(sentences, SizeIs(3));
  EXPECT_THAT(sentences[0].subject_ids, ElementsAre("bed", "desk_2"));
  EXPECT_EQ(sentences[0].text, "The \"bed\" is near.");
  EXPECT_EQ(sentences[1].id, "s2a");
  EXPECT_THAT(sentences[1].subject_ids, ElementsAre("bed", "desk_2"));
  EXPECT_EQ(sentences[2].id, "s4");
  EXPECT_THAT(sentences[2].subject_ids, IsEmpty());
}

TEST(PromptLines, ReadObjectsOfTheTranslation) {
  const auto objects = ReadPromptObjects(
      "- bed_1: \"double bed\", 1.6 x 2, sleeping\n- stool_1, stool_2: 0.2 x 0.2, no zone, on another object\n"
      "- near(object, target): a function, 2 x 3, that\n");
  ASSERT_THAT(objects, SizeIs(2));
  EXPECT_THAT(objects[0].ids, ElementsAre("bed_1"));
  EXPECT_EQ(objects[0].name, "double bed");
  EXPECT_EQ(objects[0].depth_m, 2);
  EXPECT_EQ(objects[0].zone_id, "sleeping");
  EXPECT_EQ(objects[1].zone_id, "");
  EXPECT_THAT(objects[1].ids, ElementsAre("stool_1", "stool_2"));
  EXPECT_EQ(objects[1].name, "stool");
}

TEST(PromptLines, GroupsThatCannotBeAreNotReadFor) {
  EXPECT_THAT(ReadPromptObjects("- a_1 to a_999999999, together a (z): 1 x 1 x 1 m"), IsEmpty());
  EXPECT_THAT(ReadPromptObjects("- a_9 to a_2, together a (z): 1 x 1 x 1 m")[0].ids, ElementsAre("a_9"));
}

}  // namespace
}  // namespace flair::language
