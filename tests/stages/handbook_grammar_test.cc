// SPDX-License-Identifier: GPL-3.0-or-later
// Whole rooms of the handbook before the grammar. translator_worker/grammar/handbook_test.cc has each sentence by
// itself; here are the names and numbers that only a whole list of objects gives them ("the second nightstand").
#include <fmt/format.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/handbook/testing/test_handbook.h"
#include "translator_worker/grammar/translate.h"

namespace flair {
namespace {

v1::ConstraintCatalog ReadCatalog() {
  std::ifstream file(FLAIR_SOURCE_DIR "/translator_worker/grammar/testdata/catalog.textproto");
  std::stringstream text;
  text << file.rdbuf();
  v1::ConstraintCatalog catalog;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text.str(), &catalog));
  return catalog;
}

// What the translator is asked after the handbook has answered the brief.
v1::TranslateRequest Describe(const std::string& text) {
  v1::Brief brief;
  brief.set_text(text);
  v1::TranslateRequest request;
  *request.mutable_room() = *language::DescribeRoom(brief, language::TheHandbook());
  *request.mutable_zone_plan() = *language::PlanZones(brief, request.room(), language::TheHandbook());
  *request.mutable_object_list() =
      *language::ListObjects(brief, request.room(), request.zone_plan(), language::TheHandbook());
  *request.mutable_style_sheet() =
      *language::ChooseStyle(brief, request.room(), request.object_list(), language::TheHandbook());
  *request.mutable_constraint_list() = language::CleanConstraints(*language::ListConstraints(
      brief, request.room(), request.zone_plan(), request.object_list(), language::TheHandbook()));
  static const v1::ConstraintCatalog catalog = ReadCatalog();
  *request.mutable_catalog() = catalog;
  return request;
}

// Every sentence becomes a constraint, without a remark: a remark says that a part was not understood, or that what it
// names is not there.
void ExpectUnderstood(const std::string& text) {
  SCOPED_TRACE(text);
  const v1::TranslateRequest request = Describe(text);
  const v1::LayoutGraph graph = translator::Translate(request);
  EXPECT_GT(graph.edges_size(), 0);
  for (const v1::Diagnostic& remark : graph.diagnostics()) ADD_FAILURE() << remark.code() << ": " << remark.message();
  std::set<std::string> understood;
  for (const v1::ConstraintEdge& edge : graph.edges()) understood.insert(edge.sentence_id());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    EXPECT_TRUE(understood.contains(sentence.id())) << sentence.text();
  }
}

TEST(HandbookBeforeTheGrammar, TheUsualRoomOfEveryKindIsUnderstood) {
  for (const auto& archetype : language::TheHandbook().contents().archetypes()) {
    ExpectUnderstood(fmt::format("A {}.", archetype.name()));
  }
}

// Where many pieces share a name.
TEST(HandbookBeforeTheGrammar, LargeRoomsOfEveryKindAreUnderstood) {
  for (const auto& archetype : language::TheHandbook().contents().archetypes()) {
    ExpectUnderstood(fmt::format("A {} of 9 m x 8 m.", archetype.name()));
  }
}

// What the tests above look for is there when it should be.
TEST(HandbookBeforeTheGrammar, APieceThatIsMissingIsRemarked) {
  v1::TranslateRequest request = Describe("A bedroom.");
  auto& objects = *request.mutable_object_list()->mutable_objects();
  const auto second = std::find_if(objects.begin(), objects.end(),
                                   [](const v1::Object& object) { return object.id() == "nightstand_2"; });
  ASSERT_NE(second, objects.end());
  objects.erase(second);
  const v1::LayoutGraph graph = translator::Translate(request);
  ASSERT_GT(graph.diagnostics_size(), 0);
  EXPECT_NE(graph.diagnostics(0).message().find("there is no 2."), std::string::npos) << graph.diagnostics(0).message();
}

}  // namespace
}  // namespace flair
