// SPDX-License-Identifier: GPL-3.0-or-later
// What five real programs say of themselves while they design a room: figures and log lines.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "absl/time/clock.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr char kBrief[] = "A bedroom that is 4m x 5m for somebody who collects lighthouses.";
constexpr char kModel[] = "llm { base_url: \"http://127.0.0.1:9/v1\" model: \"none\" }\n";

// The body that http://ADDRESS/PATH answers; empty when it is not 200. ADDRESS is on this machine.
std::string HttpGet(const std::string& address, const std::string& path) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in to = {};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
  to.sin_port = ::htons(static_cast<uint16_t>(std::atoi(address.substr(address.rfind(':') + 1).c_str())));
  std::string answer;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
    (void)::send(socket, request.data(), request.size(), MSG_NOSIGNAL);
    char buffer[4096];
    for (ssize_t n; (n = ::recv(socket, buffer, sizeof buffer, 0)) > 0;) answer.append(buffer, static_cast<size_t>(n));
  }
  ::close(socket);
  const size_t body = answer.find("\r\n\r\n");
  return answer.starts_with("HTTP/1.1 200") && body != std::string::npos ? answer.substr(body + 4) : "";
}

// Lines of Prometheus' text form, by what stands before the value: "flair_rpcs_total{code=\"OK\",rpc=\"Solve\"}".
std::map<std::string, double> ReadFigures(const std::string& text) {
  std::map<std::string, double> figures;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t space = line.rfind(' ');
    if (!line.starts_with("#") && space != std::string::npos) {
      figures[line.substr(0, space)] = std::atof(line.c_str() + space);
    }
  }
  return figures;
}

// The programs, and where their figures are.
class Observed {
 public:
  Observed() : programs_(folder_.path(), "", "info", "metrics_address: \"127.0.0.1:0\" log_format: \"json\"") {
    for (const auto& [name, program] : All()) metrics_[name] = program->process().WaitForLine("metrics on ");
  }

  std::map<std::string, ServerProgram*> All() {
    return {{"flair-language", &programs_.language_program()},
            {"flair-translator", &programs_.translator_program()},
            {"flair-optimizer", &programs_.optimizer_program()},
            {"flair-renderer", &programs_.renderer_program()},
            {"flair-orchestrator", &programs_.orchestrator_program()}};
  }
  // The id of the job.
  std::string Design() {
    const std::string out = (folder_ / ("out" + std::to_string(++design_count_))).string();
    const Finished run =
        RunProgram("flair", {"design", kBrief, "--out", out, "--orchestrator", programs_.orchestrator()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Finished jobs = RunProgram("flair", {"jobs", "--json", "--orchestrator", programs_.orchestrator()});
    return json::parse(jobs.out.substr(0, jobs.out.find('\n')))["id"];
  }
  std::string Text(const std::string& program) { return HttpGet(metrics_[program], "/metrics"); }
  std::map<std::string, double> Figures(const std::string& program) { return ReadFigures(Text(program)); }
  // Those of the orchestrator when so many runs and watches of jobs have ended: who watches sees the end of a job
  // before the end of its run is counted, and is counted when the orchestrator has noticed that they left.
  std::map<std::string, double> FiguresAfter(int runs) {
    const absl::Time patience = absl::Now() + absl::Minutes(1);
    auto figures = Figures("flair-orchestrator");
    while ((figures["flair_job_runs_total{outcome=\"ended\"}"] < runs || Watches(figures) < runs) &&
           absl::Now() < patience) {
      figures = Figures("flair-orchestrator");
    }
    return figures;
  }
  // Watchers may leave once they have seen the end.
  static double Watches(std::map<std::string, double>& figures) {
    return figures["flair_rpcs_total{code=\"OK\",rpc=\"WatchJob\"}"] +
           figures["flair_rpcs_total{code=\"CANCELLED\",rpc=\"WatchJob\"}"];
  }
  // Ends all programs; the lines of each.
  std::map<std::string, std::vector<json>> Logs() {
    std::map<std::string, std::vector<json>> logs;
    for (const auto& [name, program] : All()) {
      program->process().Signal(SIGTERM);
      std::istringstream lines(program->process().Wait().err);
      for (std::string line; std::getline(lines, line);) logs[name].push_back(json::parse(line));
    }
    return logs;
  }
  AllPrograms& programs() { return programs_; }
  const TestFolder& folder() const { return folder_; }

 private:
  TestFolder folder_;
  AllPrograms programs_;
  std::map<std::string, std::string> metrics_;
  int design_count_ = 0;
};

TEST(Figures, TellWhatOneDesignTook) {
  Observed observed;
  observed.Design();
  auto orchestrator = observed.FiguresAfter(1);
  EXPECT_EQ(orchestrator["flair_jobs_created_total{form=\"single\"}"], 1);
  EXPECT_EQ(orchestrator["flair_jobs_ended_total{failure=\"none\",state=\"succeeded\"}"], 1);
  EXPECT_EQ(orchestrator["flair_job_runs_total{outcome=\"ended\"}"], 1);
  EXPECT_EQ(orchestrator["flair_jobs_running"], 0);
  EXPECT_GT(orchestrator["flair_jobs_running_limit"], 0);
  EXPECT_EQ(orchestrator["flair_job_duration_seconds_count"], 1);
  for (const std::string stage : {"room", "zones", "objects", "style", "constraints", "cleaning", "completion",
                                  "translation", "solve", "render", "report"}) {
    EXPECT_EQ(orchestrator["flair_stages_total{outcome=\"made\",stage=\"" + stage + "\"}"], 1) << stage;
    EXPECT_GT(orchestrator["flair_stage_duration_seconds_sum{stage=\"" + stage + "\"}"], 0) << stage;
  }
  EXPECT_EQ(orchestrator["flair_rpcs_total{code=\"OK\",rpc=\"CreateJob\"}"], 1);
  EXPECT_EQ(Observed::Watches(orchestrator), 1);

  auto optimizer = observed.Figures("flair-optimizer");
  EXPECT_EQ(optimizer["flair_rpcs_total{code=\"OK\",rpc=\"Solve\"}"], 1);
  EXPECT_EQ(optimizer["flair_rpc_duration_seconds_count{rpc=\"Solve\"}"], 1);
  EXPECT_EQ(optimizer["flair_rpc_wait_seconds_count{rpc=\"Solve\"}"], 1);
  EXPECT_EQ(optimizer["flair_rpcs_in_flight{rpc=\"Solve\"}"], 0);
  EXPECT_GT(optimizer["flair_optimizer_restarts_total{requester=\"own\"}"], 0);
  EXPECT_GT(optimizer["flair_optimizer_evaluations_total{requester=\"own\"}"], 100);
  EXPECT_EQ(optimizer["flair_optimizer_restarts_total{requester=\"peer\"}"], 0);
  EXPECT_GT(optimizer["flair_optimizer_constraints_total{outcome=\"satisfied\"}"], 0);
  EXPECT_GT(optimizer["process_resident_memory_bytes"], 1e6);
  EXPECT_EQ(observed.Figures("flair-renderer")["flair_render_duration_seconds_count{view=\"plan\"}"], 1);
  EXPECT_EQ(observed.Figures("flair-language")["flair_rpcs_total{code=\"OK\",rpc=\"DescribeRoom\"}"], 1);
  EXPECT_EQ(observed.Figures("flair-translator")["flair_rpcs_total{code=\"OK\",rpc=\"Translate\"}"], 1);

  // Once more: everything is taken from the store.
  observed.Design();
  orchestrator = observed.FiguresAfter(2);
  EXPECT_EQ(orchestrator["flair_stages_total{outcome=\"reused\",stage=\"solve\"}"], 1);
  EXPECT_EQ(orchestrator["flair_stages_total{outcome=\"made\",stage=\"solve\"}"], 1);
  EXPECT_EQ(observed.Figures("flair-optimizer")["flair_rpcs_total{code=\"OK\",rpc=\"Solve\"}"], 1);
}

struct Family {
  std::string type;
  std::string help;
};

std::map<std::string, Family> ReadFamilies(const std::string& text) {
  std::map<std::string, Family> families;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string sign, what, name, rest;
    words >> sign >> what >> name;
    std::getline(words >> std::ws, rest);
    if (sign == "#" && what == "HELP") families[name].help = rest;
    if (sign == "#" && what == "TYPE") families[name].type = rest;
  }
  return families;
}

// Those of all five programs, and of one that asks a model.
std::map<std::string, Family> AllFamilies() {
  Observed observed;
  std::string text;
  for (const auto& [name, program] : observed.All()) text += observed.Text(name);
  ServerProgram asking("flair-language", "runtime { metrics_address: \"127.0.0.1:0\" }\n" + std::string(kModel),
                       observed.folder().path());
  return ReadFamilies(text + HttpGet(asking.process().WaitForLine("metrics on "), "/metrics"));
}

std::set<std::string> NamesIn(const std::string& text) {
  static const std::regex name("\\b(flair|process)_[a-z0-9_]+\\b");
  std::set<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i) names.insert(i->str());
  return names;
}

// Without what Prometheus adds to the names of histograms.
std::string FamilyOf(const std::string& name, const std::map<std::string, Family>& families) {
  for (const std::string suffix : {"_bucket", "_sum", "_count"}) {
    const std::string family = name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : "";
    if (families.contains(family) && families.at(family).type == "histogram") return family;
  }
  return name;
}

TEST(Figures, KeepTheRulesOfPrometheus) {
  const auto families = AllFamilies();
  ASSERT_GT(families.size(), 30u);
  const std::regex name_rule("(flair|process)_[a-z][a-z0-9_]*[a-z0-9]");
  for (const auto& [name, family] : families) {
    EXPECT_TRUE(std::regex_match(name, name_rule)) << name;
    EXPECT_EQ(family.type == "counter", name.ends_with("_total")) << name << " is a " << family.type;
    if (family.type == "histogram") EXPECT_TRUE(name.ends_with("_seconds")) << name << " has no unit at its end";
    EXPECT_TRUE(family.help.ends_with(".")) << name << ": " << family.help;
  }
}

TEST(Figures, TheDashboardAndTheAlertsAskForWhatThereIs) {
  const auto families = AllFamilies();
  const std::filesystem::path deploy = std::filesystem::path(FLAIR_SOURCE_DIR) / "deploy";
  EXPECT_TRUE(json::accept(ReadAll(deploy / "grafana/flair.json")));
  for (const std::string file : {"grafana/flair.json", "prometheus/alerts.yml"}) {
    const std::set<std::string> names = NamesIn(ReadAll(deploy / file));
    EXPECT_GT(names.size(), 5u) << file;
    for (const std::string& name : names)
      EXPECT_TRUE(families.contains(FamilyOf(name, families))) << file << ": " << name;
  }
}

TEST(Figures, AreAllInTheManual) {
  const auto families = AllFamilies();
  const std::string page = ReadAll(std::filesystem::path(FLAIR_SOURCE_DIR) / "docs/operations.md");
  for (const auto& [name, family] : families) {
    EXPECT_THAT(page, HasSubstr("| `" + name + "` | " + family.type + " |"))
        << "docs/operations.md lacks it: " << family.help;
  }
  for (const std::string& name : NamesIn(page)) {
    EXPECT_TRUE(families.contains(FamilyOf(name, families))) << "docs/operations.md has it, no program does: " << name;
  }
}

TEST(Logs, FollowAJobThroughAllProcesses) {
  Observed observed;
  const std::string job_id = observed.Design();
  auto logs = observed.Logs();
  for (auto& [name, lines] : logs) {
    std::vector<json> of_job;
    for (const json& line : lines) {
      EXPECT_EQ(line["program"], name);
      EXPECT_TRUE(std::regex_match(line["time"].get<std::string>(),
                                   std::regex("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}Z")));
      if (line.dump().find(job_id) != std::string::npos) of_job.push_back(line);
      EXPECT_THAT(line.dump(), Not(HasSubstr("lighthouses"))) << "log lines hold no briefs";
    }
    EXPECT_THAT(of_job, Not(IsEmpty())) << name << " says nothing of job " << job_id;
  }
  std::vector<std::string> stages;
  for (const json& line : logs["flair-orchestrator"]) {
    if (line["message"] == "stage made") stages.push_back(line["stage"]);
  }
  EXPECT_EQ(stages.front(), "brief");
  EXPECT_EQ(stages.back(), "report");
  std::map<std::string, json> solve;
  for (const json& line : logs["flair-optimizer"]) {
    if (line.value("rpc", "") == "Solve") solve = line;
  }
  EXPECT_EQ(solve["request_id"], job_id + "/solve");
  EXPECT_EQ(solve["code"], "OK");
  EXPECT_GT(solve["duration_ms"].get<double>(), 0);
}

TEST(Logs, ARequestCannotForgeThem) {
  Observed observed;
  const std::string hostile = "x\"}\n{\"program\":\"flair-optimizer\",\"forged\":true}\x1b[2J";
  const auto stub = v1::OptimizerService::NewStub(
      *runtime::MakeChannel(observed.programs().optimizer(), "flair.v1.OptimizerService"));
  v1::SolveRequest request;
  request.set_request_id(hostile);
  runtime::CallContext call;
  EXPECT_FALSE(runtime::UnaryRequest(*stub, &v1::OptimizerService::StubInterface::Solve, request, call).ok());
  int found = 0;
  const auto logs = observed.Logs();
  for (const json& line : logs.at("flair-optimizer")) {
    EXPECT_FALSE(line.contains("forged"));
    if (line.value("request_id", "") == hostile) ++found;
  }
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace flair::testing
