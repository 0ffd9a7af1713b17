// SPDX-License-Identifier: GPL-3.0-or-later
// Families of wordings: what means one thing gives one call, and what only explains changes nothing.
#include <set>
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/meanings.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// A flat: id, name, zone, width, depth; everything stands on the floor.
v1::TranslateRequest Flat() {
  v1::TranslateRequest request;
  *request.mutable_catalog() =
      ReadCatalog(std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/catalog.textproto");
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_DOOR);
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_WINDOW);
  request.mutable_room()->add_sockets();
  for (const char* zone : {"sleeping", "dining", "bathing"}) {
    v1::Zone& added = *request.mutable_zone_plan()->add_zones();
    added.set_id(zone);
    added.set_name(zone);
  }
  const auto add = [&](const char* id, const char* name, v1::ObjectRole role, const char* zone, double width,
                       double depth) {
    v1::Object& object = *request.mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name(name);
    object.set_role(role);
    object.set_kind(v1::OBJECT_KIND_FLOOR);
    object.set_zone_id(zone);
    object.set_width_m(width);
    object.set_depth_m(depth);
  };
  add("bed", "bed", v1::OBJECT_ROLE_PRIMARY, "sleeping", 1.5, 2.0);
  add("wardrobe", "wardrobe", v1::OBJECT_ROLE_PRIMARY, "sleeping", 1.5, 0.6);
  add("table", "dining table", v1::OBJECT_ROLE_PRIMARY, "dining", 1.6, 0.9);
  add("shower", "shower", v1::OBJECT_ROLE_PRIMARY, "bathing", 0.9, 0.9);
  add("sideboard", "sideboard", v1::OBJECT_ROLE_SECONDARY, "dining", 1.2, 0.4);
  add("chair_1", "dining chairs", v1::OBJECT_ROLE_SECONDARY, "dining", 0.5, 0.5);
  add("chair_2", "dining chairs", v1::OBJECT_ROLE_SECONDARY, "dining", 0.5, 0.5);
  return request;
}

std::string Read(const std::string& text, const std::vector<std::string>& subjects = {}) {
  v1::TranslateRequest request = Flat();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(text);
  sentence.set_scope(subjects.empty() ? v1::SENTENCE_SCOPE_INTER : v1::SENTENCE_SCOPE_INTRA);
  for (const std::string& subject : subjects) sentence.add_subject_ids(subject);
  std::vector<std::string> calls;
  const v1::LayoutGraph graph = Translate(request);
  for (const v1::ConstraintEdge& edge : graph.edges()) calls.push_back(ToText(edge));
  return absl::StrReplaceAll(absl::StrJoin(calls, "; "), {{"\"", ""}});
}

// All wordings, in a sentence about `subject` (none: about several pieces), mean `calls`.
void ExpectAll(const std::string& subject, const std::string& calls, const std::vector<std::string>& wordings) {
  for (const std::string& wording : wordings) {
    EXPECT_EQ(Read(wording, subject.empty() ? std::vector<std::string>{} : std::vector<std::string>{subject}), calls)
        << wording;
  }
}

TEST(Families, EveryTestAndCallOfTheTablesIsKnown) {
  const std::set<std::string> subjects = {"A",       "B",       "C",       "D",      "mover", "target",
                                          "topic",   "subject", "pair",    "detail", "scope", "said", "calls",
                                          "feature", "laid",    "several", "same",   "own",   "opposed"};
  std::set<std::string> types = {"detail"};
  const v1::TranslateRequest request = Flat();
  for (const v1::ConstraintType& type : request.catalog().types()) types.insert(type.name());
  for (const auto& [name, table] : Tables()) {
    std::vector<Case> cases = table.first;
    cases.insert(cases.end(), table.cases.begin(), table.cases.end());
    for (const Case& one : cases) {
      for (const Condition& test : one.tests)
        EXPECT_TRUE(subjects.contains(test.subject)) << name << ": " << test.subject;
      for (const auto& alternatives : one.calls) {
        for (const Template& call : alternatives) EXPECT_TRUE(types.contains(call.type)) << name << ": " << call.type;
      }
    }
  }
}

TEST(Families, EveryMeaningThatFramesAndTablesNameIsKnown) { EXPECT_EQ(absl::StrJoin(UnknownMeanings(), ", "), ""); }

TEST(Families, SpaceInFrontOfAPieceInManyWords) {
  ExpectAll("wardrobe", "accessible(object=wardrobe, sides=[front])",
            {"The doors should open without obstruction.", "Needs room in front to open the doors.",
             "The doors of the wardrobe must open fully.", "Nothing should block its front.", "Keep the front open.",
             "Ensure enough space for the doors to swing open.", "Do not place anything in front of it.",
             "Should be reachable from the front."});
  ExpectAll("wardrobe", "accessible(object=wardrobe, sides=[front], min_clearance_m=0.8)",
            {"0.8m clear in front.", "Front clearance of 0.8m.", "Space in front (preferably 0.8m minimum clearance).",
             "Allow 0.8m in front for doors to swing open."});
}

TEST(Families, OneSideIsTheOneThatPeopleUse) {
  ExpectAll("bed", "accessible(object=bed, sides=[left])",
            {"At least one side should be accessible.", "Leave one side open for getting in."});
  ExpectAll("sideboard", "accessible(object=sideboard, sides=[front])",
            {"At least one side should be accessible.", "One side is accessible for use (typically the front)."});
}

TEST(Families, ChairsAreGotAtFromBehindAlsoWhenTheirNameIsPlural) {
  const std::string backs = "accessible(object=chair_1, sides=[back]); accessible(object=chair_2, sides=[back])";
  for (const char* text : {"Should have enough space to be pulled out.", "Each chair can be pulled out easily.",
                           "Must be positioned so they can be moved in and out freely."}) {
    EXPECT_EQ(Read(text, {"chair_1", "chair_2"}), backs) << text;
  }
}

TEST(Families, ReasonsAfterToChangeNothing) {
  const std::string facts[] = {"The sideboard should be at least 0.9m away from the dining table",
                               "The bed should be near the wardrobe", "The wardrobe should be placed against a wall"};
  for (const std::string& fact : facts) {
    const std::string plain = Read(fact + ".");
    EXPECT_FALSE(plain.empty()) << fact;
    for (const char* reason : {"to allow the chairs to be used", "to ensure easy movement", "to give it some air",
                               "so that people can walk", "to facilitate cleaning"}) {
      EXPECT_EQ(Read(fact + " " + reason + "."), plain) << reason;
    }
  }
}

TEST(Families, WordsThatAreNotKnownHideNoFact) {
  for (const char* word : {"quirky", "handsomely", "zesty"}) {
    EXPECT_EQ(Read("The bed should stand " + std::string(word) + " near the wardrobe."),
              "near(object=bed, target=wardrobe)");
  }
  EXPECT_EQ(Read("The bed was overshadowed by the wardrobe."), "");
}

TEST(Families, WhatIsBlockedOfAWindowIsTheWindow) {
  ExpectAll("sideboard", "clear_of_feature(object=sideboard, feature=window)",
            {"Should not obstruct the view or access to windows.", "Avoid blocking or obstructing windows.",
             "Avoid positions that block windows.", "Must not block windows, especially if they are low.",
             "Should not block windows unless they are high."});
}

TEST(Families, WaysAreNeverDistances) {
  for (const char* text : {"Ensure clear walkways of at least 0.6m throughout the room.",
                           "A 0.6m wide path through the room should be kept.", "Maintain pathways of 0.8m."}) {
    EXPECT_EQ(Read(text), "") << text;
  }
}

TEST(Families, PlacesByUseAndByPiece) {
  ExpectAll("sideboard", "in_zone(object=sideboard, zone=dining)",
            {"Should be in the dining area.", "Place it in the eating area.", "Part of the dining zone."});
  ExpectAll("sideboard", "in_zone(object=sideboard, zone=bathing)",
            {"Located in the bathing area.", "Located in the shower area."});
}

TEST(Families, OneIsNotEachOther) {
  EXPECT_EQ(Read("There should be space around the bed. The wardrobe and the sideboard should not be close to it."),
            "accessible(object=bed, sides=[front,left,right]); away_from(object=wardrobe, target=bed); "
            "away_from(object=sideboard, target=bed)");
  ExpectAll("", "away_from(object=bed, target=wardrobe)",
            {"The bed and the wardrobe should not be close to each other.", "Keep the bed distinct from the wardrobe.",
             "Avoid placing the bed and the wardrobe side by side."});
}

TEST(Families, ThePartOfAPieceIsNotTheRooms) {
  EXPECT_EQ(Read("The bed should not block the doors of the wardrobe."), "accessible(object=wardrobe, sides=[front])");
  EXPECT_EQ(Read("The entrance should be accessible.", {"shower"}), "accessible(object=shower, sides=[front])");
  EXPECT_EQ(Read("Should not block the door.", {"shower"}), "clear_of_feature(object=shower, feature=door)");
}

TEST(Families, TwoRelationsShareWhatTheyRelateTo) {
  ExpectAll("sideboard", "near(object=sideboard, target=wardrobe); accessible(object=wardrobe, sides=[front])",
            {"Close to but not obstructing the wardrobe.", "Should be near, but must not block, the wardrobe."});
}

TEST(Families, AnyOneOfSeveralIsOne) {
  ExpectAll("sideboard", "near(object=sideboard, target=chair_1)",
            {"Should be near a dining chair.", "Within reach of one of the dining chairs."});
}

TEST(Families, LegroomIsInFront) {
  ExpectAll("table", "accessible(object=table, sides=[front], min_clearance_m=0.5)",
            {"Allow legroom of 0.5m.", "Needs 0.5m of legroom.", "Should have 0.5m leg room in front."});
}

TEST(Families, TheOtherSideIsOppositeTheOneSpokenOf) {
  EXPECT_EQ(Read("The right side should be against the wall and the other side accessible.", {"bed"}),
            "against_wall(object=bed, side=right); accessible(object=bed, sides=[left])");
}

TEST(Families, KindsThatNobodyNamesMoveNothing) {
  ExpectAll("bed", "", {"Avoid proximity to flammable objects.", "Keep away from electrical equipment."});
}

}  // namespace
}  // namespace flair::translator
