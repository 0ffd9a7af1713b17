// SPDX-License-Identifier: GPL-3.0-or-later
// What people get wrong with the solver's commands: the message names file or flag, field and value, the exit code is
// the documented one, and no file is there that was not there before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <memory>
#include <set>

#include "cli/exit_code.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// A folder with: hall.json (recorded problem), graph.pb and layout.pb (of it), text.json (no JSON), an empty folder.
class SolverBadInput : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    std::filesystem::copy(std::string(FLAIR_SOURCE_DIR) + "/tests/end_to_end/rooms/hall.json", Path("hall.json"));
    std::filesystem::create_directory(Path("empty"));
    std::filesystem::create_directory(Path("problems"));
    WriteAll(Path("text.json"), "{\n\"room\": nothing\n}");
    WriteAll(Path("options.txt"), "seed: 1\nrestarts: 3\n");
    WriteAll(Path("edits.txt"), "edits { pin: 3 }\n");
    ASSERT_EQ(Flair({"import", "flairgpt", Path("hall.json"), "--out", Path("graph.pb")}).exit_code, 0);
    std::filesystem::copy(Path("graph.pb"), Path("problems/hall.pb"));
    ASSERT_EQ(Flair({"solve", Path("graph.pb"), "--out", Path("layout.pb")}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string Path(const std::string& name) { return (folder_->path() / name).string(); }
  static Finished Flair(const std::vector<std::string>& arguments) {
    return RunProgram(ProgramWith(arguments), arguments, {{"FLAIR_HOME", Path("home")}});
  }
  static std::set<std::string> Files() {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_->path())) {
      if (entry.path().string().find("/home") == std::string::npos) files.insert(entry.path().string());
    }
    return files;
  }
  // "@NAME" in an argument or a message stands for the path of NAME.
  static std::string WithPaths(const std::string& text) {
    const size_t at = text.find('@');
    if (at == std::string::npos) return text;
    size_t end = at + 1;
    while (end < text.size() && (std::isalnum(text[end]) || text[end] == '.' || text[end] == '/' || text[end] == '_')) {
      ++end;
    }
    return text.substr(0, at) + Path(text.substr(at + 1, end - at - 1)) + text.substr(end);
  }
  static void ExpectRefused(const std::vector<std::string>& arguments, int exit_code, const std::string& message) {
    std::vector<std::string> with_paths;
    for (const std::string& argument : arguments) with_paths.push_back(WithPaths(argument));
    const std::set<std::string> before = Files();
    const Finished run = Flair(with_paths);
    const std::string what = fmt::format("{}", json(arguments).dump());
    EXPECT_EQ(run.exit_code, exit_code) << what << run.err;
    EXPECT_THAT(run.err, HasSubstr(WithPaths(message))) << what;
    EXPECT_EQ(run.out, "") << what << ": a refusal prints no result";
    EXPECT_EQ(Files(), before) << what;
  }

  static std::unique_ptr<TestFolder> folder_;
};

std::unique_ptr<TestFolder> SolverBadInput::folder_;

TEST_F(SolverBadInput, Import) {
  const auto refused = [](const char* in, const char* out, int exit_code, const char* message) {
    ExpectRefused({"import", "flairgpt", in, "--out", out}, exit_code, message);
  };
  refused("@nothing.json", "@new.pb", cli::kExitBadInput, "@nothing.json: no such file");
  refused("@empty", "@new", cli::kExitBadInput, "@empty: no .json files in it");
  refused("@text.json", "@new.pb", cli::kExitBadInput,
          "@text.json: not a recorded FlairGPT problem: not JSON: parse error at line 2");
  refused("@graph.pb", "@new.pb", cli::kExitBadInput, "@graph.pb: not a recorded FlairGPT problem: not JSON");
  refused("@hall.json", "@empty", cli::kExitFiles, "@empty: is a folder");
  refused("@hall.json", "/proc/flair/new.pb", cli::kExitFiles, "/proc");
}

TEST_F(SolverBadInput, ImportOfARoomWithOneWrongField) {
  struct Case {
    const char* pointer;
    json value;
    const char* message;
  };
  const std::vector<Case> cases = {
      {"/room/width", "wide", "room.width: \"wide\" should be a number in (0, 100], metres"},
      {"/room/length", -4.5, "room.length: -4.5 should be"},
      {"/room/width", 1e300, "room.width: 1e+300 should be"},
      {"/primary/0/width", nullptr, "primary[0].width: null should be a number in [0, 20], metres"},
      {"/primary/0/index", 1, "secondary[0].index: 1 should be a whole number that no other such object has"},
      {"/tertiary/0/name", 3, "tertiary[0].name: 3 should be text"},
      {"/fixed_objects/0/wall", "up", "fixed_objects[0].wall: \"up\" should be south, east, north or west"},
      {"/fixed_objects/0/position", 9, "openings[0]"},
      {"/primary/0/zone", "attic", "zone_id: \"attic\" is not a zone here; there is entry"},
      {"/calls", 5, "calls: 5 should be an object"}};
  for (const Case& c : cases) {
    json room = json::parse(ReadAll(Path("hall.json")));
    room[json::json_pointer(c.pointer)] = c.value;
    WriteAll(Path("wrong.json"), room.dump());
    ExpectRefused({"import", "flairgpt", "@wrong.json", "--out", "@new.pb"}, cli::kExitBadInput, "@wrong.json: ");
    ExpectRefused({"import", "flairgpt", "@wrong.json", "--out", "@new.pb"}, cli::kExitBadInput, c.message);
  }
  std::string text = ReadAll(Path("hall.json"));
  WriteAll(Path("wrong.json"), text.replace(text.find("1.8"), 3, "NaN"));
  ExpectRefused({"import", "flairgpt", "@wrong.json", "--out", "@new.pb"}, cli::kExitBadInput,
                "@wrong.json: not a recorded FlairGPT problem: not JSON: parse error at line 4");
}

TEST_F(SolverBadInput, Solve) {
  const auto refused = [](std::vector<std::string> arguments, int exit_code, const char* message) {
    arguments.insert(arguments.begin(), "solve");
    if (arguments.size() == 2) arguments.insert(arguments.end(), {"--out", "@new.pb"});
    ExpectRefused(arguments, exit_code, message);
  };
  refused({"@nothing.pb"}, cli::kExitBadInput, "@nothing.pb: no such file");
  refused({"@text.json"}, cli::kExitBadInput, "@text.json:2: syntax error");
  refused({"@hall.json"}, cli::kExitBadInput,
          "@hall.json: a recorded FlairGPT problem, not an artifact; first: flair-dev import");
  refused({"@layout.pb"}, cli::kExitBadInput, "@layout.pb: not a graph");
  refused({"@graph.pb", "--out", "/proc/flair/new.pb"}, cli::kExitFiles, "/proc");
  refused({"@graph.pb", "--out", "@empty"}, cli::kExitFiles, "@empty: is a folder");
  refused({"@graph.pb", "--out", "@new.pb", "--restarts", "0"}, cli::kExitBadInput,
          "--restarts: 0: expected a whole number, 1 to");
  refused({"@graph.pb", "--out", "@new.pb", "--variants", "33"}, cli::kExitBadInput,
          "--variants: 33: expected a whole number, 1 to 32");
  refused({"@graph.pb", "--out", "@new.pb", "--seed", "-1"}, cli::kExitBadInput,
          "--seed: -1: expected a whole number, 0 to");
  refused({"@graph.pb", "--out", "@new.pb", "--lambda", "zone=nan"}, cli::kExitBadInput,
          "--lambda: zone=nan: expected");
  refused({"@graph.pb", "--out", "@new.pb", "--options", "@options.txt"}, cli::kExitBadInput,
          "--options: @options.txt:2: column 9: ");
  refused({"@graph.pb", "--out", "@new.pb", "--options", "@nothing.txt"}, cli::kExitBadInput,
          "--options: @nothing.txt: no such file");
  refused({"@graph.pb", "--out", "@new.pb", "--optimizer", "127.0.0.1:1"}, cli::kExitUnreachable,
          "127.0.0.1:1: no flair.v1.OptimizerService answers there");
}

TEST_F(SolverBadInput, Resolve) {
  const auto edit = [](const char* text, const char* message) {
    ExpectRefused({"resolve", "@layout.pb", "--edit", text, "--out", "@new.pb"}, cli::kExitBadInput, message);
  };
  edit("", "edit \"\": should begin with move, pin, unpin");
  edit("paint floor_0", "edit \"paint floor_0\": should begin with");
  edit("move floor_0 nan 1", "edit \"move floor_0 nan 1\": should be: move OBJECT X Y [HEADING], metres and degrees");
  edit("move floor_0 1", "edit \"move floor_0 1\": should be: move OBJECT");
  edit("move floor_7 1 1", "\"floor_7\" is not an object of the layout; those are floor_0, floor_1, item_0");
  edit("move floor_0 99 1", "x_m: 99 is outside");
  edit("resize floor_0 0x1", "width_m: 0 is outside (0, 20]");
  edit("add floor_1 1x1x1", "\"floor_1\" is an object already");
  edit("weight e1 -1", "weight: -1 is not in (0, 100]");
  edit("drop e9", "\"e9\" is not a constraint of the layout");
  edit("edge hug object=floor_0", "no constraint type \"hug\"");
  ExpectRefused({"resolve", "@layout.pb", "--out", "@new.pb"}, cli::kExitBadInput, "no edits; give --edit");
  ExpectRefused({"resolve", "@layout.pb", "--edits", "@edits.txt", "--out", "@new.pb"}, cli::kExitBadInput,
                "--edits: @edits.txt:1: column 12: ");
  ExpectRefused({"resolve", "@graph.pb", "--edit", "pin floor_0", "--out", "@new.pb"}, cli::kExitBadInput,
                "@graph.pb: not a layout");
  ExpectRefused({"resolve", "@nothing.pb", "--edit", "pin floor_0", "--out", "@new.pb"}, cli::kExitBadInput,
                "@nothing.pb: no such file");
  ExpectRefused({"resolve", "@layout.pb", "--edit", "pin floor_0", "--out", "/proc/flair/new.pb"}, cli::kExitFiles,
                "/proc");
}

TEST_F(SolverBadInput, Export) {
  const auto refused = [](const char* in, const char* out, int exit_code, const char* message) {
    ExpectRefused({"export", "flairgpt", in, "--out", out}, exit_code, message);
  };
  refused("@graph.pb", "@new.json", cli::kExitBadInput, "@graph.pb: not a layout");
  refused("@nothing.pb", "@new.json", cli::kExitBadInput, "@nothing.pb: no such file");
  refused("@text.json", "@new.json", cli::kExitBadInput, "@text.json:2: syntax error");
  refused("@layout.pb", "/proc/flair/new.json", cli::kExitFiles, "/proc");
}

TEST_F(SolverBadInput, Bench) {
  for (const char* kind : {"solve", "resolve", "restarts"}) {
    ExpectRefused({"bench", kind, "@nothing"}, cli::kExitBadInput, "@nothing: No such file or directory");
    ExpectRefused({"bench", kind, "@empty"}, cli::kExitBadInput, "@empty: no .json or .pb files in it");
  }
  ExpectRefused({"bench", "solve", "@problems", "--json", "/proc/flair/x.json"}, cli::kExitFiles, "/proc");
  ExpectRefused({"bench", "solve", "@problems", "--json", "@empty"}, cli::kExitFiles, "@empty: is a folder");
  for (const char* kind : {"solve", "restarts"}) {
    ExpectRefused({"bench", kind, "@problems", "--restarts", "0"}, cli::kExitBadInput, "--restarts");
  }
  ExpectRefused({"bench", "solve", "@problems", "--out", "/proc/flair"}, cli::kExitFiles, "--out: /proc/flair: ");
  ExpectRefused({"bench", "solve", "@problems", "--out", "@hall.json"}, cli::kExitFiles, "--out: @hall.json: ");
  ExpectRefused({"bench", "solve", "@problems", "--only", "attic"}, cli::kExitBadInput,
                "--only: attic: no such problem in the folder; there are hall");
  ExpectRefused({"bench"}, cli::kExitBadInput, "which command?");
}

TEST_F(SolverBadInput, Catalog) {
  ExpectRefused({"catalog", "hug"}, cli::kExitBadInput, "\"hug\" is not a constraint; flair catalog lists them");
}

}  // namespace
}  // namespace flair::testing
