// SPDX-License-Identifier: GPL-3.0-or-later
// What the rules of the labels say, each in many wordings: testdata/wordings.txt.
#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "fmt/format.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

const std::string kWordingData = std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/";

std::string ValueText(const v1::ArgumentValue& value) {
  if (value.has_number()) return fmt::format("{:.6g}", value.number());
  if (value.has_flag()) return value.flag() ? "both" : "one";
  return value.has_texts() ? absl::StrJoin(value.texts().items(), "+") : value.text();
}

// "near(sofa,shelf,1); facing(sofa,shelf)", sorted.
std::string CallsText(const v1::LayoutGraph& graph) {
  std::vector<std::string> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    std::vector<std::string> values;
    for (const v1::Argument& argument : edge.arguments()) values.push_back(ValueText(argument.value()));
    calls.push_back(fmt::format("{}({})", edge.type(), absl::StrJoin(values, ",")));
  }
  std::sort(calls.begin(), calls.end());
  return absl::StrJoin(calls, "; ");
}

std::map<std::string, v1::TranslateRequest> WordingRooms() {
  // The types that the labels know.
  v1::ConstraintCatalog catalog = ReadCatalog(kWordingData + "catalog.textproto");
  auto& types = *catalog.mutable_types();
  for (int i = types.size() - 1; i >= 0; --i) {
    if (types[i].family() == "further") types.DeleteSubrange(i, 1);
  }
  std::map<std::string, v1::TranslateRequest> rooms;
  for (const LabelledRoom& room : ReadLabelledRooms(kWordingData + "wordings_rooms.jsonl")) {
    rooms[room.name] = room.request;
    *rooms[room.name].mutable_catalog() = catalog;
  }
  return rooms;
}

// A line "list | subjects | sentence | calls".
void ExpectWording(v1::TranslateRequest request, const std::string& line) {
  std::vector<std::string> fields = absl::StrSplit(line, '|');
  ASSERT_EQ(fields.size(), 4u) << line;
  for (std::string& field : fields) field = std::string(absl::StripAsciiWhitespace(field));
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(fields[2]);
  sentence.set_scope(fields[0] == "t"   ? v1::SENTENCE_SCOPE_TERTIARY
                     : fields[0] == "x" ? v1::SENTENCE_SCOPE_INTER
                                        : v1::SENTENCE_SCOPE_INTRA);
  for (const auto subject : absl::StrSplit(fields[1], ' ', absl::SkipEmpty())) {
    sentence.add_subject_ids(std::string(subject));
  }
  const v1::LayoutGraph graph = Translate(request);
  EXPECT_EQ(CallsText(graph), fields[3]) << fields[2];
  if (graph.edges().empty()) EXPECT_FALSE(graph.diagnostics().empty()) << fields[2];
}

TEST(Wordings, AreReadAsTheRulesOfTheLabelsSay) {
  const std::map<std::string, v1::TranslateRequest> rooms = WordingRooms();
  std::ifstream file(kWordingData + "wordings.txt");
  std::string room;
  int read = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '@') {
      room = line.substr(1);
      ASSERT_TRUE(rooms.contains(room)) << room;
      continue;
    }
    ExpectWording(rooms.at(room), line);
    ++read;
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace flair::translator
