// SPDX-License-Identifier: GPL-3.0-or-later
// flair jobs and flair replay: what was designed before and what is running, and a job once more.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/job_options.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "cli/replay/comparison.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct JobsArguments : Options {
  using Options::Options;
  std::string& orchestrator = Text("--orchestrator HOST:PORT", "Ask this orchestrator instead of the local store");
  bool& json = Flag("--json", "One JSON object per line");
};
struct JobListArguments : JobsArguments {
  using JobsArguments::JobsArguments;
  int& count = Whole("-n,--count N", 1, 100000, 20, "Maximum number of jobs to list, 1 to 100000 (20)");
};
struct JobArguments : JobsArguments {
  using JobsArguments::JobsArguments;
  std::string& id = Required("ID", "Id of the job, as flair jobs prints it");
};

// Of a brief, in the list.
constexpr size_t kShownOfText = 60;

absl::Status ListJobs(Session& session, const JobListArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<v1::Job> jobs, session.ListJobs(arguments.count));
  for (const v1::Job& job : jobs) {
    if (arguments.json) {
      fmt::print("{}\n", ToJsonLine(job));
    } else {
      fmt::print("{}  {:<9}  {}  {}{}\n", job.id(), EnumInWords(job.state()), LocalTimeText(job.create_time()),
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
    fmt::print("{}", JobLines(*job));
    fmt::print("{:<11}{}\n", "artifacts", job->artifacts_size());
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

struct ReplayArguments : Options {
  using Options::Options;
  std::string& job_id = Required("JOB", "Id of the job, as flair jobs prints it");
  std::string& from = Text(
      "--from STAGE",
      "Run from this stage on, take the rest from JOB: brief, room, zones, objects, style, constraints, "
      "cleaning, completion, translation, solve, render, report (all; with --set, the first that the options affect)");
  std::vector<std::string>& options =
      List("--set NAME=VALUE",
           "An option to change, such as optimizer.restarts=500; \"NAME=\" restores the default; may be repeated");
  std::string& out = Text("-o,--out DIR", "Also write the files of flair design to this folder");
  std::string& orchestrator = Text("--orchestrator HOST:PORT", "A job of this orchestrator instead of the local store");
  StageFlags stages{command()};
  LlmFlags llm{command()};
  ModelFlags model{command()};
  bool& json = Flag("--json", "Events, then the comparison, as JSON lines on standard output");
  bool& quiet = Flag("-q,--quiet", "One line only", {"--json"});
};

// Applies the options of --set and says from which stage on they matter; from the first when there are none.
absl::StatusOr<std::string_view> SetOptions(const std::vector<std::string>& options, v1::JobSpec& spec) {
  int first = static_cast<int>(orchestrator::Stages().size());
  for (const std::string& option : options) {
    ASSIGN_OR_RETURN(const std::string_view stage, SetOption(option, spec));
    first = std::min(first, orchestrator::StageIndex(stage));
  }
  RETURN_IF_ERROR(Validate(spec.solve_options(), "--set optimizer"));
  RETURN_IF_ERROR(Validate(spec.render_options(), "--set renderer"));
  RETURN_IF_ERROR(Validate(spec, "--set"));
  return options.empty() ? "" : orchestrator::Stages()[static_cast<size_t>(first)].name;
}

absl::StatusOr<v1::JobSpec> MakeSpec(const ReplayArguments& arguments, const v1::Job& earlier) {
  v1::JobSpec spec = earlier.spec();
  spec.mutable_model_options();
  RETURN_IF_ERROR(arguments.model.Set(spec));
  ASSIGN_OR_RETURN(const std::string_view reached, SetOptions(arguments.options, spec));
  const std::string from = arguments.from.empty() ? std::string(reached) : arguments.from;
  if (!reached.empty() && orchestrator::StageIndex(from) > orchestrator::StageIndex(reached)) {
    return InvalidArgument(
        "--from {}: the options of --set affect \"{}\", which would be taken from the earlier job; --from {} "
        "or an earlier stage",
        from, reached, reached);
  }
  spec.mutable_replay()->set_job_id(earlier.id());
  spec.mutable_replay()->set_from_stage(from);
  return spec;
}

bool HasEnded(const v1::Job& job) { return job.has_end_time(); }

// A replay of the same kind that was interrupted; empty when there is none.
std::string Interrupted(Session& session, const v1::JobSpec& spec) {
  constexpr int kJobsLookedAt = 200;
  const absl::StatusOr<std::vector<v1::Job>> jobs = session.ListJobs(kJobsLookedAt);
  if (!jobs.ok()) return "";
  for (const v1::Job& job : *jobs) {
    if (!HasEnded(job) && job.spec().SerializeAsString() == spec.SerializeAsString()) return job.id();
  }
  return "";
}

absl::StatusOr<std::string> Begin(Session& session, const v1::JobSpec& spec, bool quiet) {
  const std::string interrupted = Interrupted(session, spec);
  if (!interrupted.empty()) {
    if (!quiet) fmt::print(stderr, "{:<12} continues replay {}, which was interrupted\n", "replay", interrupted);
    return interrupted;
  }
  const absl::StatusOr<v1::Job> created = session.CreateJob(spec);
  // The earlier job did not come so far: what was asked is not right, no file is at fault.
  if (absl::IsFailedPrecondition(created.status())) return absl::InvalidArgumentError(created.status().message());
  if (!created.ok()) return created.status();
  return created->id();
}

// A model's work is not repeated by the handbook; said before, as the difference is then no riddle.
void RemarkOnModel(const ReplayArguments& arguments, bool has_model, const ArtifactsByKind& earlier,
                   const v1::Replay& replay) {
  if (has_model || arguments.quiet || arguments.json || !arguments.orchestrator.empty()) return;
  for (const orchestrator::Stage& stage : orchestrator::Stages()) {
    const auto found = earlier.find(stage.output);
    const bool runs =
        orchestrator::StageIndex(stage.name) >= std::max(0, orchestrator::StageIndex(replay.from_stage()));
    if (!runs || found == earlier.end() || found->second.model_calls().empty()) continue;
    fmt::print(stderr, "{:<12} \"{}\" was made by {}; without --model, --llm or --replay it is made without a model\n",
               "remark", stage.name, found->second.producer().method());
    return;
  }
}

absl::Status Tell(const ReplayArguments& arguments, const v1::Job& first, const v1::Job& replay,
                  const std::vector<StageComparison>& stages) {
  if (arguments.json) {
    fmt::print("{}\n", ComparisonJson(stages, first.id(), replay.id()));
  } else {
    fmt::print("{}replay {} of {}: {}\n", arguments.quiet ? "" : ComparisonTable(stages), replay.id(), first.id(),
               ComparisonSummary(stages));
  }
  std::fflush(stdout);
  if (replay.state() != v1::JOB_STATE_SUCCEEDED) {
    const bool as_before = first.state() == replay.state() && first.stage() == replay.stage() &&
                           first.error() == replay.error() && AllAgree(stages);
    if (as_before) {
      fmt::print(stderr, "It fails as it did the first time, at \"{}\": {}\n", replay.stage(), replay.error());
      return absl::OkStatus();
    }
    return ErrorOf(replay);
  }
  return AllAgree(stages) ? absl::OkStatus() : DiffersStatus();
}

absl::Status Run(Session& session, const ReplayArguments& arguments, const v1::Job& first, const v1::JobSpec& spec,
                 bool has_model) {
  ASSIGN_OR_RETURN(const ArtifactsByKind before, StoredArtifacts(session, first));
  RemarkOnModel(arguments, has_model, before, spec.replay());
  ASSIGN_OR_RETURN(const std::string id, Begin(session, spec, arguments.quiet || arguments.json));
  absl::Status finished;
  {
    const std::unique_ptr<Progress> progress = MakeProgress(ChooseProgressForm(arguments.json, arguments.quiet));
    finished = WaitForJob(session, id, *progress);
  }
  ASSIGN_OR_RETURN(const v1::Job replay, session.GetJob(id));
  if (replay.state() != v1::JOB_STATE_SUCCEEDED && replay.state() != v1::JOB_STATE_FAILED) return finished;
  ASSIGN_OR_RETURN(const ArtifactsByKind after, StoredArtifacts(session, replay));
  if (!arguments.out.empty() && replay.state() == v1::JOB_STATE_SUCCEEDED) {
    RETURN_IF_ERROR(WriteOutputFolder(arguments.out, MakeDesignFiles(replay, after)));
  }
  return Tell(arguments, first, replay, CompareStages(first, before, replay, after));
}

absl::Status Replay(const ReplayArguments& arguments) {
  RETURN_IF_ERROR(CheckStageFlags(arguments.stages, arguments.orchestrator, arguments.llm));
  if (!arguments.from.empty() && orchestrator::StageIndex(arguments.from) < 0) {
    return InvalidArgument("--from {}: no such stage; expected one of {}", arguments.from, orchestrator::StageNames());
  }
  v1::JobSpec limits;
  RETURN_IF_ERROR(arguments.model.Set(limits));
  ASSIGN_OR_RETURN(const OptionalLlm llm,
                   ReadDesignModel(arguments.llm, limits.model_options(), arguments.orchestrator));
  if (!arguments.out.empty()) RETURN_IF_ERROR(CheckOutputFolder(arguments.out, DesignFileNames()));
  ASSIGN_OR_RETURN(std::unique_ptr<Session> session, Session::Open(arguments.orchestrator, llm, arguments.stages));
  ASSIGN_OR_RETURN(const v1::Job first, session->GetJob(arguments.job_id));
  if (!HasEnded(first)) {
    return InvalidArgument("JOB: {} has not ended yet; see: flair jobs show {}", first.id(), first.id());
  }
  ASSIGN_OR_RETURN(const v1::JobSpec spec, MakeSpec(arguments, first));
  return Run(*session, arguments, first, spec, llm.has_value());
}

}  // namespace

void AddJobs(const Commands& program) {
  const Commands jobs = program.Add("jobs", "List past and running jobs.", InSession<ListJobs, JobListArguments>);
  jobs.Add("list", "List jobs, newest first (the default).", InSession<ListJobs, JobListArguments>);
  jobs.Add("show", "Show a job.", InSession<ShowOneJob, JobArguments>);
  jobs.Add("cancel", "Cancel a job.", InSession<CancelJob, JobArguments>);
  jobs.Add("delete", "Delete a job that has ended, with the artifacts that no other job has. Files that it wrote stay.",
           InSession<DeleteJob, JobArguments>);
  jobs.Add("artifacts", "List the artifacts of a job.", InSession<ListArtifacts, JobArguments>);
}

void AddReplay(const Commands& program) {
  std::string names;
  for (const OptionName& option : OptionNames()) {
    constexpr size_t kValues = 44, kLine = 80;
    const std::string margin(kValues, ' ');
    names += fmt::format("  {:<42}{}\n", option.name, Wrapped(option.values, kLine, margin, kValues));
  }
  program.Add("replay", "Run a job again and say whether the result is the same.", Replay,
              "Exits with 0 when all stages give the same content again, or differ only because of --set; otherwise "
              "with 7.\n\nNames for --set:\n" +
                  names);
}

}  // namespace flair::cli
