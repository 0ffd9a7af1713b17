// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of speech that models use: how names, figures and brackets are read.
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// A study: id, name, kind, zone, width, depth.
v1::TranslateRequest Study() {
  v1::TranslateRequest request;
  *request.mutable_catalog() =
      ReadCatalog(std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/catalog.textproto");
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_DOOR);
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_WINDOW);
  request.mutable_room()->add_sockets();
  for (const char* zone : {"reading", "writing"}) {
    v1::Zone& added = *request.mutable_zone_plan()->add_zones();
    added.set_id(zone);
    added.set_name(zone);
  }
  const auto add = [&](const char* id, const char* name, v1::ObjectRole role, v1::ObjectKind kind, const char* zone,
                       double width, double depth) {
    v1::Object& object = *request.mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name(name);
    object.set_role(role);
    object.set_kind(kind);
    object.set_zone_id(zone);
    object.set_width_m(width);
    object.set_depth_m(depth);
  };
  const auto floor = v1::OBJECT_KIND_FLOOR;
  add("desk", "desk", v1::OBJECT_ROLE_PRIMARY, floor, "writing", 1.4, 0.7);
  add("daybed", "daybed", v1::OBJECT_ROLE_PRIMARY, floor, "reading", 0.9, 2.0);
  add("tv_stand", "TV stand", v1::OBJECT_ROLE_PRIMARY, floor, "reading", 1.2, 0.4);
  add("bench_r", "bench", v1::OBJECT_ROLE_SECONDARY, floor, "reading", 1.2, 0.4);
  add("bench_w", "bench", v1::OBJECT_ROLE_SECONDARY, floor, "writing", 1.2, 0.4);
  add("chair", "desk chair", v1::OBJECT_ROLE_SECONDARY, floor, "writing", 0.5, 0.5);
  add("tv", "TV", v1::OBJECT_ROLE_TERTIARY, v1::OBJECT_KIND_SURFACE, "", 1.0, 0.1);
  add("tablelamp1", "tablelamp1", v1::OBJECT_ROLE_TERTIARY, v1::OBJECT_KIND_SURFACE, "", 0.2, 0.2);
  add("clock", "wallclock", v1::OBJECT_ROLE_TERTIARY, v1::OBJECT_KIND_WALL, "", 0.3, 0.05);
  return request;
}

std::string Read(const std::string& text, const std::vector<std::string>& subjects = {},
                 v1::SentenceScope scope = v1::SENTENCE_SCOPE_INTER) {
  v1::TranslateRequest request = Study();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(text);
  sentence.set_scope(scope);
  for (const std::string& subject : subjects) sentence.add_subject_ids(subject);
  std::vector<std::string> calls;
  const v1::LayoutGraph graph = Translate(request);
  for (const v1::ConstraintEdge& edge : graph.edges()) calls.push_back(ToText(edge));
  return absl::StrJoin(calls, "; ");
}

std::string Small(const std::string& text, const std::string& subject) {
  return Read(text, {subject}, v1::SENTENCE_SCOPE_TERTIARY);
}

TEST(Forms, NumbersAndZonesTellWhichOneIsMeant) {
  EXPECT_EQ(Read("Bench 2 is near the desk."), "near(object=bench_w, target=desk)");
  EXPECT_EQ(Read("The reading bench is near the desk."), "near(object=bench_r, target=desk)");
  EXPECT_EQ(Read("The Writing: Bench is near the daybed."), "near(object=bench_w, target=daybed)");
  EXPECT_EQ(Read("The left bench is near the desk."), "near(object=bench_r, target=desk)");
  EXPECT_EQ(Small("On the desk, the table lamp gives light.", "tablelamp1"),
            "on_top_center(object=tablelamp1, host=desk)");
}

TEST(Forms, SmallThingsArePlacedByTheirHeadingAndPlaceNoFurniture) {
  EXPECT_EQ(Read("The daybed should face the TV."), "facing(object=daybed, target=tv_stand)");
  EXPECT_EQ(Read("The daybed has a view of the TV screen."), "facing(object=daybed, target=tv_stand)");
  EXPECT_EQ(Read("The daybed is near a table lamp."), "");
  EXPECT_EQ(Small("Hang a small framed picture above the desk.", "clock"), "on_wall_above(object=clock, target=desk)");
  EXPECT_EQ(Small("On the right side of the desk.", "tablelamp1"), "on_top_corner(object=tablelamp1, host=desk)");
  EXPECT_EQ(Small("On the desk, leaning against the wall.", "tablelamp1"),
            "on_top_center(object=tablelamp1, host=desk)");
}

TEST(Forms, LabelsBeforeAColonAreNotReadTwice) {
  EXPECT_EQ(Read("Against a wall: Usually placed against one or two walls.", {"desk"}), "against_wall(object=desk)");
  EXPECT_EQ(Read("Accessible side: Front (for opening drawers)", {"desk"}),
            "accessible(object=desk, sides=[\"front\"])");
  EXPECT_EQ(Read("Minimum distance from the daybed: 0.5m", {"desk"}),
            "away_from(object=desk, target=daybed, min_distance_m=0.5)");
}

TEST(Forms, BracketsAddFiguresSidesAndMembers) {
  EXPECT_EQ(Read("Leave enough space (at least 0.6m) behind the desk chair."),
            "accessible(object=chair, sides=[\"back\"], min_clearance_m=0.6)");
  EXPECT_EQ(Read("One side (preferably the front) is accessible.", {"desk"}),
            "accessible(object=desk, sides=[\"front\"])");
  EXPECT_EQ(Read("Two opposite sides (e.g., front and back) are accessible.", {"desk"}),
            "accessible(object=desk, sides=[\"front\",\"back\"])");
  EXPECT_EQ(Read("Against a wall for stability (back).", {"desk"}), "against_wall(object=desk, side=back)");
  EXPECT_EQ(Read("The desk is away from the reading zone (daybed and TV stand)."),
            "away_from(object=desk, target=daybed); away_from(object=desk, target=tv_stand)");
  EXPECT_EQ(Read("The front (1.4m) is accessible.", {"desk"}), "accessible(object=desk, sides=[\"front\"])");
}

TEST(Forms, DenialsReachAcrossOrAndNor) {
  EXPECT_EQ(Read("Not in front of the window or over sockets.", {"desk"}),
            "clear_of_feature(object=desk, feature=window); clear_of_feature(object=desk, feature=socket)");
  EXPECT_EQ(Read("Neither the window nor the door should be blocked by the desk."),
            "clear_of_feature(object=desk, feature=window); clear_of_feature(object=desk, feature=door)");
  EXPECT_EQ(Read("The desk must not be too far from the daybed."), "near(object=desk, target=daybed)");
  EXPECT_EQ(Read("The front is accessible; the back need not be.", {"desk"}),
            "accessible(object=desk, sides=[\"front\"])");
}

TEST(Forms, SidesOfAThingAreNotOtherThings) {
  EXPECT_EQ(Read("Needs to be easily accessible from all sides.", {"desk"}),
            "accessible(object=desk, sides=[\"front\",\"back\",\"left\",\"right\"])");
  EXPECT_EQ(Read("Must be accessible from the front, left and right.", {"desk"}),
            "accessible(object=desk, sides=[\"front\",\"left\",\"right\"])");
  EXPECT_EQ(Read("Its top and front should be accessible.", {"desk"}), "accessible(object=desk, sides=[\"front\"])");
}

TEST(Forms, SidesAreNamedByLengthPlaceAndAdjective) {
  EXPECT_EQ(Read("The 2m side is accessible.", {"daybed"}), "accessible(object=daybed, sides=[\"left\"])");
  EXPECT_EQ(Read("The 1.4m sides are accessible.", {"desk"}), "accessible(object=desk, sides=[\"front\",\"back\"])");
  EXPECT_EQ(Read("At least one of the 2m sides is accessible.", {"daybed"}),
            "accessible(object=daybed, sides=[\"left\"])");
  EXPECT_EQ(Read("There is at least one accessible side.", {"daybed"}), "accessible(object=daybed, sides=[\"left\"])");
  EXPECT_EQ(Read("Leave 0.5m of clearance on all sides.", {"desk"}),
            "accessible(object=desk, sides=[\"front\",\"back\",\"left\",\"right\"], min_clearance_m=0.5)");
}

TEST(Forms, AFigureBelongsToTheSpaceSpokenOf) {
  EXPECT_EQ(Read("Allow space around it (at least 0.3m clearance on all sides).", {"desk"}),
            "accessible(object=desk, sides=[\"front\",\"back\",\"left\",\"right\"], min_clearance_m=0.3)");
  EXPECT_EQ(Read("Keep a 0.6m gap between the desk and the daybed."),
            "away_from(object=desk, target=daybed, min_distance_m=0.6)");
  EXPECT_EQ(Read("The desk chair stands in front of the desk, at least 1m from the daybed."),
            "in_front_of(object=chair, target=desk); away_from(object=chair, target=daybed, min_distance_m=1.0)");
}

TEST(Forms, PathsBetweenNamedPiecesAreDistances) {
  EXPECT_EQ(Read("There should be a clear walkway between the desk and the daybed."),
            "away_from(object=desk, target=daybed)");
  EXPECT_EQ(Read("There should be a clear path around the desk."),
            "accessible(object=desk, sides=[\"front\",\"left\",\"right\"])");
  EXPECT_EQ(Read("Maintain clear access to the desk."), "accessible(object=desk, sides=[\"front\"])");
  EXPECT_EQ(Read("Keep pathways between the furniture clear."), "");
}

TEST(Forms, FeaturesAsSubjectsAreKeptAwayFrom) {
  EXPECT_EQ(Read("Ensure easy access to the door.", {"desk"}), "clear_of_feature(object=desk, feature=door)");
  EXPECT_EQ(Read("Doors open freely.", {"desk"}), "clear_of_feature(object=desk, feature=door)");
  EXPECT_EQ(Read("Ensure easy access to sockets.", {"desk"}), "close_to_feature(object=desk, feature=socket)");
}

TEST(Forms, ChoicesAreTakenOnceAndReasonsOnlyWhenTheyAreAllThereIs) {
  EXPECT_EQ(Read("Against a wall to allow access to the daybed.", {"desk"}), "against_wall(object=desk)");
  EXPECT_EQ(Read("Positioned to create a nook away from the desk.", {"daybed"}),
            "away_from(object=daybed, target=desk)");
  EXPECT_EQ(Read("Does not need to be against a wall.", {"desk"}), "");
}

TEST(Forms, NothingIsRelatedToItself) {
  EXPECT_EQ(Read("Allow for easy access from the front.", {"desk"}), "accessible(object=desk, sides=[\"front\"])");
  EXPECT_EQ(Read("The desk has the desk chair placed in front of it."), "in_front_of(object=chair, target=desk)");
  EXPECT_EQ(Read("The desk is near the desk."), "");
}

// A distance as such only keeps apart; a range also asks to be near.
TEST(Forms, DistancesKeepApartAndRangesAlsoKeepNear) {
  const std::string apart = "away_from(object=desk, target=daybed, min_distance_m=0.5)";
  EXPECT_EQ(Read("Keep 0.5m distance between the desk and the daybed."), apart);
  EXPECT_EQ(Read("The desk and the daybed should be separated by at least 0.5m."), apart);
  EXPECT_EQ(Read("There is a gap of 0.5m between the edge of the desk and the front of the daybed."), apart);
  EXPECT_EQ(Read("The desk should be 0.5m - 1m from the daybed."),
            apart + "; near(object=desk, target=daybed, max_distance_m=1.0)");
  EXPECT_EQ(Read("The chair is in front of the desk at a distance of 0.1m."),
            "in_front_of(object=chair, target=desk, distance_m=0.1)");
}

TEST(Forms, FreeSidesAreThoseThatAreMeant) {
  const auto intra = [](const char* text, const char* subject) {
    return Read(text, {subject}, v1::SENTENCE_SCOPE_INTRA);
  };
  EXPECT_EQ(Read("The desk is at least 0.5m from the wall on its left side."),
            "accessible(object=desk, sides=[\"left\"], min_clearance_m=0.5)");
  EXPECT_EQ(intra("Needs enough surrounding space.", "desk"),
            "accessible(object=desk, sides=[\"front\",\"left\",\"right\"])");
  EXPECT_EQ(intra("Needs space around it.", "chair"),
            "accessible(object=chair, sides=[\"front\",\"back\",\"left\",\"right\"])");
  EXPECT_EQ(intra("Against a wall with both sides accessible.", "desk"),
            "against_wall(object=desk); accessible(object=desk, sides=[\"left\",\"right\"])");
  EXPECT_EQ(intra("Keep the front clear.", "desk"), "accessible(object=desk, sides=[\"front\"])");
  EXPECT_EQ(intra("Nothing should be placed in front of it.", "desk"), "accessible(object=desk, sides=[\"front\"])");
}

TEST(Forms, AccessToAnAreaAndEmptySpaceBetweenThingsAreRefused) {
  EXPECT_EQ(Read("The desk should be oriented to facilitate easy access to the reading area."), "");
  EXPECT_EQ(Read("Do not place any furniture between the desk and the daybed."), "");
  EXPECT_EQ(Read("The desk should not hinder movement around the daybed."), "");
}

TEST(Forms, ClausesLeaveToOthersWhatTheyShare) {
  EXPECT_EQ(Read("0.8 m of space on the left as well as on the right.", {"desk"}, v1::SENTENCE_SCOPE_INTRA),
            "accessible(object=desk, sides=[\"left\",\"right\"], min_clearance_m=0.8)");
}

TEST(Forms, WhatMustNotBeBlockedIsToBeGotAt) {
  EXPECT_EQ(Read("Must not be in the door's way.", {"desk"}, v1::SENTENCE_SCOPE_INTRA),
            "clear_of_feature(object=desk, feature=door)");
}

TEST(Forms, HowCloseIsNoSideAndWhoseSideIsSaidFirst) {
  EXPECT_EQ(Read("The desk is to the left of the daybed, at most 0.5 m from it.", {"desk", "daybed"}),
            "next_to(object=desk, target=daybed, target_side=left); "
            "near(object=desk, target=daybed, max_distance_m=0.5)");
}

TEST(Forms, TheLastAndTheFirstOneAreOfTheirKind) {
  EXPECT_EQ(Read("The desk is beside the last bench.", {"desk"}), "next_to(object=desk, target=bench_w)");
  EXPECT_EQ(Read("The second bench is to the right of the first one.", {"bench_r", "bench_w"}),
            "next_to(object=bench_w, target=bench_r, target_side=right)");
}

}  // namespace
}  // namespace flair::translator
