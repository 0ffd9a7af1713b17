// SPDX-License-Identifier: GPL-3.0-or-later
// What a model's answer has wrong is told to it with its place and figures; what stays wrong is left out and said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "language_worker/service/testing/model_session.h"

namespace flair::language {
namespace {

using nlohmann::json;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Changes the good answer of a step.
std::string Changed(const std::string& step, const std::function<void(json&)>& change) {
  json answer = json::parse(GoodAnswers().at(step));
  change(answer);
  return answer.dump();
}

// A session in which the step stays with a changed answer, everything before it having been answered well.
class StubbornSession {
 public:
  StubbornSession(const std::string& step, const std::function<void(json&)>& change) : session_(step), step_(step) {
    session_.model().Answer(step, Changed(step, change));
    session_.model().Answer(step + "/repair", Changed(step, change));
    for (const auto& [name, answer] : GoodAnswers()) {
      if (name != step) session_.model().Answer(name + "/repair", answer);
    }
  }

  ModelSession& operator*() { return session_; }
  ModelSession* operator->() { return &session_; }

  v1::ObjectList Objects() {
    EXPECT_TRUE(session_.DescribeRoom().ok());
    EXPECT_TRUE(session_.PlanZones().ok());
    const auto response = session_.ListObjects();
    EXPECT_TRUE(response.ok()) << response.status();
    return response.ok() ? response->object_list() : v1::ObjectList();
  }

  // What the model was told in the repair; empty when there was none.
  std::string Repair() {
    for (const llm::ChatRequest& request : session_.model().requests()) {
      if (request.step == step_ + "/repair") return request.messages.back().text;
    }
    return "";
  }

 private:
  ModelSession session_;
  const std::string step_;
};

int CountOf(const v1::ObjectList& list, const std::string& name) {
  return static_cast<int>(std::count_if(list.objects().begin(), list.objects().end(),
                                        [&](const v1::Object& object) { return object.name() == name; }));
}

bool HasDiagnostic(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& diagnostics, const std::string& code,
                   const std::string& text) {
  return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const v1::Diagnostic& diagnostic) {
    return diagnostic.code() == code && diagnostic.message().find(text) != std::string::npos;
  });
}

struct ObjectCase {
  std::string name;
  std::string step;
  std::string field;
  json value;
  std::string told;
  // The object that is then left out; empty when it stays.
  std::string left_out;
};

class ObjectFaults : public ::testing::TestWithParam<ObjectCase> {};

// The case changes the second line of the list: nightstands, or the painting.
TEST_P(ObjectFaults, AreToldWithPlaceAndFiguresAndLeftOutAlone) {
  const ObjectCase& c = GetParam();
  StubbornSession session(c.step, [&](json& answer) { answer["objects"][1][c.field] = c.value; });
  const v1::ObjectList list = session.Objects();
  EXPECT_THAT(session.Repair(), HasSubstr("objects[1]." + c.told));
  if (!c.left_out.empty()) {
    EXPECT_EQ(CountOf(list, c.left_out), 0);
    EXPECT_TRUE(HasDiagnostic(list.diagnostics(), "left_out", "objects[1]." + c.told)) << list.DebugString();
  }
  EXPECT_EQ(CountOf(list, "double bed"), 1);
  EXPECT_EQ(CountOf(list, "area rug"), 1);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ObjectFaults,
    ::testing::ValuesIn(std::vector<ObjectCase>{
        {"LargerThanTheRoom", "objects.floor", "width_m", 5.5,
         "width_m: 5.5 m x 0.4 m is larger than the room of 4 m x 5 m", "nightstand"},
        {"Centimetres", "objects.floor", "width_m", 45,
         "width_m: is 45; a number in metres, 0.05 to 20 would be right", "nightstand"},
        {"NoSize", "objects.floor", "depth_m", 0, "depth_m: is 0; a number in metres", "nightstand"},
        {"NegativeSize", "objects.floor", "height_m", -0.5, "height_m: is -0.5; a number in metres", "nightstand"},
        {"ZeroCount", "objects.floor", "count", 0, "count: is 0; a whole number, 1 to 40", "nightstand"},
        {"HundredsOfThem", "objects.floor", "count", 300, "count: is 300; a whole number, 1 to 40", "nightstand"},
        {"UnknownZone", "objects.floor", "zone", "attic",
         "zone: is \"attic\"; one of \"sleeping\", \"storage\", \"working\"", "nightstand"},
        {"NoName", "objects.floor", "name", "", "name: is \"\"; a text", "nightstand"},
        {"OddSize", "objects.floor", "width_m", 2.4, "width_m: is 2.4 m x 0.4 m; a nightstand usually measures", ""},
        {"OnUnknownObject", "objects.tertiary", "at", "piano", "at: is \"piano\"; one of \"double_bed\"", "painting"},
        {"UnknownKind", "objects.tertiary", "kind", "mirror-like", "kind: is \"mirror-like\"; one of \"wall\"",
         "painting"},
        {"NoPlacement", "objects.tertiary", "placement", nullptr, "placement: is missing", "painting"},
        {"PaintingAcrossTheRoom", "objects.tertiary", "width_m", 5.2, "width_m: 5.2 m x 0.03 m is larger than the room",
         "painting"},
    }),
    [](const auto& info) { return info.param.name; });

TEST(StepFaults, LengthsWithUnitsAreUnderstood) {
  StubbornSession session("objects.floor", [](json& answer) {
    answer["objects"][0]["width_m"] = "160 cm";
    answer["objects"][0]["depth_m"] = "2 m";
    answer["objects"][0]["height_m"] = "500 mm";
  });
  const v1::ObjectList list = session.Objects();
  EXPECT_THAT(session.Repair(), IsEmpty());
  EXPECT_NEAR(list.objects(0).width_m(), 1.6, 1e-9);
  EXPECT_NEAR(list.objects(0).depth_m(), 2, 1e-9);
  EXPECT_NEAR(list.objects(0).height_m(), 0.5, 1e-9);
}

TEST(StepFaults, ACrowdIsThinnedWithTheReasonAndPrimariesStay) {
  StubbornSession session("objects.floor", [](json& answer) {
    for (int i = 0; i < 20; ++i) {
      json more = answer["objects"][1];
      more["name"] = "armchair " + std::to_string(i);
      more["count"] = 10;
      more["width_m"] = 0.8;
      more["depth_m"] = 0.8;
      answer["objects"].push_back(more);
    }
  });
  const v1::ObjectList list = session.Objects();
  EXPECT_THAT(session.Repair(), AnyOf(HasSubstr("has 206 objects in all; at most 60"), HasSubstr("covers")));
  double covered_m2 = 0;
  for (const v1::Object& object : list.objects()) {
    if (object.role() != v1::OBJECT_ROLE_TERTIARY) covered_m2 += object.width_m() * object.depth_m();
  }
  EXPECT_LE(covered_m2, 12);
  EXPECT_GT(covered_m2, 10);
  EXPECT_EQ(CountOf(list, "double bed"), 1);
  EXPECT_EQ(CountOf(list, "desk"), 1);
  std::vector<std::string> reasons;
  for (const v1::Omission& omission : list.omissions()) reasons.push_back(omission.reason());
  EXPECT_THAT(reasons, Contains("The model listed 206 pieces; a room takes 60 at most."));
  EXPECT_THAT(reasons, Contains(HasSubstr("of the floor; 60 % at most.")));
}

TEST(StepFaults, EqualLinesAreOneAndDifferentOnesOfANameGetIdsOfTheirOwn) {
  StubbornSession session("objects.floor", [](json& answer) {
    json second = answer["objects"][2];
    answer["objects"].push_back(second);
    second["width_m"] = 0.8;
    answer["objects"].push_back(second);
  });
  const v1::ObjectList list = session.Objects();
  std::vector<std::string> ids;
  for (const v1::Object& object : list.objects()) ids.push_back(object.id());
  EXPECT_THAT(ids, ::testing::IsSupersetOf({"wardrobe_1", "wardrobe_2", "wardrobe"}));
  EXPECT_EQ(CountOf(list, "wardrobe"), 3);
}

TEST(StepFaults, AZoneWithoutAPrimaryGetsItsFirstObject) {
  StubbornSession session("objects.floor", [](json& answer) {
    for (json& object : answer["objects"]) object["primary"] = false;
  });
  const v1::ObjectList list = session.Objects();
  EXPECT_THAT(session.Repair(), IsEmpty()) << "no call is worth that";
  EXPECT_EQ(std::count_if(list.objects().begin(), list.objects().end(),
                          [](const v1::Object& object) { return object.role() == v1::OBJECT_ROLE_PRIMARY; }),
            3);
}

TEST(StepFaults, RugsAndLampsAmongTheFurnitureAreTakenForWhatTheyAre) {
  StubbornSession session("objects.floor", [](json& answer) {
    json rug = answer["objects"][1];
    rug["name"] = "persian rug";
    rug["count"] = 1;
    rug["width_m"] = 2;
    rug["depth_m"] = 1.4;
    rug["height_m"] = 0.01;
    answer["objects"].push_back(rug);
  });
  const v1::ObjectList list = session.Objects();
  const auto rug = std::find_if(list.objects().begin(), list.objects().end(),
                                [](const v1::Object& object) { return object.id() == "persian_rug"; });
  ASSERT_NE(rug, list.objects().end());
  EXPECT_EQ(rug->role(), v1::OBJECT_ROLE_TERTIARY);
  EXPECT_TRUE(rug->walk_over());
  ASSERT_TRUE(session->ListConstraints().ok());
}

TEST(StepFaults, WhatTheBriefNamesAndTheModelForgetsIsAnOmission) {
  StubbornSession session("objects.floor", [](json&) {});
  session->brief().set_text("A bedroom that is 4m x 5m with a desk and a grand piano.");
  const v1::ObjectList list = session.Objects();
  std::vector<std::string> omitted;
  for (const v1::Omission& omission : list.omissions()) omitted.push_back(omission.name());
  EXPECT_THAT(omitted, Contains("grand piano"));
  for (const v1::Object& object : list.objects()) {
    if (object.id() == "desk") {
      EXPECT_TRUE(object.requested());
    }
  }
}

TEST(StepFaults, OpeningsThatCannotBeAreLeftOutAndARoomHasADoor) {
  StubbornSession wide("room", [](json& answer) {
    answer["openings"][1]["width_m"] = 7;
    answer["openings"].push_back(answer["openings"][0]);
  });
  const v1::Room room = wide->DescribeRoom()->room();
  EXPECT_THAT(wide.Repair(), HasSubstr("openings[1].width_m: is 7; its wall has 4 m"));
  EXPECT_THAT(wide.Repair(),
              HasSubstr("openings[2].position: is 0.2; it overlaps openings[0] on the south wall there"));
  EXPECT_THAT(room.openings(), SizeIs(1));
  StubbornSession closed("room", [](json& answer) { answer["openings"].clear(); });
  const v1::Room usual = closed->DescribeRoom()->room();
  EXPECT_THAT(closed.Repair(), HasSubstr("openings: has no door; a room has one"));
  EXPECT_EQ(usual.openings(0).kind(), v1::OPENING_KIND_DOOR);
  EXPECT_TRUE(HasDiagnostic(usual.diagnostics(), "openings_assumed", "no door"));
}

TEST(StepFaults, ZonesNamedTwiceAreOne) {
  StubbornSession session("zones", [](json& answer) {
    answer["zones"].push_back({{"name", "Sleeping"}, {"purpose", "More sleep."}});
  });
  ASSERT_TRUE(session->DescribeRoom().ok());
  const auto zones = session->PlanZones();
  ASSERT_TRUE(zones.ok()) << zones.status();
  EXPECT_THAT(session.Repair(), HasSubstr("zones[3].name: \"Sleeping\" is there already"));
  EXPECT_THAT(zones->zone_plan().zones(), SizeIs(3));
}

TEST(StepFaults, ZonesInAnyScriptHaveIds) {
  StubbornSession session("zones", [](json& answer) {
    answer["zones"] = {{{"name", "睡眠"}, {"purpose", "休息"}}, {{"name", "読書"}, {"purpose", "本"}}};
  });
  ASSERT_TRUE(session->DescribeRoom().ok());
  const v1::ZonePlan plan = session->PlanZones()->zone_plan();
  EXPECT_EQ(plan.zones(0).id(), "zone");
  EXPECT_EQ(plan.zones(1).id(), "zone_2");
  EXPECT_EQ(plan.zones(1).name(), "読書");
}

TEST(StepFaults, ColoursThatAreNoneLeaveTheirThingToTheHandbook) {
  StubbornSession session("style", [](json& answer) {
    answer["looks"][0]["colour"] = "mystery #GGGGGG";
    answer["looks"][1]["colour"] = "sage green #greenish";
  });
  session.Objects();
  const auto style = session->ChooseStyle();
  ASSERT_TRUE(style.ok()) << style.status();
  EXPECT_THAT(session.Repair(), HasSubstr("looks[0].colour: is \"mystery #GGGGGG\""));
  for (const v1::ObjectStyle& look : style->style_sheet().objects()) {
    if (look.subject_id() == "double_bed") {
      EXPECT_NE(look.description(), "A low oak bed.");
    } else if (look.subject_id() == "nightstand_1") {
      EXPECT_EQ(look.colour().name(), "sage green") << "a name that is known";
    }
  }
}

TEST(StepFaults, SentencesAboutThingsThatAreNotThereGo) {
  StubbornSession session("constraints.inter", [](json& answer) {
    answer["constraints"].push_back(
        {{"objects", {"piano", "desk"}}, {"must", {"The piano is by the desk."}}, {"should", json::array()}});
  });
  session.Objects();
  const auto list = session->ListConstraints();
  ASSERT_TRUE(list.ok()) << list.status();
  EXPECT_THAT(session.Repair(), HasSubstr("constraints[4].objects[0]: is \"piano\"; one of"));
  for (const v1::Sentence& sentence : list->constraint_list().sentences()) {
    EXPECT_EQ(sentence.text().find("piano"), std::string::npos);
  }
}

TEST(StepFaults, ChangesThatDoNotWhatTheySayAreNotMade) {
  StubbornSession session("cleaning", [](json& answer) {
    answer["changes"] = {{{"from", {"s1", "s2"}}, {"to", {"The bed is by a wall.", "It is there."}}}, "s99: none"};
  });
  session.Objects();
  const auto raw = session->ListConstraints();
  ASSERT_TRUE(raw.ok()) << raw.status();
  const auto cleaned = session->CleanConstraints();
  ASSERT_TRUE(cleaned.ok()) << cleaned.status();
  EXPECT_THAT(session.Repair(), HasSubstr("changes[0]: makes several sentences of several"));
  EXPECT_THAT(session.Repair(), HasSubstr("changes[1]: names \"s99\""));
  EXPECT_GE(cleaned->constraint_list().sentences_size(), raw->constraint_list().sentences_size());
}

TEST(StepFaults, AModelThatWouldRemoveMostSentencesIsNotFollowed) {
  StubbornSession session("cleaning", [](json& answer) {
    answer["changes"] = json::array();
    for (const char* id : {"s1", "s2", "s3", "s4", "s5", "s7", "s8", "s9", "s10"}) {
      answer["changes"].push_back(std::string(id) + ": none(no)");
    }
  });
  session.Objects();
  const auto raw = session->ListConstraints();
  ASSERT_TRUE(raw.ok()) << raw.status();
  const auto cleaned = session->CleanConstraints();
  ASSERT_TRUE(cleaned.ok()) << cleaned.status();
  EXPECT_GE(cleaned->constraint_list().sentences_size(), raw->constraint_list().sentences_size());
  EXPECT_TRUE(HasDiagnostic(cleaned->constraint_list().diagnostics(), "removals_refused", "they stay"));
}

}  // namespace
}  // namespace flair::language
