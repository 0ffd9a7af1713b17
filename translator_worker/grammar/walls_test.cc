// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and corners by what people call them, in a room that has two walls in the south and two in the east.
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_join.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

using testing::HasSubstr;

v1::LayoutGraph Translated(const std::string& text) {
  v1::TranslateRequest request;
  *request.mutable_catalog() =
      ReadCatalog(std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/catalog.textproto");
  v1::Room& room = *request.mutable_room();
  room.set_height_m(2.6);
  for (const auto& [x_m, y_m] : {std::pair(0., 0.), {4., 0.}, {4., 2.}, {6., 2.}, {6., 5.}, {0., 5.}}) {
    v1::Point2& corner = *room.mutable_floor()->add_vertices();
    corner.set_x_m(x_m);
    corner.set_y_m(y_m);
    room.add_walls()->set_name("wall_" + std::to_string(room.floor().vertices_size()));
  }
  for (const auto& [id, wall] : {std::pair("door_1", "wall_1"), {"window_1", "wall_4"}}) {
    v1::Opening& opening = *room.add_openings();
    opening.set_id(id);
    opening.set_wall(wall);
    opening.set_offset_m(1);
    opening.set_width_m(0.9);
    opening.set_head_height_m(2);
    const bool door = *id == 'd';
    opening.set_kind(door ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
    if (door) opening.mutable_leaf()->set_swing(v1::DOOR_SWING_NONE);
  }
  for (const auto& [id, kind] : {std::pair("bookshelf", v1::OBJECT_KIND_FLOOR),
                                 {"sofa", v1::OBJECT_KIND_FLOOR},
                                 {"painting", v1::OBJECT_KIND_WALL}}) {
    v1::Object& object = *request.mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name(id);
    object.set_kind(kind);
    object.set_width_m(1);
    object.set_depth_m(0.3);
  }
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(text);
  sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
  return Translate(request);
}

TEST(WallNames, MeanWallsOrASideOfTheRoom) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"The bookshelf is against the north wall.", "against_wall(object=bookshelf, wall=wall_5)"},
      {"The bookshelf is against the south wall.", "against_wall(object=bookshelf, wall=wall_1|wall_3)"},
      {"The bookshelf is against the shorter south wall.", "against_wall(object=bookshelf, wall=wall_3)"},
      {"The bookshelf is against the longer eastern wall.", "against_wall(object=bookshelf, wall=wall_4)"},
      {"The bookshelf is on the 2.00 m east wall.", "against_wall(object=bookshelf, wall=wall_2)"},
      {"The bookshelf is against wall 4.", "against_wall(object=bookshelf, wall=wall_4)"},
      {"The bookshelf is against the window wall.", "against_wall(object=bookshelf, wall=wall_4)"},
      {"The bookshelf is against the wall with the window.", "against_wall(object=bookshelf, wall=wall_4)"},
      {"The bookshelf is against the wall opposite the door.", "against_wall(object=bookshelf, wall=wall_5)"},
      {"The bookshelf is against the far wall.", "against_wall(object=bookshelf, wall=wall_5)"},
      {"The bookshelf is not against the west wall.", "not_against_wall(object=bookshelf, wall=wall_6)"},
      {"The bookshelf is near the north wall.", "near_wall(object=bookshelf, wall=wall_5)"},
      {"The painting hangs on the north wall.", "against_wall(object=painting, wall=wall_5)"},
      {"The painting hangs on the north wall above the sofa.",
       "on_wall_above(object=painting, target=sofa)\nagainst_wall(object=painting, wall=wall_5)"},
      {"The bookshelf is in the north-east corner.",
       "in_corner(object=bookshelf, wall=wall_5)\nin_corner(object=bookshelf, wall=wall_2|wall_4)"},
      {"The bookshelf is against a wall.", "against_wall(object=bookshelf)"}};
  for (const auto& [text, calls] : cases) {
    const v1::LayoutGraph graph = Translated(text);
    std::vector<std::string> made;
    for (const v1::ConstraintEdge& edge : graph.edges()) made.push_back(ToText(edge));
    EXPECT_EQ(absl::StrJoin(made, "\n"), calls) << text << graph.DebugString();
    EXPECT_TRUE(graph.diagnostics().empty()) << text << graph.DebugString();
  }
}

TEST(WallNames, OfNoWallAreRefused) {
  for (const char* text : {"The bookshelf is against the north-east wall.", "The bookshelf is on the 2.5 m south wall.",
                           "The painting hangs on the 7 m wall above the sofa."}) {
    const v1::LayoutGraph graph = Translated(text);
    ASSERT_FALSE(graph.diagnostics().empty()) << text << graph.DebugString();
    EXPECT_THAT(graph.diagnostics(0).message(), HasSubstr("the room has no such wall"));
    for (const v1::ConstraintEdge& edge : graph.edges()) EXPECT_NE(edge.type(), "against_wall") << text;
  }
}

// Nothing of "60 cm west of the sofa" but the distance could be kept.
TEST(WallNames, DirectionsBetweenPiecesAreRefused) {
  for (const char* text : {"The bookshelf is 60 cm west of the sofa.", "The bookshelf is to the north of the sofa.",
                           "The bookshelf stands just east of the sofa, 0.5 m away."}) {
    const v1::LayoutGraph graph = Translated(text);
    EXPECT_EQ(graph.edges_size(), 0) << text << graph.DebugString();
    ASSERT_FALSE(graph.diagnostics().empty()) << text;
    EXPECT_THAT(graph.diagnostics(0).message(), HasSubstr("north, south, east or west")) << text;
  }
}

}  // namespace
}  // namespace flair::translator
