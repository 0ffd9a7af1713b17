// SPDX-License-Identifier: GPL-3.0-or-later
// flair replay: a job once more, and whether it comes to the same.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/llm_flags.h"
#include "cli/input/option_path.h"
#include "cli/input/service_flags.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "cli/replay/comparison.h"
#include "cli/session/finished_job.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct ReplayArguments {
  std::string job_id;
  std::string from;
  std::vector<std::string> options;
  std::string out;
  std::string orchestrator;
  StageFlags stages;
  LlmFlags llm;
  ModelFlags model;
  bool json = false;
  bool quiet = false;
};

// Applies the options of --set and says from which stage on they matter; from the first when there are none.
absl::StatusOr<std::string_view> SetOptions(const std::vector<std::string>& options, v1::JobSpec& spec) {
  int first = static_cast<int>(orchestrator::Stages().size());
  for (const std::string& option : options) {
    ASSIGN_OR_RETURN(const std::string_view stage, SetOption(option, spec));
    first = std::min(first, orchestrator::StageIndex(stage));
  }
  absl::Status status = Validate(spec.solve_options(), "--set optimizer");
  if (status.ok()) status = Validate(spec.render_options(), "--set renderer");
  if (status.ok()) status = Validate(spec, "--set");
  if (!status.ok()) return status;
  return options.empty() ? "" : orchestrator::Stages()[static_cast<size_t>(first)].name;
}

absl::StatusOr<v1::JobSpec> MakeSpec(const ReplayArguments& arguments, const v1::Job& earlier) {
  v1::JobSpec spec = earlier.spec();
  spec.mutable_model_options()->MergeFrom(MakeModelOptions(arguments.model));
  ASSIGN_OR_RETURN(const std::string_view reached, SetOptions(arguments.options, spec));
  const std::string from = arguments.from.empty() ? std::string(reached) : arguments.from;
  if (!reached.empty() && orchestrator::StageIndex(from) > orchestrator::StageIndex(reached)) {
    return absl::InvalidArgumentError(fmt::format(
        "--from {}: the options of --set reach \"{}\", which would be taken from the earlier job; --from {} "
        "or an earlier stage",
        from, reached, reached));
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
    if (!quiet) fmt::print(stderr, "{:<12} goes on with replay {}, which was interrupted\n", "replay", interrupted);
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
      fmt::print(stderr, "It fails as the first time, at \"{}\": {}\n", replay.stage(), replay.error());
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
  if (absl::Status status = CheckStageFlags(arguments.stages, arguments.orchestrator, arguments.llm); !status.ok()) {
    return status;
  }
  if (!arguments.from.empty() && orchestrator::StageIndex(arguments.from) < 0) {
    return absl::InvalidArgumentError(
        fmt::format("--from {}: there is no such stage; one of {}", arguments.from, orchestrator::StageNames()));
  }
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadDesignModel(arguments.llm, arguments.model, arguments.orchestrator));
  if (!arguments.out.empty()) {
    RETURN_IF_ERROR(CheckOutputFolder(arguments.out, DesignFileNames()));
  }
  ASSIGN_OR_RETURN(std::unique_ptr<Session> session, Session::Open(arguments.orchestrator, llm, arguments.stages));
  ASSIGN_OR_RETURN(const v1::Job first, session->GetJob(arguments.job_id));
  if (!HasEnded(first)) {
    return absl::InvalidArgumentError(
        fmt::format("JOB: {} has not ended yet; see: flair jobs show {}", first.id(), first.id()));
  }
  ASSIGN_OR_RETURN(const v1::JobSpec spec, MakeSpec(arguments, first));
  return Run(*session, arguments, first, spec, llm.has_value());
}

}  // namespace

void AddReplay(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = program.add_subcommand("replay", "Run a job again and say whether the result is the same.");
  command->add_option("JOB", arguments->job_id, "Id of the job, as flair jobs prints it")->required();
  command
      ->add_option("--from", arguments->from,
                   "Run from this stage on, take the rest from JOB: brief, room, zones, objects, style, constraints, "
                   "cleaning, translation, solve, render (all; with --set, the first that the options reach)")
      ->type_name("STAGE");
  command
      ->add_option("--set", arguments->options,
                   "Another option than JOB had, such as optimizer.restarts=500; \"NAME=\" for the default; again for "
                   "more")
      ->type_name("NAME=VALUE");
  command->add_option("-o,--out", arguments->out, "Also write what flair design writes to this folder")
      ->type_name("DIR");
  command->add_option("--orchestrator", arguments->orchestrator, "A job of this one, not of the local store")
      ->type_name("HOST:PORT");
  AddStageFlags(*command, arguments->stages);
  AddLlmFlags(*command, arguments->llm);
  AddModelFlags(*command, arguments->model);
  CLI::Option* json =
      command->add_flag("--json", arguments->json, "Events, then the comparison, as JSON lines on standard output");
  command->add_flag("-q,--quiet", arguments->quiet, "One line only")->excludes(json);
  std::string names;
  for (const OptionName& option : OptionNames()) {
    constexpr size_t kValues = 44, kLine = 80;
    const std::string margin(kValues, ' ');
    names += fmt::format("  {:<42}{}\n", option.name, Wrapped(option.values, kLine, margin, kValues));
  }
  command->footer(
      "Ends with 0 when all stages give the same content again, or another where --set asks for it; with 7 "
      "when one differs that should not.\n\nNames for --set:\n" +
      names);
  command->callback([arguments, &result] { result = Replay(*arguments); });
}

}  // namespace flair::cli
