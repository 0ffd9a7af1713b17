// SPDX-License-Identifier: GPL-3.0-or-later
// Reading artifacts: by file, id and job, in every form; changing them by hand; where they come from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "cli/exit_code.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

class InspectCommand : public ::testing::Test {
 protected:
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram(ProgramWith(arguments), arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  std::string Good(const std::vector<std::string>& arguments) const {
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }
  void ExpectRefused(const std::vector<std::string>& arguments, int code, const std::string& words) const {
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, code) << arguments.front() << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr(words)) << arguments.front();
  }
  std::string Path(const std::string& name) const { return folder_ / name; }
  // A small room in out/, by the job that is returned.
  std::string Design() const {
    Good({"design", "A bedroom that is 3m x 3m.", "--out", Path("out"), "--quiet"});
    const std::string jobs = Good({"jobs", "--json"});
    return json::parse(jobs.substr(0, jobs.find('\n')))["id"];
  }
  // graph.json with one value changed; the line of the change, from 1.
  int Edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = ReadAll(Path("out/graph.json"));
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    WriteAll(Path(name), text.replace(at, from.size(), to));
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }

  TestFolder folder_;
};

TEST_F(InspectCommand, AFileItsIdAndItsJobAreTheSameArtifact) {
  const std::string job = Design();
  const json layout = json::parse(Good({"inspect", Path("out/layout.pb"), "--json"}));
  const std::string id = layout["id"];
  for (const std::string& source : {Path("out/layout.json"), id, id.substr(0, 10), job + "/solve", job + "/layout"}) {
    EXPECT_EQ(json::parse(Good({"inspect", source, "--format", "json"})), layout) << source;
  }
  EXPECT_THAT(Good({"inspect", job}),
              AllOf(HasSubstr("state      succeeded"), HasSubstr("\nsolve "), HasSubstr(id.substr(0, 12))));
  EXPECT_EQ(Good({"inspect", id, "--field", "placements[0].theta_rad", "--json"}),
            layout["solved_layout"]["placements"][0].value("theta_rad", 0.0) == 0
                ? "0\n"
                : layout["solved_layout"]["placements"][0]["theta_rad"].dump() + "\n");
  EXPECT_EQ(Good({"explain", job + "/solve"}), Good({"explain", Path("out/layout.pb")}));
  Good({"solve", job + "/translation", "--out", Path("a.pb")});
  Good({"solve", Path("out/graph.pb"), "--out", Path("b.pb")});
  EXPECT_TRUE(ReadAll(Path("a.pb")) == ReadAll(Path("b.pb")));
  Good({"resolve", id, "--edit", "pin wardrobe", "--out", Path("pinned.pb")});
  Good({"inspect", job + "/render", "--field", "preview.image", "--out", Path("again.png")});
  EXPECT_TRUE(ReadAll(Path("again.png")) == ReadAll(Path("out/plan.png")));
  ExpectRefused({"inspect", job + "/slove"}, cli::kExitBadInput,
                "is not a stage (did you mean solve?); it has brief, room");
  ExpectRefused({"inspect", job, "--field", "x"}, cli::kExitBadInput, "say which of its artifacts");
  ExpectRefused({"inspect", "000000000000"}, cli::kExitBadInput, "has an id that begins like this");
  ExpectRefused({"inspect", "nothing"}, cli::kExitBadInput, "no such file; nor is it 6 or more digits");
}

TEST_F(InspectCommand, DigitsThatTwoIdsBeginWithNameBoth) {
  const std::string both = Path("home/artifacts/ab");
  std::filesystem::create_directories(both);
  for (const char last : {'1', '2'}) WriteAll(both + "/abcdef" + std::string(57, '0') + last + ".pb", "x");
  ExpectRefused({"inspect", "abcdef"}, cli::kExitBadInput, "2 artifacts have ids that begin like this: abcdef00");
  ExpectRefused({"inspect", "abcdef", "--store", Path("elsewhere")}, cli::kExitBadInput, "elsewhere");
  EXPECT_FALSE(std::filesystem::exists(Path("elsewhere")));
}

TEST_F(InspectCommand, AnOrchestratorElsewhereIsAskedForTheSame) {
  AllPrograms programs(folder_.path());
  const std::string at = programs.orchestrator();
  Good({"design", "A bedroom that is 3m x 3m.", "--out", Path("out"), "--quiet", "--orchestrator", at});
  const std::string jobs = Good({"jobs", "--json", "--orchestrator", at});
  const std::string job = json::parse(jobs.substr(0, jobs.find('\n')))["id"];
  const json graph = json::parse(ReadAll(Path("out/graph.json")));
  for (const std::string& source : {job + "/translation", std::string(graph["id"]).substr(0, 12)}) {
    EXPECT_EQ(json::parse(Good({"inspect", source, "--json", "--orchestrator", at})), graph);
  }
  EXPECT_THAT(Good({"inspect", job + "/report", "--provenance", "--orchestrator", at}),
              AllOf(StartsWith("brief "), HasSubstr("the orchestrator at " + at), HasSubstr("\nreport ")));
  ExpectRefused({"inspect", job, "--orchestrator", "127.0.0.1:1"}, cli::kExitUnreachable, "127.0.0.1:1");
}

TEST_F(InspectCommand, EveryFormTurnsIntoEveryOtherWithoutLoss) {
  Design();
  for (const char* kind : {"brief", "room", "zones", "objects", "style", "constraints_raw", "constraints",
                           "constraints_completed", "graph", "layout"}) {
    const std::string first = Path("out/" + std::string(kind) + ".pb");
    std::string last = first;
    for (const char* form : {"a.json", "b.textproto", "c.pb", "d.textproto", "e.json", "f.pb"}) {
      Good({"inspect", last, "--out", Path(form)});
      last = Path(form);
    }
    EXPECT_TRUE(ReadAll(last) == ReadAll(first)) << kind;
    EXPECT_TRUE(ReadAll(Path("a.json")) == ReadAll(Path("e.json"))) << kind;
    EXPECT_THAT(Good({"inspect", first}), HasSubstr("matches its bytes")) << kind;
  }
}

TEST_F(InspectCommand, WhatIsEditedByHandIsTakenAndSaysSo) {
  Design();
  Edit("out/mine.json", "\"weight\": 2", "\"weight\": 1.75");
  EXPECT_THAT(Good({"inspect", Path("out/mine.json")}),
              HasSubstr("edited by  hand, of flair-translator, grammar, version "));
  Good({"inspect", Path("out/mine.json"), "--out", Path("out/mine.pb")});
  for (const char* graph : {"out/mine.json", "out/mine.pb"}) {
    Good({"solve", Path(graph), "--out", Path("out/own.pb")});
    EXPECT_THAT(
        Good({"inspect", Path("out/own.pb")}),
        HasSubstr("style > constraints_raw > constraints > constraints_completed > graph > graph (edited) > layout\n"));
    EXPECT_EQ(Good({"inspect", Path("out/own.pb"), "--field", "made_from_ids[0]"}),
              Good({"inspect", Path(graph), "--field", "id"}));
  }
  for (const char* form : {"own.json", "own.textproto"}) {
    Good({"inspect", Path("out/own.pb"), "--out", Path(form)});
    Good({"explain", Path(form)});
    Good({"render", Path(form), "--out", Path("own.svg")});
    Good({"resolve", Path(form), "--edit", "pin wardrobe", "--out", Path("pinned.pb")});
    Good({"export", "scene", Path(form), "--out", Path("own.glb")});
    Good({"export", "flairgpt", Path(form), "--out", Path("poses.json")});
  }
}

TEST_F(InspectCommand, AFaultIsToldWithFileLineAndPathByEveryCommand) {
  Design();
  const int line = Edit("bad.json", "\"width_m\": 1.2", "\"width_m\": -1.2");
  const std::string told = Path("bad.json") + ":" + std::to_string(line) + ": layout_graph.";
  ExpectRefused({"inspect", Path("bad.json")}, cli::kExitBadInput, told);
  ExpectRefused({"inspect", Path("bad.json"), "--out", Path("bad.pb")}, cli::kExitBadInput, told);
  ExpectRefused({"solve", Path("bad.json"), "--out", Path("bad.pb")}, cli::kExitBadInput, told);
  EXPECT_FALSE(std::filesystem::exists(Path("bad.pb")));
  const int typo = Edit("typo.json", "\"edges\"", "\"egdes\"");
  ExpectRefused({"solve", Path("typo.json"), "--out", Path("bad.pb")}, cli::kExitBadInput,
                Path("typo.json") + ":" + std::to_string(typo) +
                    ": layout_graph.egdes: LayoutGraph has no field \"egdes\" "
                    "(did you mean edges?)");
}

TEST_F(InspectCommand, WhatIsNoArtifactIsRefusedByEveryCommand) {
  WriteAll(Path("plan.pb"), "\x89PNG\r\n\x1a\n and so on");
  WriteAll(Path("large.pb"), "");
  std::filesystem::resize_file(Path("large.pb"), uintmax_t{1} << 30);
  ::mkfifo(Path("pipe.pb").c_str(), 0600);
  std::filesystem::create_symlink(Path("nowhere"), Path("link.pb"));
  const std::tuple<const char*, int, const char*> files[] = {
      {"plan.pb", cli::kExitCorrupt, "not a Flair artifact (it is a PNG picture)"},
      {"large.pb", cli::kExitBadInput, "has 1024 MiB; at most 256"},
      {"pipe.pb", cli::kExitFiles, "is a pipe"},
      {"link.pb", cli::kExitBadInput, "which does not exist"},
      {"", cli::kExitFiles, "is a folder"}};
  for (const auto& [name, code, words] : files) {
    ExpectRefused({"inspect", Path(name)}, code, words);
    ExpectRefused({"explain", Path(name)}, code, words);
    ExpectRefused({"solve", Path(name), "--out", Path("o.pb")}, code, words);
    ExpectRefused({"resolve", Path(name), "--edit", "pin bed", "--out", Path("o.pb")}, code, words);
    ExpectRefused({"render", Path(name), "--out", Path("o.png")}, code, words);
    ExpectRefused({"export", "scene", Path(name), "--out", Path("o.glb")}, code, words);
    ExpectRefused({"design", "A room.", "--brief", Path(name), "--out", Path("o")}, code, words);
  }
}

TEST_F(InspectCommand, EveryArtifactSaysWhatMadeIt) {
  const std::string job = Design();
  const json steps = json::parse(Good({"inspect", job + "/report", "--provenance", "--json"}));
  EXPECT_EQ(steps.size(), 12u);
  for (const json& step : steps) {
    EXPECT_TRUE(step["found"]) << step;
    EXPECT_THAT(std::string(step["program"]), StartsWith("flair-"));
    EXPECT_NE(step["version"], "");
    EXPECT_NE(step["build"], "");
    // Handbook and grammar are what these two are configured with; the others take nothing.
    const bool configured = step["program"] == "flair-language" || step["program"] == "flair-translator";
    EXPECT_THAT(std::string(step["configuration_digest"]), MatchesRegex(configured ? "[0-9a-f]{64}" : "")) << step;
  }
  EXPECT_EQ(steps.front()["text"], "A bedroom that is 3m x 3m.");
}

}  // namespace
}  // namespace flair::testing
