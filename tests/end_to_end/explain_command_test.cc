// SPDX-License-Identifier: GPL-3.0-or-later
// flair explain on real layouts, as a person runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ExplainCommand : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram(ProgramWith(arguments), arguments, {{"FLAIR_HOME", Path("home")}});
  }
  Finished Good(const std::vector<std::string>& arguments) const {
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments[0] << ": " << run.err;
    return run;
  }
  // A designed bedroom's layout.
  std::string Bedroom() const {
    Good({"design", "A bedroom that is 4m x 5m with a grand piano.", "--out", Path("bed"), "--seed", "1"});
    return Path("bed/layout.pb");
  }
  // A layout of calls that come from no sentence.
  std::string TeaRoom() const {
    Good({"import", "flairgpt", fmt::format("{}/tests/end_to_end/rooms/tea_room.json", FLAIR_SOURCE_DIR), "--out",
          Path("graph.pb")});
    Good({"solve", Path("graph.pb"), "--out", Path("tea.pb"), "--seed", "1"});
    return Path("tea.pb");
  }

  TestFolder folder_;
};

TEST_F(ExplainCommand, TellsByZoneWhereThingsStandAndWhyInLinesThatFitAScreen) {
  const Finished run = Good({"explain", Bedroom()});
  EXPECT_THAT(run.out, StartsWith("A bedroom of 4 m x 5 m (20 m²), 3 m high, with a door in the "));
  EXPECT_THAT(run.out, HasSubstr("\nSLEEPING - "));
  EXPECT_THAT(run.out, HasSubstr("\nThe double bed stands "));
  EXPECT_THAT(run.out, HasSubstr("The headboard of the double bed is against a wall: a headboard needs support and the "
                                 "sleeper\n    calm. [e3]"));
  EXPECT_THAT(run.out, HasSubstr("You asked for a grand piano."));
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(ExplainCommand, TellsOfEveryObjectAndEverySentenceThatFailsWithItsFigure) {
  const std::string layout = Bedroom();
  const json note = json::parse(Good({"explain", layout, "--json"}).out);
  const json artifact = json::parse(ReadAll(Path("bed/layout.json")))["solved_layout"];
  std::set<std::string> objects, sentences;
  for (const json& zone : note["zones"]) {
    for (const json& object : zone["objects"]) {
      EXPECT_TRUE(objects.insert(object["id"]).second) << object["id"];
      if (object["placed"]) EXPECT_NE(object["stands"], "");
      for (const json& demand : object["demands"]) {
        sentences.insert(demand["sentence_id"]);
        if (demand["fate"] == "missed") EXPECT_GT(demand["missed_by"], 0) << demand;
      }
    }
  }
  EXPECT_EQ(objects.size(), artifact["graph"]["object_list"]["objects"].size());
  EXPECT_EQ(sentences.size(), artifact["graph"]["constraint_list"]["sentences"].size());
  const std::string all = Good({"explain", layout, "--all"}).out;
  EXPECT_GT(all.size(), Good({"explain", layout}).out.size());
}

TEST_F(ExplainCommand, TellsOfCallsWithoutSentencesInWords) {
  const std::string text = Good({"explain", TeaRoom(), "--all"}).out;
  EXPECT_THAT(text, HasSubstr("flush on a wall"));
  EXPECT_THAT(text, Not(HasSubstr("against_wall")));
}

TEST_F(ExplainCommand, TellsOfOneObjectByIdOrName) {
  const std::string layout = Bedroom();
  const json note = json::parse(Good({"explain", layout, "--json"}).out);
  const json first = note["zones"][0]["objects"][0];
  const std::string id = first["id"], name = first["name"];
  const std::string by_id = Good({"explain", layout, "--object", id}).out;
  EXPECT_THAT(by_id, StartsWith("The double bed stands "));
  EXPECT_EQ(by_id, Good({"explain", layout, "--object", name}).out);
  EXPECT_EQ(json::parse(Good({"explain", layout, "--object", id, "--json"}).out), first);
}

TEST_F(ExplainCommand, ReadsEveryFormOfAnArtifactAlike) {
  const std::string layout = Bedroom();
  const std::string text = Good({"explain", layout}).out;
  EXPECT_EQ(Good({"explain", Path("bed/layout.json")}).out, text);
  WriteAll(Path("layout.textproto"), Good({"inspect", layout, "--format", "textproto"}).out);
  EXPECT_EQ(Good({"explain", Path("layout.textproto")}).out, text);
  EXPECT_THAT(Good({"inspect", Path("layout.textproto")}).out, HasSubstr("matches its bytes"));
}

TEST_F(ExplainCommand, SaysWhatIsWrongAndWhatWouldBeRight) {
  const std::string layout = TeaRoom();
  const auto fails = [&](const std::vector<std::string>& arguments, int code, const std::string& words) {
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(words));
    EXPECT_EQ(run.out, "");
  };
  fails({"explain", layout, "--object", "throne"}, 2, "--object: \"throne\" is not in the layout; it has floor_0");
  fails({"explain", Path("graph.pb")}, 2, "a layout graph; expected a solved layout; first: flair solve");
  fails({"explain", Path("nothing.pb")}, 2, "no such file");
  std::string bytes = ReadAll(layout);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  WriteAll(Path("bent.pb"), bytes);
  fails({"explain", Path("bent.pb")}, 5, "bent.pb");
  WriteAll(Path("words.textproto"), "solved_layout { graph { nonsense: 1 } }");
  fails({"explain", Path("words.textproto")}, 2, "words.textproto:1: column 33: ");
}

}  // namespace
}  // namespace flair::testing
