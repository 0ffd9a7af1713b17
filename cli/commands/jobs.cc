// SPDX-License-Identifier: GPL-3.0-or-later
// flair jobs: what was designed before, and what is running.
#include <cstdio>
#include <functional>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/input/command_line.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct JobsArguments {
  std::string id;
  std::string orchestrator;
  int count = 20;
  bool json = false;
};

std::string StateName(v1::JobState state) {
  std::string name = v1::JobState_Name(state).substr(std::string("JOB_STATE_").size());
  for (char& c : name) c = static_cast<char>(c - 'A' + 'a');
  return name;
}

// Of a brief, in the list.
constexpr size_t kShownOfText = 60;

// "20260521T134501123456-3fa2c1 from solve"; empty when it is no replay.
std::string ReplayText(const v1::Job& job) {
  if (!job.spec().has_replay()) return "";
  const v1::Replay& replay = job.spec().replay();
  return replay.job_id() + (replay.from_stage().empty() ? "" : " from " + replay.from_stage());
}

void ShowJob(const v1::Job& job) {
  fmt::print("{:<11}{}\n{:<11}{}{}\n{:<11}{}\n{:<11}{}\n{:<11}{}\n", "job", job.id(), "state", StateName(job.state()),
             job.stage().empty() ? "" : " at " + job.stage(), "asked for", PrintableLine(job.spec().brief().text()),
             "seed", job.spec().brief().seed(), "created", LocalTimeText(job.create_time()));
  if (job.spec().has_replay()) fmt::print("{:<11}{}\n", "replay of", ReplayText(job));
  if (job.has_end_time()) fmt::print("{:<11}{}\n", "ended", LocalTimeText(job.end_time()));
  if (!job.error().empty()) fmt::print("{:<11}{}\n", "error", Printable(job.error()));
  fmt::print("{:<11}{}\n", "artifacts", job.artifacts_size());
}

absl::Status List(Session& session, const JobsArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<v1::Job> jobs, session.ListJobs(arguments.count));
  for (const v1::Job& job : jobs) {
    if (arguments.json) {
      fmt::print("{}\n", ToJsonLine(job));
    } else {
      fmt::print("{}  {:<9}  {}  {}{}\n", job.id(), StateName(job.state()), LocalTimeText(job.create_time()),
                 Shortened(PrintableLine(job.spec().brief().text()), kShownOfText),
                 job.spec().has_replay() ? "  (replay of " + ReplayText(job) + ")" : "");
    }
  }
  if (jobs.empty() && !arguments.json) fmt::print(stderr, "No jobs yet. Try: flair design \"A bedroom.\" --out out\n");
  return absl::OkStatus();
}

absl::Status Report(const absl::StatusOr<v1::Job>& job, bool json) {
  if (!job.ok()) return job.status();
  if (json) {
    fmt::print("{}\n", ToJsonLine(*job));
  } else {
    ShowJob(*job);
  }
  return absl::OkStatus();
}

absl::Status ListArtifacts(Session& session, const JobsArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Job job, session.GetJob(arguments.id));
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    if (arguments.json) {
      fmt::print("{}\n", ToJsonLine(ref));
    } else {
      fmt::print("{:<20} {}  {}\n", KindName(ref.kind()), ref.id(), Counted(ref.size_bytes(), "byte"));
    }
  }
  return absl::OkStatus();
}

absl::Status Delete(Session& session, const JobsArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::DeleteJobResponse deleted, session.DeleteJob(arguments.id));
  if (arguments.json) {
    fmt::print("{}\n", ToJsonLine(deleted));
  } else {
    fmt::print("deleted job {} and {} that no other job had\n", arguments.id,
               Counted(deleted.deleted_artifact_count(), "artifact"));
  }
  return absl::OkStatus();
}

using JobsAction = std::function<absl::Status(Session&, const JobsArguments&)>;

void AddCallFlags(CLI::App& command, JobsArguments& arguments) {
  command.add_option("--orchestrator", arguments.orchestrator, "Ask this one instead of the local store")
      ->type_name("HOST:PORT");
  command.add_flag("--json", arguments.json, "One JSON object per line");
}

void AddCount(CLI::App& command, JobsArguments& arguments) {
  command.add_option("-n,--count", arguments.count, "Most jobs to list, 1 to 100000 (20)")
      ->type_name("N")
      ->check(WholeNumber(1, 100000));
}

void AddAction(CLI::App& jobs, const std::shared_ptr<JobsArguments>& arguments, absl::Status& result,
               const std::string& name, const std::string& help, bool takes_id, const JobsAction& action) {
  CLI::App* command = jobs.add_subcommand(name, help);
  if (takes_id) command->add_option("ID", arguments->id, "Id of the job, as flair jobs prints it")->required();
  AddCallFlags(*command, *arguments);
  if (!takes_id) AddCount(*command, *arguments);
  command->callback([arguments, &result, action] {
    absl::StatusOr<std::unique_ptr<Session>> session = Session::Open(arguments->orchestrator);
    result = session.ok() ? action(**session, *arguments) : session.status();
    std::fflush(stdout);
  });
}

}  // namespace

void AddJobs(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<JobsArguments>();
  CLI::App* jobs = program.add_subcommand("jobs", "List past and running jobs.");
  jobs->require_subcommand(0, 1);
  AddAction(*jobs, arguments, result, "list", "Jobs, newest first (the default).", false, List);
  AddAction(*jobs, arguments, result, "show", "One job.", true,
            [](Session& session, const JobsArguments& a) { return Report(session.GetJob(a.id), a.json); });
  AddAction(*jobs, arguments, result, "cancel", "Cancel a job.", true,
            [](Session& session, const JobsArguments& a) { return Report(session.CancelJob(a.id), a.json); });
  AddAction(*jobs, arguments, result, "delete",
            "Delete a job that has ended, with the artifacts that no other job has. Files that it wrote stay.", true,
            Delete);
  AddAction(*jobs, arguments, result, "artifacts", "List the artifacts of a job.", true, ListArtifacts);
  AddCallFlags(*jobs, *arguments);
  AddCount(*jobs, *arguments);
  jobs->callback([jobs, arguments, &result] {
    if (!jobs->get_subcommands().empty()) return;
    absl::StatusOr<std::unique_ptr<Session>> session = Session::Open(arguments->orchestrator);
    result = session.ok() ? List(**session, *arguments) : session.status();
  });
}

}  // namespace flair::cli
