// SPDX-License-Identifier: GPL-3.0-or-later
// flair diff, compare and graph as a stranger with one design runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nlohmann/json.hpp"
#include "tests/fixtures/designed_bedroom.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kListen[] = "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n";

class CompareCommands : public DesignedBedroom {
 protected:
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string Layout() { return (Design() / "layout.pb").string(); }
  static std::string Graph() { return (Design() / "graph.pb").string(); }
  static std::string FirstPlaced() {
    return json::parse(ReadAll(Design() / "layout.json"))["solved_layout"]["placements"][0]["object_id"];
  }
  // The design with the first thing 0.30 m further north.
  std::string Moved() const {
    json layout = json::parse(ReadAll(Design() / "layout.json"));
    json& place = layout["solved_layout"]["placements"][0];
    place["y_m"] = place["y_m"].get<double>() + 0.3;
    WriteAll(folder_ / "moved.json", layout.dump());
    return Path("moved.json");
  }
};

TEST_F(CompareCommands, DiffOfALayoutWithItselfIsNoneAndEndsWithZero) {
  const Finished run = Flair({"diff", Layout(), Layout()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("are the same solved layout\n"));
  EXPECT_EQ(run.err, "");
}

TEST_F(CompareCommands, DiffTellsAMoveAndDrawsIt) {
  for (const char* picture : {"difference.png", "difference.svg"}) {
    const Finished run = Flair({"diff", Layout(), Moved(), "--picture", Path(picture)});
    EXPECT_EQ(run.exit_code, 7) << run.err;
    EXPECT_THAT(run.out, HasSubstr("  ~ " + FirstPlaced() + "  moved 0.30 m north\n"));
    EXPECT_GT(std::filesystem::file_size(Path(picture)), 1000u);
  }
  const json told = json::parse(Flair({"diff", Layout(), Moved(), "--format", "json"}).out);
  EXPECT_FALSE(told["content_is_same"]);
  for (const json& section : told["sections"]) {
    if (section["title"] == "made by") continue;  // by hand
    EXPECT_EQ(section["changes"].size(), section["title"] == "places" ? 1u : 0u) << section.dump(1);
  }
}

TEST_F(CompareCommands, DiffOfEveryKindOfArtifactWithItselfAndWithAnotherSeed) {
  const std::string other = Path("other");
  ASSERT_EQ(Flair({"design", "A bedroom that is 3m x 4m.", "--seed", "8", "--out", other, "--quiet"}).exit_code, 0);
  for (const char* name : {"brief", "room", "zones", "objects", "style", "constraints_raw", "constraints",
                           "constraints_completed", "graph", "layout"}) {
    const std::string own = (Design() / (std::string(name) + ".pb")).string();
    EXPECT_EQ(Flair({"diff", own, own}).exit_code, 0) << name;
    const Finished run = Flair({"diff", own, other + "/" + name + ".pb"});
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 7) << name << run.err;
    EXPECT_EQ(run.err, "") << name;
    EXPECT_THAT(run.out, StartsWith("A ")) << name;
  }
}

TEST_F(CompareCommands, DiffRefusesWhatItCannotCompareOrDraw) {
  const Finished kinds = Flair({"diff", Layout(), Graph()});
  EXPECT_EQ(kinds.exit_code, 2);
  EXPECT_THAT(kinds.err,
              HasSubstr("the first is a solved layout, the second a layout graph; give two of the same kind"));
  const Finished drawn = Flair({"diff", Graph(), Graph(), "--picture", Path("d.png")});
  EXPECT_EQ(drawn.exit_code, 2);
  EXPECT_THAT(drawn.err, HasSubstr("--picture: " + Graph() + " is not a layout"));
  const Finished ending = Flair({"diff", Layout(), Layout(), "--picture", Path("d.gif")});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("its extension chooses the format: png, jpg"));
  EXPECT_EQ(Flair({"diff", Layout(), Path("nothing.pb")}).exit_code, 2);
}

TEST_F(CompareCommands, CompareJudgesTwoOptimizersOnOneScaleAndShowsThem) {
  const ServerProgram other("../test_bin/flair_other_optimizer", kListen, folder_.path());
  const Finished run = Flair({"compare", Graph(), "--optimizer", "own", "--optimizer", other.address(), "--restarts",
                              "8", "--picture", Path("both.png")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("  A  own: flair-optimizer slsqp"), HasSubstr("  B  " + other.address() + ": "),
                             HasSubstr("constraints that hold"), HasSubstr("total cost"), HasSubstr("seconds")));
  EXPECT_GT(std::filesystem::file_size(Path("both.png")), 10000u);
  const Finished told = Flair({"compare", Graph(), "--optimizer", "own", "--optimizer", other.address(), "--restarts",
                               "8", "--format", "json"});
  const json figures = json::parse(told.out);
  ASSERT_EQ(figures["optimizers"].size(), 2u);
  // The same solver under another name: all but the time agrees.
  json a = figures["optimizers"][0], b = figures["optimizers"][1];
  for (json* one : {&a, &b}) one->erase("seconds"), one->erase("optimizer");
  EXPECT_EQ(a, b);
  EXPECT_GT(a["held_count"], 0);
  EXPECT_EQ(a["held_count"], a["claimed_count"]);
}

TEST_F(CompareCommands, CompareOfAFolderGivesALinePerDesignAndMedians) {
  const Finished run =
      Flair({"compare", Design().string(), "--optimizer", "own", "--optimizer", "embedded", "--restarts", "4"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("median of 1"), HasSubstr("B  embedded")));
}

TEST_F(CompareCommands, CompareSaysWhatIsWrong) {
  EXPECT_THAT(Flair({"compare", Graph(), "--optimizer", "own"}).err,
              HasSubstr("--optimizer: 1; give it for each of two"));
  const Finished silent =
      Flair({"compare", Graph(), "--optimizer", "own", "--optimizer", "127.0.0.1:1", "--restarts", "1"});
  EXPECT_EQ(silent.exit_code, 3);
  EXPECT_THAT(silent.err, HasSubstr("--optimizer 127.0.0.1:1: no flair.v1.OptimizerService answers there"));
  const Finished kind = Flair({"compare", Layout(), "--optimizer", "own", "--optimizer", "own"});
  EXPECT_EQ(kind.exit_code, 2);
  EXPECT_THAT(kind.err, HasSubstr("not a graph"));
}

TEST_F(CompareCommands, GraphDrawsLayoutsAndGraphsInEveryFormat) {
  for (const char* name : {"graph.svg", "graph.png", "graph.pdf", "graph.dot"}) {
    for (const std::string& from : {Layout(), Graph()}) {
      const Finished run = Flair({"graph", from, "--out", Path(name)});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      EXPECT_THAT(run.err, HasSubstr(std::string(name) + ": "));
    }
  }
  EXPECT_THAT(ReadAll(Path("graph.svg")), AllOf(HasSubstr("<svg"), HasSubstr("bed")));
  EXPECT_THAT(ReadAll(Path("graph.dot")), StartsWith("digraph layout {"));
}

TEST_F(CompareCommands, GraphWithoutGraphvizSaysWhatToInstallAndDotFilesNeedNone) {
  const Environment empty = {{"PATH", folder_ / "none"}, {"FLAIR_HOME", folder_ / "home"}};
  const Finished run = RunProgram("flair", {"graph", Layout(), "--out", Path("graph.svg")}, empty);
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, HasSubstr("apt-get install graphviz"));
  EXPECT_FALSE(std::filesystem::exists(Path("graph.svg")));
  EXPECT_EQ(RunProgram("flair", {"graph", Layout(), "--out", Path("graph.dot")}, empty).exit_code, 0);
  const Finished kind = Flair({"graph", (Design() / "room.pb").string(), "--out", Path("graph.svg")});
  EXPECT_THAT(kind.err, HasSubstr("neither a layout nor a graph"));
  EXPECT_THAT(Flair({"graph", Layout(), "--out", Path("graph.gif")}).err, HasSubstr("--out: "));
}

}  // namespace
}  // namespace flair::testing
