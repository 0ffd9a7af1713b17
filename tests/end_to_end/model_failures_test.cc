// SPDX-License-Identifier: GPL-3.0-or-later
// Whole designs whose language model is slow, wrong, expensive or gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"
#include "tests/fixtures/scripted_model.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr char kKey[] = "sk-7f3e-not-for-anybody";

class ModelFailures : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::string Config(const ScriptedServer& server, const std::string& more = "") const {
    WriteAll(folder_ / "llm.textproto", LlmConfigText(server, more));
    return Path("llm.textproto");
  }
  Finished Design(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"design", kModelBrief, "--out", Path("out")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("flair", arguments, {{"FLAIR_HOME", Path("home")}, {"FLAIR_TEST_KEY", kKey}});
  }
  // One line, the code, and nothing written.
  void ExpectFailed(const Finished& run, int exit_code, const std::string& about) const {
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(about));
    const size_t last = run.err.rfind("flair: ");
    ASSERT_NE(last, std::string::npos) << run.err;
    EXPECT_EQ(run.err.find('\n', last), run.err.size() - 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
  std::string Report() const { return ReadAll(folder_ / "out" / "report.md"); }

  TestFolder folder_;
};

TEST_F(ModelFailures, ABusyAndABrokenServerAreAskedAgain) {
  Script script = DesignScript();
  Exchange& busy = AddFirst("zones", script);
  busy.status = 429;
  busy.headers = {{"Retry-After", "0"}};
  AddFirst("style", script).status = 500;
  Exchange& reset = AddFirst("cleaning", script);
  reset.answer = {{"text", "{\"changes\":[]}"}};
  reset.cut_after_byte_count = 20;
  reset.end = ConnectionEnd::kReset;
  ScriptedServer server(script);
  const Finished run = Design({"--llm", Config(server)});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* step : {"zones", "style", "cleaning"}) EXPECT_THAT(RequestsOf(step, server), SizeIs(2)) << step;
  EXPECT_THAT(Report(), HasSubstr("| zone plan | scripted-1 | 1 | 0 | ")) << "attempts are not calls";
}

TEST_F(ModelFailures, AWrongAnswerIsRepairedAndTheReportSaysSo) {
  Script script = DesignScript();
  AddFirst("zones", script).answer = {{"text", "I would suggest sleeping and working."}, {"model", "scripted-1"}};
  ScriptedServer server(script);
  const Finished run = Design({"--llm", Config(server)});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("(2 calls of scripted-1, 1 repair, "));
  EXPECT_THAT(Report(), AllOf(HasSubstr("| zone plan | scripted-1 | 2 | 1 | "), HasSubstr("Faults in answers"),
                              HasSubstr("- zones: ")));
}

TEST_F(ModelFailures, AnswersThatStayUselessFailTheStepOrAreStoodInFor) {
  Script script = DesignScript();
  ExchangeOf("zones", script).answer = {{"text", "<html>Bad gateway</html>"}};
  AddFirst("zones", script).answer = {{"text", "I cannot help with that."}};
  {
    ScriptedServer server(script);
    ExpectFailed(Design({"--llm", Config(server)}), 6, "zones");
  }
  ScriptedServer server(script);
  const Finished run = Design({"--llm", Config(server), "--stand-in"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Report(),
              AllOf(HasSubstr("Without the model:"), HasSubstr("The handbook answered instead of the model")));
}

TEST_F(ModelFailures, OfTwoStepsOfAStageTheOneThatFailedIsStoodInFor) {
  Script script = DesignScript();
  ExchangeOf("objects.tertiary", script).answer = {{"text", "That is enough furniture."}};
  AddFirst("objects.tertiary", script).answer = {{"text", "No."}};
  ScriptedServer server(script);
  const Finished run = Design({"--llm", Config(server), "--stand-in"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Report(), HasSubstr("The handbook answered instead of the model: step \"objects.tertiary\": "));
  const std::string objects = RunProgram("flair", {"inspect", Path("out/objects.pb")}).out;
  EXPECT_THAT(objects, AllOf(HasSubstr("nightstand_1"), HasSubstr("It would block the way to the wardrobe.")))
      << "the model's furniture and what it left out";
  EXPECT_THAT(RequestsOf("constraints.intra", server).front().body, HasSubstr("nightstand"));
}

TEST_F(ModelFailures, AServerThatIsDownEndsTheDesignWithItsAddress) {
  WriteAll(folder_ / "llm.textproto",
           "base_url: \"http://127.0.0.1:1/v1\" model: \"m\" retry { attempt_limit: 3 first_delay_seconds: 0.001 }");
  const std::string config = Path("llm.textproto");
  ExpectFailed(Design({"--llm", config}), 6,
               "step \"room\": http://127.0.0.1:1/v1/chat/completions: Couldn't connect to server (after 3 attempts)");
  const Finished run = Design({"--llm", config, "--stand-in"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Report(), AllOf(HasSubstr("The handbook answered instead of the model"),
                              HasSubstr("read by the grammar, as the model failed")));
  EXPECT_THAT(Report(), Not(HasSubstr("| stage | model |"))) << "nobody answered";
  const std::string zones = RunProgram("flair", {"inspect", Path("out/zones.pb")}).out;
  EXPECT_THAT(zones, HasSubstr("flair-language, handbook"));
}

TEST_F(ModelFailures, ASpentBudgetEndsTheDesignAndNamesTheLimit) {
  const std::string prices = "prices { model: \"scripted\" input_usd: 1000 output_usd: 1000 }";
  for (const auto& [flag, value, about] : std::vector<std::array<std::string, 3>>{
           {"--max-calls", "2", "the budget of calls is spent: 1 more is needed, 0 are left"},
           {"--max-tokens", "1200", "tokens is spent"},
           {"--max-usd", "0.3", "US dollars is spent"}}) {
    ScriptedServer server(DesignScript());
    ExpectFailed(Design({"--llm", Config(server, prices), flag, value}), 6, about);
    std::filesystem::remove_all(folder_ / "home");
  }
}

TEST_F(ModelFailures, ADesignThatSpentItsBudgetGoesOnWithAnother) {
  Script script = DesignScript();
  const Exchange objects = ExchangeOf("objects.floor", script);
  AddFirst("objects.floor", script) = objects;
  ScriptedServer server(script);
  const std::string config = Config(server);
  const Finished spent = Design({"--llm", config, "--max-calls", "3"});
  ExpectFailed(spent, 6, "the budget of calls is spent: 1 more is needed, 0 are left");
  EXPECT_THAT(spent.err, HasSubstr("\nmodels       2 calls, ")) << "of the stages that ended well";
  EXPECT_EQ(server.requests().size(), 3u);
  const Finished run = Design({"--llm", config, "--max-calls", "9"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(server.requests().size(), 12u) << "the stage that the budget ended is asked again, the others are not";
  EXPECT_THAT(Report(), HasSubstr("Made for this job: 9; the others"));
}

TEST_F(ModelFailures, ACancelledJobClosesItsConnection) {
  Script script = DesignScript();
  ExchangeOf("zones", script).gate = "never";
  ScriptedServer server(script);
  AllPrograms programs(folder_.path(), "llm { " + LlmConfigText(server) + " }");
  ASSERT_NE(programs.orchestrator(), "");
  Process design(ProgramPath("flair"),
                 {"design", kModelBrief, "--out", Path("out"), "--json", "--orchestrator", programs.orchestrator()});
  server.WaitForRequests(2);
  const json job = json::parse(
      RunProgram("flair", {"jobs", "list", "--json", "--orchestrator", programs.orchestrator()}).out, nullptr, false);
  const Finished cancel = RunProgram("flair", {"jobs", "cancel", job["id"], "--orchestrator", programs.orchestrator()});
  EXPECT_EQ(cancel.exit_code, 0) << cancel.err;
  server.WaitForClosedByClient(1);
  ExpectFailed(design.Wait(), 1, "was cancelled");
}

// What the programs wrote and said, all of it.
TEST_F(ModelFailures, TheKeyIsInNothingThatIsWrittenOrSaid) {
  Script script = DesignScript();
  script.key = kKey;
  AddFirst("style", script).status = 500;
  std::string said;
  {
    ScriptedServer server(script);
    const Finished run = Design({"--llm", Config(server, "api_key_env: \"FLAIR_TEST_KEY\""), "--record",
                                 Path("answers"), "--cache", Path("cache")});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(server.requests().front().header("authorization"), std::string("Bearer ") + kKey);
    said += run.out + run.err;
  }
  // A server that quotes the key that it refuses.
  script.key = "another";
  {
    ScriptedServer server(script);
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::remove_all(folder_ / "home");
    const std::string config = Config(server, "api_key_env: \"FLAIR_TEST_KEY\"");
    const Finished run = Design({"--llm", config});
    ExpectFailed(run, 6, "401");
    EXPECT_THAT(server.requests(), SizeIs(1)) << "a refused key is not tried again";
    const Finished doctor =
        RunProgram("flair", {"doctor", "--llm", config}, {{"FLAIR_HOME", Path("home")}, {"FLAIR_TEST_KEY", kKey}});
    EXPECT_EQ(doctor.exit_code, 1);
    EXPECT_THAT(doctor.out, HasSubstr("Check the key"));
    said += run.out + run.err + doctor.out + doctor.err;
  }
  EXPECT_THAT(said, Not(HasSubstr(kKey)));
  EXPECT_THAT(FilesWith(kKey, folder_.path()), IsEmpty());
}

TEST_F(ModelFailures, TheKeyIsInNoLogOfAWorker) {
  setenv("FLAIR_TEST_KEY", kKey, 1);
  Script script = DesignScript();
  script.key = "another";
  ScriptedServer server(script);
  AllPrograms programs(folder_.path(), "llm { " + LlmConfigText(server) + " api_key_env: \"FLAIR_TEST_KEY\" }",
                       "debug");
  ASSERT_NE(programs.orchestrator(), "");
  const Finished run = Design({"--orchestrator", programs.orchestrator()});
  ExpectFailed(run, 6, "401");
  programs.language_program().process().Signal(SIGTERM);
  const Finished worker = programs.language_program().process().Wait();
  EXPECT_THAT(worker.err, HasSubstr("DescribeRoom"));
  for (const std::string& text : {run.out, run.err, worker.out, worker.err}) EXPECT_THAT(text, Not(HasSubstr(kKey)));
  EXPECT_THAT(FilesWith(kKey, folder_.path()), IsEmpty());
}

TEST_F(ModelFailures, TheDoctorAsksOnceAndSaysWhatTheServerTakes) {
  const auto doctor = [&](const ScriptedServer& server) {
    return RunProgram("flair", {"doctor", "--llm", Config(server)}, {{"FLAIR_HOME", Path("home")}}).out;
  };
  Script script = AlwaysAnswers(R"({"ready":true})");
  {
    ScriptedServer server(script);
    EXPECT_THAT(doctor(server), HasSubstr("ok       model        scripted answers, takes JSON schemas; "));
    EXPECT_THAT(server.requests(), SizeIs(1));
  }
  script.rejects = {{"response_format:json_schema", "Invalid parameter: 'response_format' of type 'json_schema'"}};
  {
    ScriptedServer server(script);
    EXPECT_THAT(doctor(server), HasSubstr("takes JSON mode"));
  }
  script.rejects["response_format"] = "unknown parameter: response_format";
  {
    ScriptedServer server(script);
    EXPECT_THAT(doctor(server), HasSubstr("takes neither JSON schemas nor JSON mode: plain text"));
  }
  const Finished gone = RunProgram("flair", {"doctor", "--model", "m", "--base-url", "http://127.0.0.1:1/v1"},
                                   {{"FLAIR_HOME", Path("home")}});
  EXPECT_EQ(gone.exit_code, 1);
  EXPECT_THAT(gone.out, AllOf(HasSubstr("problem  model"), HasSubstr("127.0.0.1:1"), HasSubstr("Check base_url")));
}

}  // namespace
}  // namespace flair::testing
