// SPDX-License-Identifier: GPL-3.0-or-later
// The solver's commands one after the other, as a stranger with a recorded problem runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class SolverCommands : public ::testing::Test {
 protected:
  static std::string Room(const std::string& name) {
    return fmt::format("{}/tests/end_to_end/rooms/{}.json", FLAIR_SOURCE_DIR, name);
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram(ProgramWith(arguments), arguments, {{"FLAIR_HOME", Path("home")}});
  }
  // Runs what must succeed.
  Finished Good(const std::vector<std::string>& arguments) const {
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments[0] << ": " << run.err;
    return run;
  }
  void Import(const std::string& room, const std::string& out) const {
    Good({"import", "flairgpt", Room(room), "--out", Path(out)});
  }
  // The folder with both rooms, imported.
  std::string Problems() const {
    Good({"import", "flairgpt", FLAIR_SOURCE_DIR "/tests/end_to_end/rooms", "--out", Path("problems")});
    return Path("problems");
  }
  // The poses of a layout file by role and index.
  std::map<std::string, json> Poses(const std::string& layout) const {
    Good({"export", "flairgpt", Path(layout), "--out", Path("poses.json")});
    std::map<std::string, json> poses;
    const json written = json::parse(ReadAll(Path("poses.json")));
    for (const json& object : written["objects"]) {
      poses[fmt::format("{}_{}", object["role"] == "tertiary" ? "item" : "floor", object["index"].get<int>())] = object;
    }
    return poses;
  }

  TestFolder folder_;
};

TEST_F(SolverCommands, ImportSaysWhatItReadWhatItLeftOutAndWhatToDoNext) {
  const Finished run = Good({"import", "flairgpt", Room("tea_room"), "--out", Path("graph.pb")});
  EXPECT_THAT(run.err, HasSubstr("left out: ind_levitate(0): unknown function ind_levitate\n"));
  EXPECT_THAT(run.err, HasSubstr("graph.pb: 9 objects, 12 constraints, 1 call left out\n"));
  EXPECT_THAT(run.err, HasSubstr("next       flair solve " + Path("graph.pb")));
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(Good({"inspect", Path("graph.pb")}).out, HasSubstr("matches its bytes"));
}

TEST_F(SolverCommands, SolveWritesTheLayoutsItLists) {
  Import("tea_room", "graph.pb");
  const Finished run =
      Good({"solve", Path("graph.pb"), "--out", Path("layout.pb"), "--stats", "--variants", "3", "--seed", "1"});
  EXPECT_THAT(run.err, StartsWith(Path("layout.pb") + ": 9 objects placed; "));
  EXPECT_THAT(run.err, HasSubstr("next       flair render " + Path("layout.pb")));
  for (const char* title : {"stage ", "TERMS OF THE WHOLE ROOM", "measures   OOB ", "pathway cost", "layout "}) {
    EXPECT_THAT(run.out, HasSubstr(title));
  }
  std::set<std::string> different;
  for (const char* name : {"layout.pb", "layout-2.pb", "layout-3.pb"}) {
    ASSERT_TRUE(std::filesystem::exists(Path(name))) << run.err << run.out;
    EXPECT_THAT(run.out, HasSubstr(std::string(name) + "\n"));
    EXPECT_THAT(Good({"inspect", Path(name)}).out, HasSubstr("matches its bytes"));
    different.insert(json(Poses(name)).dump());
  }
  EXPECT_EQ(different.size(), 3u);
}

TEST_F(SolverCommands, TheSameSeedGivesTheSameFileAndAnotherSeedAnother) {
  Import("tea_room", "graph.pb");
  for (const auto& [name, seed] : {std::pair{"a.pb", "4"}, {"b.pb", "4"}, {"c.pb", "5"}}) {
    Good({"solve", Path("graph.pb"), "--out", Path(name), "--seed", seed, "--threads", name[0] == 'a' ? "1" : "3"});
  }
  EXPECT_TRUE(ReadAll(Path("a.pb")) == ReadAll(Path("b.pb")));
  EXPECT_FALSE(ReadAll(Path("a.pb")) == ReadAll(Path("c.pb")));
}

TEST_F(SolverCommands, ResolveMovesWhatItSaysAndNothingElse) {
  Import("tea_room", "graph.pb");
  Good({"solve", Path("graph.pb"), "--out", Path("before.pb")});
  const Finished run = Good(
      {"resolve", Path("before.pb"), "--edit", "move floor_4 0.4 1.6 90", "--out", Path("after.pb"), "--seed", "1"});
  EXPECT_THAT(run.err, HasSubstr("after.pb: 9 objects placed; "));
  EXPECT_THAT(run.err, HasSubstr("floor_4 (fern)"));
  const std::string moved = run.err.substr(run.err.find("moved "));
  const std::string line = moved.substr(0, moved.find('\n'));
  const std::map<std::string, json> before = Poses("before.pb"), after = Poses("after.pb");
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [id, object] : after) {
    const bool is_same = object == before.at(id);
    EXPECT_EQ(is_same, line.find(id + " (") == std::string::npos) << id << ": " << line;
  }
  EXPECT_NEAR(after.at("floor_4")["x"], 0.4, 1e-9);
  EXPECT_NEAR(after.at("floor_4")["y"], 1.6, 1e-9);
  EXPECT_NEAR(after.at("floor_4")["theta"], std::acos(-1.0) / 2, 1e-9);
}

TEST_F(SolverCommands, ExportKeepsRolesIndicesNamesAndSizes) {
  Import("hall", "graph.pb");
  Good({"solve", Path("graph.pb"), "--out", Path("layout.pb")});
  const Finished run = Good({"export", "flairgpt", Path("layout.pb"), "--out", Path("hall.json")});
  EXPECT_THAT(run.err, HasSubstr("hall.json: poses of 3 objects, named \"hall\"\n"));
  const json written = json::parse(ReadAll(Path("hall.json"))), room = json::parse(ReadAll(Room("hall")));
  EXPECT_EQ(written["name"], "hall");
  size_t count = 0;
  for (const char* role : {"primary", "secondary", "tertiary"}) {
    for (const json& object : room[role]) {
      const json& pose = written["objects"][count++];
      EXPECT_EQ(pose["role"], role);
      for (const char* field : {"index", "name", "width", "length"}) EXPECT_EQ(pose[field], object[field]) << field;
      EXPECT_GE(pose["x"], 0);
      EXPECT_LE(pose["x"], room["room"]["width"]);
      EXPECT_GE(pose["y"], 0);
      EXPECT_LE(pose["y"], room["room"]["length"]);
    }
  }
  EXPECT_EQ(written["objects"].size(), count);
}

TEST_F(SolverCommands, BenchSolveGivesTheLayoutsThatSolveGives) {
  const Finished run =
      Good({"bench", "solve", Problems(), "--out", Path("layouts"), "--json", Path("bench.json"), "--seed", "2"});
  const json figures = json::parse(ReadAll(Path("bench.json")));
  ASSERT_EQ(figures["rooms"].size(), 2u);
  EXPECT_TRUE(figures["failures"].empty());
  for (const char* room : {"hall", "tea_room"}) {
    EXPECT_THAT(run.out, HasSubstr(std::string("\n") + room + " "));
    Import(room, "graph.pb");
    Good({"solve", Path("graph.pb"), "--out", Path("solved.pb"), "--seed", "2"});
    const std::map<std::string, json> solved = Poses("solved.pb");
    Good({"export", "flairgpt", (folder_ / "layouts").string() + "/" + room + ".pb", "--out", Path("benched.json")});
    const json benched = json::parse(ReadAll(Path("layouts/" + std::string(room) + ".json")));
    EXPECT_EQ(benched["objects"], json::parse(ReadAll(Path("benched.json")))["objects"]);
    EXPECT_EQ(benched["objects"].size(), solved.size());
    for (const json& object : benched["objects"]) {
      EXPECT_EQ(object, solved.at(fmt::format("{}_{}", object["role"] == "tertiary" ? "item" : "floor",
                                              object["index"].get<int>())));
    }
  }
  EXPECT_THAT(run.out, HasSubstr("2 rooms: CPU median"));
  EXPECT_THAT(run.err, HasSubstr("layouts are in " + Path("layouts")));
}

// Every line of a table between its rule and the next empty line is as long as its titles.
void ExpectAligned(const std::string& text) {
  std::istringstream lines(text);
  std::string before, line;
  size_t width = 0, rows = 0;
  while (std::getline(lines, line)) {
    if (!line.empty() && line.find_first_not_of('-') == std::string::npos) {
      width = line.size();
      EXPECT_EQ(before.size(), width) << before;
    } else if (line.empty()) {
      width = 0;
    } else if (width > 0) {
      EXPECT_EQ(line.size(), width) << line;
      ++rows;
    }
    before = line;
  }
  EXPECT_GT(rows, 0u) << text;
}

TEST_F(SolverCommands, BenchTablesAreAlignedAndHoldEveryRoom) {
  const std::string problems = Problems();
  const Finished resolve = Good({"bench", "resolve", problems, "--per-kind", "1"});
  const Finished restarts = Good({"bench", "restarts", problems, "--restarts", "8"});
  const Finished solve = Good({"bench", "solve", problems});
  for (const Finished* run : {&resolve, &restarts, &solve}) {
    EXPECT_THAT(run->out, AllOf(HasSubstr("\nhall "), HasSubstr("\ntea_room ")));
    ExpectAligned(run->out);
  }
  EXPECT_THAT(resolve.out, HasSubstr("\nall: move "));
  EXPECT_THAT(restarts.out, HasSubstr("\n8 "));
}

TEST_F(SolverCommands, AFolderIsImportedAndMeasuredWithoutWhatCannotBeRead) {
  std::filesystem::create_directory(folder_ / "mixed");
  std::filesystem::copy(Room("hall"), folder_ / "mixed" / "hall.json");
  json broken = json::parse(ReadAll(Room("hall")));
  broken["primary"][0]["width"] = "wide";
  WriteAll(folder_ / "mixed" / "broken.json", broken.dump());
  const Finished import = Flair({"import", "flairgpt", Path("mixed"), "--out", Path("imported")});
  EXPECT_EQ(import.exit_code, 2);
  EXPECT_THAT(import.err, HasSubstr(Path("mixed/broken.json") + ": not a recorded FlairGPT problem: "));
  EXPECT_THAT(import.err, HasSubstr("primary[0].width: \"wide\" should be a number in [0, 20], metres"));
  EXPECT_THAT(import.err, HasSubstr("1 of 2 problems could not be imported"));
  WriteAll(folder_ / "imported" / "broken.pb", "not an artifact");
  for (const char* kind : {"solve", "resolve", "restarts"}) {
    const Finished run = Flair({"bench", kind, Path("imported")});
    EXPECT_EQ(run.exit_code, 1) << kind;
    EXPECT_THAT(run.err, HasSubstr(Path("imported/broken.pb") + ": ")) << kind;
    EXPECT_THAT(run.err, HasSubstr("flair: 1 of 2 problems could not be measured")) << kind;
    EXPECT_THAT(run.out, HasSubstr("\nhall ")) << kind;
  }
}

TEST_F(SolverCommands, TheCatalogueDescribesEveryTypeItListsAlsoUnderItsAliases) {
  const json catalog = json::parse(Good({"catalog", "--json"}).out);
  const std::string overview = Good({"catalog"}).out;
  ASSERT_GT(catalog["types"].size(), 40u);
  for (const json& type : catalog["types"]) {
    // The optimizer's own terms can be looked up, but nobody asks for them.
    const std::string name = type["name"];
    EXPECT_EQ(("\n" + overview).find("\n" + name + " ") != std::string::npos, type["family"] != "room") << name;
    EXPECT_THAT(Good({"catalog", name}).out, StartsWith(name + ": "));
  }
  const std::string text = Good({"catalog", "in_corner"}).out;
  EXPECT_THAT(text, StartsWith("in_corner: "));
  EXPECT_EQ(Good({"catalog", "ind_in_corner"}).out, text);
}

TEST_F(SolverCommands, AReaderThatGoesAwayIsNoCrash) {
  // As `flair-dev bench solve DIR | head -1`: nobody reads what it prints, and nobody is told so.
  Process process(ProgramPath("flair-dev"), {"bench", "solve", Problems()}, {{"FLAIR_HOME", Path("home")}});
  process.CloseOutput();
  const Finished run = process.Wait();
  EXPECT_EQ(run.exit_code, 4) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("output")));
}

}  // namespace
}  // namespace flair::testing
