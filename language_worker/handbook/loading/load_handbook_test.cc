// SPDX-License-Identifier: GPL-3.0-or-later
// Users' own data over ours, and what is said of faults in it.
#include "language_worker/handbook/loading/load_handbook.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "flair/v1/brief.pb.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"

namespace flair::language {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kPiece = R"(
furniture {
  name: "record cabinet"
  synonyms: "vinyl cabinet"
  category: "cabinet"
  width_m { typical: 1.2 } depth_m { typical: 0.4 } height_m { typical: 0.8 }
  material_group: "wood"
  relations { text: "The {object}'s back is against a wall." }
}
)";

class LoadHandbookTest : public testing::Test {
 protected:
  LoadHandbookTest() { std::filesystem::create_directories(folder_); }
  ~LoadHandbookTest() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  HandbookFindings Check() const { return *CheckHandbook(DefaultHandbookFolder(), {folder_}); }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("handbook_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(LoadHandbookTest, AnOwnPieceIsAskedForByItsName) {
  Write("pieces.textproto", kPiece);
  const auto handbook = LoadHandbook(DefaultHandbookFolder(), {folder_});
  ASSERT_TRUE(handbook.ok()) << handbook.status();
  v1::Brief brief;
  brief.set_text("A living room with a vinyl cabinet.");
  const v1::Room room = *DescribeRoom(brief, **handbook);
  const v1::ZonePlan zones = *PlanZones(brief, room, **handbook);
  std::vector<std::string> names;
  const v1::ObjectList list = *ListObjects(brief, room, zones, **handbook);
  for (const v1::Object& object : list.objects()) names.push_back(object.name());
  EXPECT_THAT(names, Contains("record cabinet"));
}

TEST_F(LoadHandbookTest, AnOwnEntryTakesThePlaceOfOursAndItsWordsGoFirst) {
  const auto ours = LoadHandbook(DefaultHandbookFolder());
  ASSERT_TRUE(ours.ok());
  hb::Style style = *(*ours)->FindStyle("scandinavian");
  style.set_title("north");
  Write("styles.textproto", "styles {" + style.DebugString() + "}");
  Write("pieces.textproto", kPiece);
  const auto handbook = LoadHandbook(DefaultHandbookFolder(), {folder_});
  ASSERT_TRUE(handbook.ok()) << handbook.status();
  EXPECT_EQ((*handbook)->FindStyle("scandinavian")->title(), "north");
  EXPECT_EQ((*handbook)->contents().styles_size(), (*ours)->contents().styles_size());
  EXPECT_EQ((*handbook)->contents().furniture(0).name(), "record cabinet");
  EXPECT_NE((*handbook)->version(), (*ours)->version());
}

TEST_F(LoadHandbookTest, ACategoryStandsForAllItsOtherClasses) {
  Write("pieces.textproto", R"(
furniture {
  name: "pouf"
  category: "stool"
  width_m { typical: 0.5 }
  depth_m { typical: 0.5 }
  height_m { typical: 0.4 }
  material_group: "upholstery"
  relations { text: "The {object} is near the {target}." targets: "loveseat" target_categories: "sofa" }
}
)");
  const auto handbook = LoadHandbook(DefaultHandbookFolder(), {folder_});
  ASSERT_TRUE(handbook.ok()) << handbook.status();
  const auto& targets = (*handbook)->FindFurniture("pouf")->relations(0).targets();
  EXPECT_EQ(targets[0], "loveseat");
  EXPECT_EQ(std::ranges::count(targets, "loveseat"), 1);
  EXPECT_THAT(targets, Contains("curved sofa"));
}

TEST_F(LoadHandbookTest, EveryFaultIsNamedWithFileLineAndField) {
  Write("pieces.textproto", R"(
furniture {
  name: "record cabinet"
  category: "cabinet"
  width_m { typical: 1.2 max: 1 }
  depth_m { typical: 0.4 }
  material_group: "woood"
  zone_hints: ["music", "no such zone"]
  relations {
    text: "The {object} is near {somewhere}."
    targets: "soffa"
    condition { rooms: "attic bar" with: "lamp of nobody" min_count: 3 max_count: 2 }
  }
}
)");
  const std::string file = (folder_ / "pieces.textproto").string();
  const auto at = [&](int line, const std::string& field) {
    return HasSubstr(file + ":" + std::to_string(line) + ": furniture \"record cabinet\": " + field);
  };
  const std::vector<std::string> faults = Check().faults;
  EXPECT_THAT(faults, Contains(at(5, "width_m: 1.2 (min 0, max 1) must be")));
  EXPECT_THAT(faults, Contains(at(2, "height_m: is missing")));
  EXPECT_THAT(faults, Contains(at(7, "material_group: there is no material group \"woood\"; did you mean \"wood\"?")));
  EXPECT_THAT(faults, Contains(at(8, "zone_hints[1]: there is no zone \"no such zone\"")));
  EXPECT_THAT(faults, Contains(at(10, "relations[0].text: {somewhere} is not a placeholder")));
  EXPECT_THAT(faults,
              Contains(at(11, "relations[0].targets[0]: there is no furniture \"soffa\"; did you mean \"sofa\"?")));
  EXPECT_THAT(faults, Contains(at(12, "relations[0].condition.rooms[0]: there is no archetype \"attic bar\"")));
  EXPECT_THAT(faults, Contains(at(12, "relations[0].condition.with[0]: there is no furniture")));
  EXPECT_THAT(faults, Contains(at(12, "relations[0].condition: min_count is above max_count")));
  const auto handbook = LoadHandbook(DefaultHandbookFolder(), {folder_});
  EXPECT_EQ(handbook.status().code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(LoadHandbookTest, SyntaxAndRepeatedNamesAreFaults) {
  Write("a.textproto", kPiece);
  Write("b.textproto", kPiece);
  EXPECT_THAT(Check().faults, ElementsAre(HasSubstr("is already defined in " + (folder_ / "a.textproto").string())));
  Write("b.textproto", "furniture { nam: \"x\" }");
  EXPECT_THAT(Check().faults, Contains(HasSubstr("b.textproto:1:")));
}

TEST_F(LoadHandbookTest, ACategoryOfNobodyIsANote) {
  std::string text = kPiece;
  text.replace(text.find("\"cabinet\""), 9, "\"cabnet\"");
  Write("pieces.textproto", text);
  const HandbookFindings findings = Check();
  EXPECT_THAT(findings.faults, IsEmpty());
  EXPECT_THAT(findings.notes, ElementsAre(HasSubstr("did you mean \"cabinet\"?")));
  ASSERT_EQ(findings.sentences.size(), 1u);
  EXPECT_EQ(findings.sentences[0].object, "record cabinet");
}

// The blocks of docs/handbook.md, as a reader would type them.
TEST_F(LoadHandbookTest, TheExamplesOfTheGuideMakeARoom) {
  std::ifstream page(FLAIR_SOURCE_DIR "/docs/handbook.md");
  std::string line, name, text;
  for (bool inside = false; std::getline(page, line);) {
    if (line == "```textproto") {
      inside = true;
      text.clear();
    } else if (inside && line == "```") {
      inside = false;
      Write(name, text);
    } else if (inside) {
      if (text.empty()) name = line.substr(2);
      text += line + "\n";
    }
  }
  const auto handbook = LoadHandbook(DefaultHandbookFolder(), {folder_});
  ASSERT_TRUE(handbook.ok()) << handbook.status();
  v1::Brief brief;
  brief.set_text("A tea room for four, 4 m x 4 m.");
  const v1::Room room = *DescribeRoom(brief, **handbook);
  EXPECT_EQ(room.room_type(), "tea room");
  const v1::ObjectList list = *ListObjects(brief, room, *PlanZones(brief, room, **handbook), **handbook);
  EXPECT_EQ(list.objects(0).name(), "tea table");
  EXPECT_EQ(ChooseStyle(brief, room, list, **handbook)->name(), "quiet paper");
}

TEST_F(LoadHandbookTest, AFolderWithoutDataIsSaid) {
  EXPECT_EQ(LoadHandbook(DefaultHandbookFolder(), {folder_}).status().code(), absl::StatusCode::kNotFound);
}

}  // namespace
}  // namespace flair::language
