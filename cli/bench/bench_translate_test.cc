// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/bench/translate_bench.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"
#include "translator_worker/grammar/translate.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const fs::path kCabin = FLAIR_SOURCE_DIR "/cli/bench/testdata/translate";

class BenchTranslateTest : public testing::Test {
 protected:
  BenchTranslateTest() : folder_(fs::path(testing::TempDir()) / fmt::format("flair_labels_{}", getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~BenchTranslateTest() override { fs::remove_all(folder_); }

  // One line of labels about the cabin, read with its room.
  absl::StatusOr<TranslateLabels> Read(const std::string& text) const {
    std::ofstream(folder_ / "labels.jsonl", std::ios::binary) << text << "\n";
    return ReadTranslateLabels(folder_, kCabin / "rooms");
  }
  std::string WhyNot(const std::string& text) const { return std::string(Read(text).status().message()); }

  const fs::path folder_;
};

std::string Line(const std::string& gold, const std::string& more = "") {
  return fmt::format(
      R"({{"room": "cabin", "list": "primary_intra", "subject_index": [0], "sentence": "s", "gold": {}{}}})", gold,
      more);
}

v1::ConstraintEdge Edge(const std::string& type, const std::vector<std::pair<std::string, std::string>>& arguments) {
  v1::ConstraintEdge edge;
  edge.set_type(type);
  for (const auto& [name, value] : arguments) {
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name(name);
    if (name == "sides") {
      argument.mutable_value()->mutable_texts()->add_items(value);
    } else {
      argument.mutable_value()->set_text(value);
    }
  }
  return edge;
}

TranslateScore Measure() {
  const absl::StatusOr<TranslateLabels> labels = ReadTranslateLabels(kCabin, "");
  EXPECT_TRUE(labels.ok()) << labels.status();
  EXPECT_THAT(labels->failures, IsEmpty());
  return MeasureTranslation(labels->rooms, TypesOfTheReference(optimizer::MakeCatalog()),
                            [](const v1::TranslateRequest& request) -> absl::StatusOr<v1::TranslateResponse> {
                              v1::TranslateResponse response;
                              *response.mutable_layout_graph() = translator::Translate(request);
                              return response;
                            })
      .value();
}

std::string Counts(const TranslateTally& tally) { return fmt::format("{}", fmt::join(tally.counts, " ")); }

TEST_F(BenchTranslateTest, LinesOfOneBulletAreFactsOfOneSentence) {
  const TranslateLabels labels = ReadTranslateLabels(kCabin, "").value();
  ASSERT_THAT(labels.rooms, SizeIs(1));
  const LabelledRoom& room = labels.rooms[0];
  EXPECT_EQ(room.name, "cabin");
  ASSERT_THAT(room.bullets, SizeIs(9));
  EXPECT_EQ(room.request.constraint_list().sentences_size(), 9);
  EXPECT_EQ(room.bullets[4].sentence.text(), "The stool stands in front of the desk, at least 1m from the bunk.");
  EXPECT_THAT(room.bullets[4].labels, SizeIs(2));
  EXPECT_EQ(room.bullets[4].sentence.scope(), v1::SENTENCE_SCOPE_INTER);
  EXPECT_THAT(room.bullets[7].sentence.subject_ids(), ElementsAre("item_0"));
}

TEST_F(BenchTranslateTest, CountsCorrectWrongMissedAndWronglyRefusedByFunctionListAndRoom) {
  const TranslateScore score = Measure();
  EXPECT_EQ(Counts(score.all), "7 1 1 1") << score.misses;
  EXPECT_EQ(score.silent, 0);
  EXPECT_EQ(Counts(score.by_function.at("ind_accessible")), "1 0 0 0");
  EXPECT_EQ(Counts(score.by_function.at("io_near")), "0 0 0 1");
  EXPECT_EQ(Counts(score.by_function.at("on_wall_above")), "0 0 1 0");
  EXPECT_EQ(Counts(score.by_function.at("refuse")), "1 1 0 0");
  EXPECT_EQ(Counts(score.by_list.at("secondary_inter")), "2 1 0 1");
  EXPECT_EQ(Counts(score.by_list.at("tertiary")), "1 0 1 0");
  EXPECT_EQ(Counts(score.by_room.at("cabin")), Counts(score.all));
}

TEST_F(BenchTranslateTest, MissesNameWhatWasWantedMadeAndRemarked) {
  const TranslateScore score = Measure();
  EXPECT_THAT(score.misses, HasSubstr("  wanted   near(object=floor_3, target=floor_0)\n  remarked "));
  EXPECT_THAT(score.misses, HasSubstr("  wanted   nothing\n  made     next_to(object=floor_3, target=floor_0)\n"));
  EXPECT_THAT(score.misses, HasSubstr("cabin secondary_inter: The log basket sings to the bunk.\n"));
}

TEST_F(BenchTranslateTest, TheTextEndsInTheShareOfCorrectLabels) {
  EXPECT_THAT(TranslateScoreText(Measure(), 10), HasSubstr("70.0 % of 10 labels correct, 1.000 ms of CPU a label"));
}

TEST_F(BenchTranslateTest, ACallMeetsALabelThatStatesLess) {
  const auto against = [](const std::string& side) {
    return side.empty() ? Edge("against_wall", {{"object", "a"}})
                        : Edge("against_wall", {{"object", "a"}, {"side", side}});
  };
  EXPECT_TRUE(MeetsGold(against(""), against("")));
  EXPECT_TRUE(MeetsGold(against("back"), against("")));
  EXPECT_FALSE(MeetsGold(against("left"), against("")));
  EXPECT_FALSE(MeetsGold(against(""), against("back")));
  EXPECT_TRUE(
      MeetsGold(Edge("near", {{"object", "b"}, {"target", "a"}}), Edge("near", {{"object", "a"}, {"target", "b"}})));
  EXPECT_FALSE(MeetsGold(Edge("in_front_of", {{"object", "b"}, {"target", "a"}}),
                         Edge("in_front_of", {{"object", "a"}, {"target", "b"}})));
  const v1::ConstraintEdge beside =
      Edge("next_to", {{"object", "a"}, {"target", "b"}, {"object_side", "left"}, {"target_side", "right"}});
  EXPECT_TRUE(MeetsGold(
      Edge("next_to", {{"object", "b"}, {"target", "a"}, {"object_side", "right"}, {"target_side", "left"}}), beside));
  EXPECT_FALSE(MeetsGold(
      Edge("next_to", {{"object", "b"}, {"target", "a"}, {"object_side", "left"}, {"target_side", "right"}}), beside));
  EXPECT_TRUE(
      MeetsGold(Edge("accessible", {{"object", "a"}}), Edge("accessible", {{"object", "a"}, {"sides", "front"}})));
  EXPECT_FALSE(
      MeetsGold(Edge("accessible", {{"object", "a"}}), Edge("accessible", {{"object", "a"}, {"sides", "back"}})));
}

TEST_F(BenchTranslateTest, OnlyTypesThatLabelsCanNameAreOffered) {
  const v1::ConstraintCatalog known = TypesOfTheReference(optimizer::MakeCatalog());
  const auto has = [&](const std::string& name) {
    return std::any_of(known.types().begin(), known.types().end(),
                       [&](const auto& type) { return type.name() == name; });
  };
  EXPECT_TRUE(has("against_wall") && has("near") && has("on_wall_near") && has("surround"));
  EXPECT_FALSE(has("centered_on_wall") || has("row"));
  EXPECT_LT(known.types_size(), optimizer::MakeCatalog().types_size());
}

TEST_F(BenchTranslateTest, BadLinesAreNamedAndTheRestIsMeasured) {
  const absl::StatusOr<TranslateLabels> labels = Read("{\"room\": \n" + Line("[]") + "\n[1]");
  ASSERT_TRUE(labels.ok()) << labels.status();
  ASSERT_THAT(labels->rooms, SizeIs(1));
  EXPECT_THAT(labels->rooms[0].bullets, SizeIs(1));
  const std::string file = (folder_ / "labels.jsonl").string();
  EXPECT_THAT(labels->failures, ElementsAre(file + ":1: not a JSON object", file + ":3: not a JSON object"));
}

TEST_F(BenchTranslateTest, BadLabelsSayWhatIsWrong) {
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "ind_dance", "objects": [0]}]])")),
              HasSubstr("unknown function ind_dance"));
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "ind_accessible", "objects": [9]}]])")), HasSubstr("no object 9"));
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "io_near", "objects": [0]}]])")), HasSubstr("too few for near"));
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "ind_accessible", "objects": [0, 1]}]])")), HasSubstr("too many"));
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "ind_accessible", "objects": [0], "params": {"hue": 1}}]])")),
              HasSubstr("accessible has no hue"));
  EXPECT_THAT(WhyNot(Line(R"([[{"function": "ind_accessible", "objects": [0], "params": {"sides": ["up"]}}]])")),
              HasSubstr("unknown side \"up\""));
  EXPECT_THAT(WhyNot(Line("[[]]")), HasSubstr("an alternative without calls"));
  EXPECT_THAT(WhyNot(Line("[[3]]")), HasSubstr("3 is not a call"));
  EXPECT_THAT(WhyNot(Line("7")), HasSubstr("gold: missing"));
  EXPECT_THAT(WhyNot(R"({"room": "cabin", "list": "gossip", "sentence": "s", "gold": []})"),
              HasSubstr("unknown list gossip"));
  EXPECT_THAT(WhyNot(R"({"room": "palace", "list": "tertiary", "sentence": "s", "gold": []})"),
              HasSubstr("no palace.json"));
  EXPECT_THAT(WhyNot(R"({"room": "../cabin", "list": "tertiary", "sentence": "s", "gold": []})"),
              HasSubstr("not a file name"));
}

TEST_F(BenchTranslateTest, FoldersWithoutLabelsAreRefused) {
  EXPECT_EQ(ReadTranslateLabels(folder_, "").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ReadTranslateLabels(folder_ / "none", "").status().code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(WhyNot(""), HasSubstr("no labels in it"));
}

TEST_F(BenchTranslateTest, AFailingTranslatorIsNamedWithTheRoom) {
  const TranslateLabels labels = ReadTranslateLabels(kCabin, "").value();
  const absl::StatusOr<TranslateScore> score =
      MeasureTranslation(labels.rooms, {}, [](const v1::TranslateRequest&) { return absl::UnavailableError("gone"); });
  EXPECT_EQ(score.status(), absl::UnavailableError("cabin: gone"));
}

}  // namespace
}  // namespace flair::cli
