// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "cli/replay/comparison.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {
namespace {

v1::SolvedLayout Layout(const std::string& text) {
  v1::SolvedLayout layout;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &layout)) << text;
  return layout;
}

std::string Words(const std::string& first, const std::string& second, const std::vector<std::string>& aside = {}) {
  const std::optional<FieldDifference> found = FirstDifference(Layout(first), Layout(second), aside);
  return found.has_value() ? found->InWords() : "equal";
}

constexpr char kTwo[] = "placements { object_id: 'bed' x_m: 1 } placements { object_id: 'lamp' x_m: 1.2 }";

TEST(FirstDifference, NamesPathAndBothValues) {
  EXPECT_EQ(Words(kTwo, kTwo), "equal");
  EXPECT_EQ(Words(kTwo, "placements { object_id: 'bed' x_m: 1 } placements { object_id: 'lamp' x_m: 1.24 }"),
            "placements[1].x_m: 1.2 -> 1.24");
  EXPECT_EQ(Words(kTwo, "placements { object_id: 'bed' x_m: 1 } placements { x_m: 1.2 }"),
            "placements[1].object_id: \"lamp\" -> none");
}

TEST(FirstDifference, SaysWhatOnlyOneSideHas) {
  EXPECT_EQ(Words(kTwo, "placements { object_id: 'bed' x_m: 1 }"),
            "placements[1]: { object_id: \"lamp\" x_m: 1.2 } -> none");
  EXPECT_EQ(Words("", "total_cost: 3"), "total_cost: none -> 3");
  EXPECT_EQ(Words("placements {}", "placements {} placements { object_id: 'a' }"),
            "placements[1]: none -> { object_id: \"a\" }");
}

TEST(FirstDifference, TakesTheFirstInTheOrderOfTheFieldsAndCountsAll) {
  const auto found = FirstDifference(Layout("total_cost: 1 placements { x_m: 1 y_m: 2 }"),
                                     Layout("total_cost: 2 placements { x_m: 3 y_m: 4 }"));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->path, "placements[0].x_m");
  EXPECT_EQ(found->field_count, 3);
}

TEST(FirstDifference, LooksAtFieldsThatWerePutAsideOnlyWhenNothingElseDiffers) {
  const std::string first = "graph { catalog_library: 'a' } total_cost: 1";
  EXPECT_EQ(Words(first, "graph { catalog_library: 'b' } total_cost: 2", {"graph"}), "total_cost: 1 -> 2");
  EXPECT_EQ(Words(first, "graph { catalog_library: 'b' } total_cost: 1", {"graph"}),
            "graph.catalog_library: \"a\" -> \"b\"");
}

TEST(FirstDifference, KeepsLongTextsShort) {
  const std::string words = Words("graph { catalog_library: '" + std::string(5000, 'x') + "' }", "graph {}");
  EXPECT_LT(words.size(), 200u);
}

}  // namespace
}  // namespace flair::cli
