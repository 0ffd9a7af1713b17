// SPDX-License-Identifier: GPL-3.0-or-later
// flair jobs: what was designed before, and what is running.
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct JobsArguments : Options {
  using Options::Options;
  std::string& orchestrator = Text("--orchestrator HOST:PORT", "Ask this one instead of the local store");
  bool& json = Flag("--json", "One JSON object per line");
};
struct JobListArguments : JobsArguments {
  using JobsArguments::JobsArguments;
  int& count = Whole("-n,--count N", 1, 100000, 20, "Most jobs to list, 1 to 100000 (20)");
};
struct JobArguments : JobsArguments {
  using JobsArguments::JobsArguments;
  std::string& id = Required("ID", "Id of the job, as flair jobs prints it");
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

absl::Status ListJobs(Session& session, const JobListArguments& arguments) {
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

absl::Status ReportJob(const absl::StatusOr<v1::Job>& job, bool json) {
  if (!job.ok()) return job.status();
  if (json) {
    fmt::print("{}\n", ToJsonLine(*job));
  } else {
    ShowJob(*job);
  }
  return absl::OkStatus();
}

absl::Status ListArtifacts(Session& session, const JobArguments& arguments) {
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

absl::Status DeleteJob(Session& session, const JobArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::DeleteJobResponse deleted, session.DeleteJob(arguments.id));
  if (arguments.json) {
    fmt::print("{}\n", ToJsonLine(deleted));
  } else {
    fmt::print("deleted job {} and {} that no other job had\n", arguments.id,
               Counted(deleted.deleted_artifact_count(), "artifact"));
  }
  return absl::OkStatus();
}

absl::Status ShowOneJob(Session& session, const JobArguments& arguments) {
  return ReportJob(session.GetJob(arguments.id), arguments.json);
}

absl::Status CancelJob(Session& session, const JobArguments& arguments) {
  return ReportJob(session.CancelJob(arguments.id), arguments.json);
}

// Does something by a session with the orchestrator that the arguments name.
template <auto kAction, typename Arguments>
absl::Status InSession(const Arguments& arguments) {
  ASSIGN_OR_RETURN(const std::unique_ptr<Session> session, Session::Open(arguments.orchestrator));
  return kAction(*session, arguments);
}

}  // namespace

void AddJobs(const Commands& program) {
  const Commands jobs = program.Add("jobs", "List past and running jobs.", InSession<ListJobs, JobListArguments>);
  jobs.app.require_subcommand(0, 1);
  jobs.Add("list", "Jobs, newest first (the default).", InSession<ListJobs, JobListArguments>);
  jobs.Add("show", "One job.", InSession<ShowOneJob, JobArguments>);
  jobs.Add("cancel", "Cancel a job.", InSession<CancelJob, JobArguments>);
  jobs.Add("delete", "Delete a job that has ended, with the artifacts that no other job has. Files that it wrote stay.",
           InSession<DeleteJob, JobArguments>);
  jobs.Add("artifacts", "List the artifacts of a job.", InSession<ListArtifacts, JobArguments>);
}

}  // namespace flair::cli
