// SPDX-License-Identifier: GPL-3.0-or-later
// Whole rooms of the handbook before the grammar. translator_worker/grammar/handbook_test.cc has each sentence by
// itself; here are the names and numbers that only a whole list of objects gives them ("the second nightstand").
#include <fmt/format.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
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

// The calls that the sentences of a request become. A remark says that a part was not understood, or that what it names
// is not there.
std::map<std::string, std::string> CallsOf(const v1::TranslateRequest& request) {
  const v1::LayoutGraph graph = translator::Translate(request);
  for (const v1::Diagnostic& remark : graph.diagnostics()) ADD_FAILURE() << remark.code() << ": " << remark.message();
  std::map<std::string, std::string> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    std::string& call = calls[edge.sentence_id()];
    call += edge.type();
    for (const v1::Argument& argument : edge.arguments()) call += " " + argument.ShortDebugString();
  }
  return calls;
}

// Every sentence becomes constraints, without a remark: by its typed meaning, and by its text when somebody edits it.
void ExpectUnderstood(const std::string& text) {
  SCOPED_TRACE(text);
  v1::TranslateRequest request = Describe(text);
  const std::map<std::string, std::string> typed = CallsOf(request);
  for (v1::Sentence& sentence : *request.mutable_constraint_list()->mutable_sentences()) {
    EXPECT_GT(sentence.meaning().facts_size(), 0) << sentence.text();
    sentence.mutable_meaning()->set_text_digest(std::string(64, '0'));
  }
  const std::map<std::string, std::string> read = CallsOf(request);
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    ASSERT_TRUE(typed.contains(sentence.id())) << sentence.text();
    EXPECT_EQ(read.contains(sentence.id()) ? read.at(sentence.id()) : "", typed.at(sentence.id())) << sentence.text();
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
