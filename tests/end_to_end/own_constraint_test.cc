// SPDX-License-Identifier: GPL-3.0-or-later
// docs/add-a-constraint.md as a stranger follows it: what it shows is in the example's files, and its commands work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "cli/explain/layout_note.h"
#include "nlohmann/json.hpp"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/text_format/scene_text.h"
#include "tests/fixtures/programs.h"
#include "tests/fixtures/scripted_model.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr char kListen[] = "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n";

fs::path Source(const std::string& path) { return fs::path(FLAIR_SOURCE_DIR) / path; }

struct Block {
  std::string language;
  std::string text;
};

// What stands between ```LANGUAGE and ```.
std::vector<Block> BlocksOf(const fs::path& page) {
  std::vector<Block> blocks;
  bool is_open = false;
  std::istringstream lines(ReadAll(page));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("```")) {
      if (is_open) blocks.back().text += line + "\n";
      continue;
    }
    is_open = !is_open;
    if (is_open) blocks.push_back({line.substr(3), ""});
  }
  return blocks;
}

TEST(AddAConstraint, EveryBlockOfThePageIsInAFileOfTheExample) {
  std::string example;
  for (const auto& file : fs::directory_iterator(Source("examples/own_constraint"))) {
    if (file.is_regular_file()) example += ReadAll(file.path());
  }
  std::set<std::string> languages;
  for (const Block& block : BlocksOf(Source("docs/add-a-constraint.md"))) {
    EXPECT_THAT(example, HasSubstr(block.text)) << "the page shows what no file has:\n" << block.text;
    languages.insert(block.language);
  }
  EXPECT_THAT(languages, ::testing::IsSupersetOf({"cpp", "cmake", "json", "sh", "textproto"}));
}

// This test has the example's library.
TEST(AddAConstraint, ItIsToldByItsPhraseAndByHowMuchItIsMissed) {
  const absl::StatusOr<SceneText> text = ParseScene("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,1.2,0");
  ASSERT_TRUE(text.ok()) << text.status();
  const v1::ConstraintEdge edge = optimizer::EdgeFromText("daylight_from_side", "object=desk");
  EXPECT_EQ(cli::CallWords(optimizer::MakeCatalog(), text->scene).Asked(edge), "has daylight from its left or right");
  const auto shortfall = optimizer::Explain(edge, {text->scene, text->layout, text->zone_centers});
  ASSERT_TRUE(shortfall.has_value());
  EXPECT_EQ(shortfall->sentence, "what is asked of the desk is missed by 0.87 m");
}

class OwnConstraint : public ::testing::Test {
 protected:
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  json Read(const std::string& layout) const {
    const Finished run = Flair({"inspect", folder_ / layout, "--format", "json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(run.out, nullptr, false);
  }
  // The outcome of the one edge of the type; null when there is none.
  static json OutcomeOf(const json& artifact, const std::string& type) {
    const json& layout = artifact["solved_layout"];
    for (const json& edge : layout["graph"]["edges"]) {
      if (edge["type"] != type) continue;
      for (const json& outcome : layout["edge_outcomes"]) {
        if (outcome["edge_id"] == edge["id"]) return outcome;
      }
    }
    return {};
  }

  TestFolder folder_;
  ServerProgram optimizer_{"flair-optimizer-example", kListen, folder_.path()};
};

TEST_F(OwnConstraint, TheCommandsOfThePageEndInAPlanThatShowsIt) {
  const std::string path = ProgramPath("flair").parent_path().string() + ":" + std::getenv("PATH");
  Process process("/usr/bin/env",
                  {"-C", folder_.path(), "bash", Source("examples/own_constraint/try"), optimizer_.address()},
                  {{"PATH", path}, {"FLAIR_HOME", folder_ / "home"}});
  const Finished run = process.Wait();
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/office/daylight.png"));
  const json layout = Read("out/office/daylight.pb");
  EXPECT_EQ(OutcomeOf(layout, "daylight_from_side")["status"], "OUTCOME_STATUS_SATISFIED");
  EXPECT_EQ(layout["producer"]["program"], "flair-optimizer-example");
  // Without being asked for, it does not hold.
  const Finished asked_later = Flair({"resolve", folder_ / "out/office/layout.pb", "--edit",
                                      "edge daylight_from_side object=desk max_distance_m=1.5", "--optimizer",
                                      optimizer_.address(), "--out", folder_ / "asked_later.pb"});
  ASSERT_EQ(asked_later.exit_code, 0) << asked_later.err;
  // A type that the catalogue does not have is known by its name alone.
  const std::vector<std::string> explain = {"explain", folder_ / "asked_later.pb"};
  EXPECT_THAT(Flair(explain).out, HasSubstr("meets daylight_from_side"));
  std::vector<std::string> explain_by_its_words = explain;
  explain_by_its_words.insert(explain_by_its_words.end(), {"--optimizer", optimizer_.address()});
  EXPECT_THAT(Flair(explain_by_its_words).out, HasSubstr("has daylight from its left or right"));
  EXPECT_EQ(OutcomeOf(Read("asked_later.pb"), "daylight_from_side")["status"], "OUTCOME_STATUS_VIOLATED");
  // The optimizer that knows nothing of it leaves it out and says so.
  const Finished ours = Flair({"solve", folder_ / "out/office/asked.json", "--out", folder_ / "ours.pb"});
  EXPECT_EQ(ours.exit_code, 0) << ours.err;
  EXPECT_THAT(ours.err, HasSubstr("dropped    light: there is no constraint type \"daylight_from_side\""));
}

// The catalogue that the model is asked with is that of the optimizer in use.
TEST_F(OwnConstraint, AModelLearnsItFromTheCatalogueAndCallsIt) {
  Script script = DesignScript();
  json& answer = ExchangeOf("translation.intra", script).answer["text"];
  std::string text = answer;
  const std::string usual = "close_to_feature(desk, window)";
  ASSERT_NE(text.find(usual), std::string::npos);
  answer = text.replace(text.find(usual), usual.size(), "daylight_from_side(desk)");
  ScriptedServer model(script);
  WriteAll(folder_ / "llm.textproto", LlmConfigText(model));
  const Finished design = Flair({"design", kModelBrief, "--llm", folder_ / "llm.textproto", "--optimizer",
                                 optimizer_.address(), "--out", folder_ / "bedroom", "--quiet"});
  ASSERT_EQ(design.exit_code, 0) << design.err;
  const std::vector<RecordedRequest> asked = RequestsOf("translation.intra", model);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_THAT(asked[0].body, HasSubstr("daylight_from_side"));
  EXPECT_THAT(asked[0].body, HasSubstr("Daylight falls on"));
  EXPECT_EQ(OutcomeOf(Read("bedroom/layout.pb"), "daylight_from_side")["status"], "OUTCOME_STATUS_SATISFIED");
}

TEST_F(OwnConstraint, AnOptimizerWithoutItTakesNoHelpFromOneThatHasIt) {
  ServerProgram driver("flair-optimizer",
                       "runtime { listen_address: \"127.0.0.1:0\" log_level: \"warning\" }\npeer_addresses: \"" +
                           optimizer_.address() + "\"\n",
                       folder_.path());
  const Finished design = Flair({"design", "A bedroom that is 3m x 4m.", "--restarts", "96", "--optimizer",
                                 driver.address(), "--out", folder_ / "bedroom", "--quiet"});
  EXPECT_EQ(design.exit_code, 0) << design.err;
  driver.process().Signal(SIGTERM);
  EXPECT_THAT(driver.process().Wait().err, HasSubstr("it is flair-optimizer-example slsqp 1, build "));
}

}  // namespace
}  // namespace flair::testing
