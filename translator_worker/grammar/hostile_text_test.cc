// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes end in calls or in a diagnostic, and long texts take time in proportion to their length.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

const LabelledRoom& Room() {
  static const LabelledRoom* const room = [] {
    const std::string folder = std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/";
    auto* first = new LabelledRoom(ReadLabelledRooms(folder + "labelled_rooms.jsonl").front());
    *first->request.mutable_catalog() = ReadCatalog(folder + "catalog.textproto");
    return first;
  }();
  return *room;
}

v1::LayoutGraph TranslateText(const std::string& text) {
  v1::TranslateRequest request = Room().request;
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_weight(1);
  sentence.set_text(text);
  return Translate(request);
}

std::string Repeat(const std::string& text, size_t bytes) {
  std::string result;
  while (result.size() < bytes) result += text;
  return result;
}

uint64_t Next(uint64_t& state) {
  state += 0x9E3779B97F4A7C15u;
  uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

// Five times what the service lets through (room/validation/room_checks.cc).
constexpr size_t kLongText = 20000;

TEST(HostileText, AlwaysEndsInACallOrADiagnostic) {
  const std::vector<std::string> texts = {"",
                                          " ",
                                          ".",
                                          "''''\"\"\"((((",
                                          std::string(1000, '\0'),
                                          "\xF0\x9F\x9B\x8F the \xF0\x9F\x9B\x8F",
                                          "\xFF\xFE\xC3",
                                          "\x01\x02\x1B[31mred\x07",
                                          Repeat("(\"'[{", kLongText),
                                          Repeat("bed ", kLongText),
                                          Repeat("bed, ", kLongText) + "and desk",
                                          Repeat("and ", kLongText),
                                          Repeat("the bed's ", kLongText),
                                          Repeat("1 m x ", kLongText),
                                          Repeat("at least ", kLongText),
                                          Repeat("minimum distance ", kLongText),
                                          Repeat("side of the ", kLongText),
                                          Repeat("9", kLongText),
                                          Repeat("between 1 and ", kLongText),
                                          Repeat("The bed is against a wall. ", kLongText),
                                          Repeat("x", kLongText),
                                          Repeat("not ", kLongText),
                                          Repeat("of ", kLongText),
                                          Repeat("(0.5m minimum) ", kLongText),
                                          Repeat("the things such as the bed and ", kLongText),
                                          Repeat("near or behind the bed ", kLongText),
                                          Repeat("to be near the bed ", kLongText),
                                          Repeat("one accessible long ", kLongText),
                                          Repeat("one of the 2m sides ", kLongText),
                                          Repeat("label: ", kLongText),
                                          Repeat("not block view window ", kLongText),
                                          Repeat("near but not next to the bed ", kLongText),
                                          Repeat("space on one accessible side ", kLongText),
                                          Repeat("one side (typically ", kLongText),
                                          Repeat("bed 1 ", kLongText),
                                          Repeat("neither near nor near ", kLongText),
                                          Repeat("wall, from it ", kLongText),
                                          Repeat(", i.e. the back, ", kLongText),
                                          Repeat("people at the bed see ", kLongText),
                                          "bed 99999999999999999999 near desk 0",
                                          "The bed is 1e999 m from the desk",
                                          "The bed is -5 m from the desk",
                                          "The bed is against the bed."};
  for (const std::string& text : texts) {
    const v1::LayoutGraph graph = TranslateText(text);
    EXPECT_GT(graph.edges_size() + graph.diagnostics_size(), 0) << text.substr(0, 60);
    for (const v1::Diagnostic& diagnostic : graph.diagnostics()) EXPECT_LT(diagnostic.message().size(), 2000u);
  }
}

TEST(HostileText, OfShuffledWordsAndBytesNeverCrashes) {
  std::vector<std::string> words = {"\xF0\x9F\x98\x80", "(", ")", "'s", "0.5m", "2", "-", ",", ".", "\"", "%s", "{}"};
  for (const LabelledSentence& labelled : Room().sentences) {
    std::string word;
    for (const char c : labelled.sentence.text() + " ") {
      if (c == ' ')
        words.push_back(std::exchange(word, ""));
      else
        word.push_back(c);
    }
  }
  const char* forced = std::getenv("FLAIR_TEST_SEED");
  uint64_t seed = forced == nullptr ? 7 : std::strtoull(forced, nullptr, 10);
  std::cout << "seed " << seed << "\n";
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    const uint64_t count = Next(seed) % 25;
    for (uint64_t i = 0; i < count; ++i) text += words[Next(seed) % words.size()] + (Next(seed) % 8 == 0 ? "" : " ");
    if (!text.empty() && round % 3 == 0) text[Next(seed) % text.size()] = static_cast<char>(Next(seed) % 256);
    const v1::LayoutGraph graph = TranslateText(text);
    ASSERT_GT(graph.edges_size() + graph.diagnostics_size(), 0) << text;
  }
}

// Processor time, not the wall clock; the factor is far above noise and far below what a square law gives (64).
TEST(HostileText, TakesTimeInProportionToItsLength) {
  for (const char* unit :
       {"the bed, ", "at least one long side of the ", "minimum distance from ", "( \"bed\" ", "zqx ",
        "(0.5m minimum) ", "things such as the bed and ", "near or behind the bed ", "one accessible long ",
        "one of the 2m sides ", "not block view window ", "near but not next to the bed ",
        "space on one accessible side ", "one side (typically ", "1 m of floor ", "in order to ",
        "neither near nor near ", "wall, from it ", "from one bed to the next "}) {
    const auto seconds = [&](size_t bytes) {
      const std::string text = Repeat(unit, bytes);
      const std::clock_t begin = std::clock();
      for (int i = 0; i < 2; ++i) TranslateText(text);
      return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    seconds(1000);
    const double small = seconds(kLongText / 8) + 1e-3;
    EXPECT_LT(seconds(kLongText) / small, 30) << unit;
  }
}

}  // namespace
}  // namespace flair::translator
