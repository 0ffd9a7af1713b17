// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

using testing::HasSubstr;

struct BadCall {
  const char* name;
  const char* type;
  const char* call;
  absl::StatusCode code;
  const char* message;
};

class BadCalls : public testing::TestWithParam<BadCall> {};

TEST_P(BadCalls, AreRefusedWithTheReason) {
  const auto text =
      ParseScene("4x3 room; zone sleeping; door south 1 0.9; bed 1.6x2 at 2,1,0; desk 1x0.6 at 2,2.7,180");
  ASSERT_TRUE(text.ok());
  const auto cost = Bind(EdgeFromText(GetParam().type, GetParam().call), {text->scene, text->zone_centers});
  EXPECT_EQ(cost.status().code(), GetParam().code) << cost.status();
  EXPECT_THAT(std::string(cost.status().message()), HasSubstr(GetParam().message));
}

using enum absl::StatusCode;
INSTANTIATE_TEST_SUITE_P(
    Registry, BadCalls,
    testing::Values(
        BadCall{"UnknownType", "hover_over", "object=bed", kInvalidArgument, "no constraint type \"hover_over\""},
        BadCall{"MissingArgument", "against_wall", "", kInvalidArgument, "needs argument object"},
        BadCall{"UnknownArgument", "against_wall", "object=bed sides=back", kInvalidArgument, "has no argument sides"},
        BadCall{"TwiceTheSame", "against_wall", "object=bed object=desk", kInvalidArgument, "given twice"},
        BadCall{"UnknownObject", "against_wall", "object=sofa", kNotFound, "no object \"sofa\""},
        BadCall{"UnknownSide", "against_wall", "object=bed side=top", kInvalidArgument, "\"top\" is not a side"},
        BadCall{"UnknownWall", "against_wall", "object=bed wall=up", kNotFound,
                "the room has south, east, north, west"},
        BadCall{"UnknownZone", "in_zone", "object=bed zone=cooking", kNotFound, "no zone \"cooking\""},
        BadCall{"AbsentFeature", "close_to_feature", "object=bed feature=window", kFailedPrecondition,
                "the room has no window"},
        BadCall{"NoFeature", "close_to_feature", "object=bed feature=plug", kInvalidArgument,
                "use door, window, socket or the id"},
        BadCall{"NoWindow", "under_window", "object=bed", kFailedPrecondition, "no window"},
        BadCall{"OutOfRange", "near", "object=bed target=desk max_distance_m=-1", kInvalidArgument, "use 0 to 50 m"},
        BadCall{"SameObject", "near", "object=bed target=bed", kInvalidArgument, "\"bed\" is named twice"},
        BadCall{"NoCorner", "on_top_corner", "object=bed host=desk corner=tl", kInvalidArgument, "is not a corner"},
        BadCall{"EmptyList", "surround", "center=desk objects=", kInvalidArgument, "at least one"}),
    [](const auto& info) { return info.param.name; });

TEST(Registry, RecordedNamesAreAliases) {
  for (const char* name : {"ind_next_to_wall",
                           "ind_near_wall",
                           "ind_in_corner",
                           "ind_close_to_fixed_object",
                           "ind_away_from_fixed_object",
                           "ind_accessible",
                           "ind_central",
                           "ind_in_region",
                           "ind_not_block_fixed_object",
                           "ind_under_window",
                           "ind_facing_into_room",
                           "ind_not_against_wall",
                           "ind_not_in_corner",
                           "ind_parallel_to_wall",
                           "io_next_to",
                           "io_away_from",
                           "io_near",
                           "io_parallel",
                           "io_facing",
                           "io_not_facing",
                           "io_infront",
                           "io_perp",
                           "io_surround",
                           "io_between",
                           "io_on",
                           "io_under_central",
                           "rug_under_central",
                           "rug_under_central_forward",
                           "on_top_central",
                           "on_top_corner",
                           "on_wall_near",
                           "on_wall_above",
                           "on_wall_in_region",
                           "center_ceiling",
                           "ceiling_above"}) {
    EXPECT_NE(FindConstraint(name), nullptr) << name;
  }
}

TEST(Registry, TheCatalogueIsSortedAndItsExamplesNameTheParametersOfTheirType) {
  const v1::ConstraintCatalog& catalog = MakeCatalog();
  ASSERT_EQ(static_cast<size_t>(catalog.types_size()), AllConstraints().size());
  for (int i = 0; i < catalog.types_size(); ++i) {
    const v1::ConstraintType& type = catalog.types(i);
    if (i > 0) {
      EXPECT_LT(catalog.types(i - 1).name(), type.name());
    }
    std::set<std::string> parameters;
    for (const v1::ParameterSpec& spec : type.parameters()) {
      EXPECT_TRUE(parameters.insert(spec.name()).second);
      EXPECT_FALSE(spec.doc().empty()) << type.name() << " " << spec.name();
    }
    for (const v1::CallExample& example : type.examples()) {
      std::set<std::string> given;
      for (const v1::Argument& argument : example.arguments()) {
        EXPECT_TRUE(parameters.contains(argument.name())) << type.name() << " " << argument.name();
        given.insert(argument.name());
      }
      for (const v1::ParameterSpec& spec : type.parameters()) {
        EXPECT_TRUE(!spec.required() || given.contains(spec.name())) << type.name() << ": " << example.sentence();
      }
    }
  }
}

TEST(Registry, NamedObjectsAreThoseOfTheCall) {
  const auto text = ParseScene("4x3 room; bed 1.6x2 at 2,1,0; desk 1x0.6 at 2,2.7,180; chair 0.5x0.5 at 1,1,0");
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(NamedObjects(EdgeFromText("next_to", "object=chair target=bed"), text->scene), (std::vector<int>{0, 2}));
  EXPECT_TRUE(NamedObjects(EdgeFromText("next_to", "object=chair target=sofa"), text->scene).empty());
}

}  // namespace
}  // namespace flair::optimizer
