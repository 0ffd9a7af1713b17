// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/prompt_texts.h"

#include <string>
#include <vector>

#include "gtest/gtest.h"

namespace flair::translator {
namespace {

v1::Object Make(const std::string& id, const std::string& name, v1::ObjectKind kind) {
  v1::Object object;
  object.set_id(id);
  object.set_name(name);
  object.set_kind(kind);
  object.set_role(kind == v1::OBJECT_KIND_FLOOR ? v1::OBJECT_ROLE_SECONDARY : v1::OBJECT_ROLE_TERTIARY);
  object.set_zone_id("dining");
  object.set_width_m(0.45);
  object.set_depth_m(0.5);
  return object;
}

TEST(PromptTexts, EqualObjectsAreOneLineAndANameIsSaidWhereTheIdDoesNotTellIt) {
  v1::ObjectList list;
  *list.add_objects() = Make("dining_chair_1", "dining chair", v1::OBJECT_KIND_FLOOR);
  *list.add_objects() = Make("dining_chair_2", "dining chair", v1::OBJECT_KIND_FLOOR);
  *list.add_objects() = Make("table", "grandmother's \"table\"", v1::OBJECT_KIND_FLOOR);
  *list.add_objects() = Make("vase", "vase", v1::OBJECT_KIND_SURFACE);
  const v1::Sentence about_all;
  const std::vector<const v1::Sentence*> sentences = {&about_all};
  EXPECT_EQ(ObjectsText(list, sentences),
            "- dining_chair_1, dining_chair_2: 0.45 x 0.5, dining\n"
            "- table: \"grandmother's \\\"table\\\"\", 0.45 x 0.5, dining\n");
  v1::Sentence about_vase;
  about_vase.add_subject_ids("vase");
  EXPECT_TRUE(ObjectsText(list, std::vector<const v1::Sentence*>{&about_vase})
                  .ends_with("- vase: 0.45 x 0.5, dining, on another object\n"));
}

TEST(PromptTexts, SentencesStandUnderTheirObjects) {
  std::vector<v1::Sentence> sentences(3);
  for (size_t i = 0; i < sentences.size(); ++i) {
    sentences[i].set_id("s" + std::to_string(i + 1));
    sentences[i].set_text("It \"is\".");
    if (i < 2) sentences[i].add_subject_ids("bed");
  }
  EXPECT_EQ(SentencesText(std::vector<const v1::Sentence*>{&sentences[0], &sentences[1], &sentences[2]}),
            "[bed]\n- s1 \"It \\\"is\\\".\"\n- s2 \"It \\\"is\\\".\"\n[]\n- s3 \"It \\\"is\\\".\"\n");
}

TEST(PromptTexts, AnExampleInTheNamesOwnWordsIsLeftOut) {
  v1::ConstraintType near, facing;
  near.set_name("near");
  near.set_summary("`object` is near `target`.");
  near.add_examples()->set_sentence("The bed is near the door.");
  facing.set_name("facing");
  facing.set_summary("It looks there.");
  facing.add_examples()->set_sentence("The sofa faces the television.");
  EXPECT_EQ(FunctionsText(std::vector<const v1::ConstraintType*>{&near, &facing}),
            "- near(): object is near target.\n- facing(): It looks there. \"The sofa faces the television.\"\n");
}

}  // namespace
}  // namespace flair::translator
