// SPDX-License-Identifier: GPL-3.0-or-later
// flair batch: many briefs, started, watched and collected.
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "CLI/CLI.hpp"
#include "cli/batch/batch_input.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/kept_files.h"
#include "cli/commands/batch_flags.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/input/option_path.h"
#include "cli/input/render_flags.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BatchArguments {
  std::string briefs;
  std::string out;
  std::string name;
  std::optional<int64_t> seed;
  int seed_count = 1;
  std::vector<std::string> views;
  std::optional<int> variants;
  std::optional<int> threads;
  std::optional<int> restarts;
  std::optional<int> size_px;
  std::vector<std::string> options;
  ModelFlags model;
  std::string kept = KeptFiles::kDefault;
  int shard_size = 0;
  BatchFlags flags;
  bool submit_only = false;
  bool json = false;
  bool quiet = false;
};

// What lines take that do not say otherwise.
absl::StatusOr<v1::JobSpec> MakeDefaults(const BatchArguments& arguments) {
  v1::JobSpec spec;
  if (arguments.seed) spec.mutable_brief()->set_seed(*arguments.seed);
  if (arguments.variants) spec.mutable_solve_options()->set_variant_count(*arguments.variants);
  if (arguments.restarts) spec.mutable_solve_options()->set_max_restart_count(*arguments.restarts);
  // Many jobs at once use the cores better than many threads of one.
  spec.mutable_solve_options()->set_thread_count(arguments.threads.value_or(1));
  if (arguments.size_px) spec.mutable_render_options()->set_size_px(*arguments.size_px);
  *spec.mutable_model_options() = MakeModelOptions(arguments.model);
  for (const std::string& option : arguments.options) {
    RETURN_IF_ERROR(SetOption(option, spec).status());
  }
  std::vector<v1::RenderOptions> views;
  for (const std::string& name : arguments.views) {
    ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(name));
    views.push_back(spec.render_options());
    views.back().set_view(view);
  }
  SetViews(views, spec);
  v1::JobSpec example = spec;
  example.mutable_brief()->set_text("A room.");
  RETURN_IF_ERROR(Validate(example));
  return spec;
}

// Whether the folder is free for this request: new, or of the same one.
absl::Status CheckFolder(BatchFolder& folder, const std::string& request_id) {
  ASSIGN_OR_RETURN(const BatchPlace place, folder.Place());
  ASSIGN_OR_RETURN(const std::string known, folder.results().State("request_id"));
  if (place.batch_id.empty() || known == request_id) return absl::OkStatus();
  if (known.empty()) {
    return FileError(fmt::format("{}: collects batch {}, which was submitted elsewhere; give --out another folder",
                                 folder.path().string(), place.batch_id));
  }
  return FileError(
      fmt::format("{}: holds batch {} of other briefs or options; give --out another folder, or what it was made with",
                  folder.path().string(), place.batch_id));
}

absl::Status RememberPlace(const BatchArguments& arguments, const v1::Batch& batch, const std::string& kept,
                           BatchFolder& folder) {
  ASSIGN_OR_RETURN(const BatchPlace before, folder.Place());
  if (!before.batch_id.empty() && before.batch_id != batch.id()) {
    return FileError(
        fmt::format("{}: holds batch {}, but here these briefs are batch {}; say where it is as before "
                    "(--orchestrator, --engine, FLAIR_HOME), or give --out another folder",
                    folder.path().string(), before.batch_id, batch.id()));
  }
  BatchPlace place;
  place.batch_id = batch.id();
  place.label = batch.label();
  FillPlace(arguments.flags, place);
  place.kept = kept;
  place.shard_size = arguments.shard_size;
  return folder.SetPlace(place);
}

absl::Status Submit(const BatchArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::JobSpec defaults, MakeDefaults(arguments));
  ASSIGN_OR_RETURN(const KeptFiles kept, KeptFiles::Parse(arguments.kept));
  absl::Status status = CheckStageFlags(arguments.flags.stages, arguments.flags.orchestrator, arguments.flags.llm);
  if (!status.ok()) return status;
  const absl::StatusOr<OptionalLlm> llm =
      ReadDesignModel(arguments.flags.llm, arguments.model, arguments.flags.orchestrator);
  if (!llm.ok()) return llm.status();
  Interruption interruption;
  // A name of its own: another process may be reading its copy.
  const std::filesystem::path copy = std::filesystem::path(arguments.out) / fmt::format("input-{}.jsonl", ::getpid());
  ASSIGN_OR_RETURN(const BatchInput input, OpenBatchInput(arguments.briefs, copy, interruption.stop()));
  ASSIGN_OR_RETURN(const std::unique_ptr<BatchFolder> folder, BatchFolder::Hold(arguments.out));
  const std::string label = arguments.name.empty() ? input.name : arguments.name;
  Submission::Options options{.defaults = defaults, .seed_count = arguments.seed_count, .folder = folder->path()};
  const std::string request_id = Submission::RequestId(input, options, arguments.name);
  if (status = CheckFolder(*folder, request_id); !status.ok()) return status;
  ASSIGN_OR_RETURN(BatchWay way, OpenBatchWay(arguments.flags, !arguments.submit_only, *llm, interruption));
  ASSIGN_OR_RETURN(const v1::Batch batch, way.batches->CreateBatch(request_id, label));
  if (batch.state() == v1::BATCH_STATE_CANCELLED) {
    return EndWith(kExitCancelled,
                   fmt::format("these briefs are batch {}, which was cancelled; to run them all the same "
                               "give the batch another --name",
                               batch.id()));
  }
  status = RememberPlace(arguments, batch, kept.Words(), *folder);
  if (status.ok()) status = folder->results().SetState("request_id", request_id);
  if (!status.ok()) return status;
  if (!arguments.quiet) {
    fmt::print(stderr, "batch {}{}\n", batch.id(), batch.job_count() > 0 ? ", which is known and goes on" : "");
  }
  Submission submission(*way.batches, folder->results(), input, options);
  status = RunBatch(
      batch, *way.batches, *folder, &submission, interruption,
      {.remedy = way.remedy, .submit_only = arguments.submit_only, .quiet = arguments.quiet, .json = arguments.json});
  std::error_code ignored;
  std::filesystem::remove(copy, ignored);  // of standard input, which is given again where it is needed again
  if (status.ok() && arguments.submit_only && !arguments.quiet) {
    fmt::print(stderr, "{} submitted, {} rejected; to collect: flair batch watch {}\n",
               Counted(submission.submitted_count(), "job"), Counted(submission.rejected_count(), "line"),
               arguments.out);
  }
  return status;
}

void AddSpecFlags(CLI::App& command, BatchArguments& arguments) {
  constexpr char kGroup[] = "For lines that do not say otherwise";
  command.add_option("--seed", arguments.seed, "Seed (0)")->type_name("N")->check(Seed())->group(kGroup);
  command
      .add_option("--seeds", arguments.seed_count,
                  "Jobs of each line, with the seeds N, N + 1, ... of its own one, 1 to 500 (1)")
      ->type_name("COUNT")
      ->check(WholeNumber(1, 500))
      ->group(kGroup);
  command.add_option("--view", arguments.views, "Pictures: plan, birdseye, perspective, with a comma between (plan)")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false)  // what follows is the file
      ->group(kGroup);
  command
      .add_option("--size", arguments.size_px,
                  "Longer side of the pictures in pixels, 256 to 8192 (plan 1600, views 1024)")
      ->type_name("PX")
      ->check(WholeNumber(256, 8192))
      ->group(kGroup);
  command.add_option("--variants", arguments.variants, "Layouts that differ visibly, 1 to 32 (1)")
      ->type_name("K")
      ->check(WholeNumber(1, 32))
      ->group(kGroup);
  command
      .add_option("--restarts", arguments.restarts,
                  "Most restarts per stage of the solver, 1 to 10000 (by the stage's size)")
      ->type_name("N")
      ->check(WholeNumber(1, 10000))
      ->group(kGroup);
  command.add_option("--threads", arguments.threads, "Threads of each solve, 1 to 256 (1); changes no result")
      ->type_name("N")
      ->check(WholeNumber(1, 256))
      ->group(kGroup);
  command.add_option("--set", arguments.options, "Any other option, as for flair replay: optimizer.path_width=0.7")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->group(kGroup);
}

void AddResultFlags(CLI::App& command, BatchArguments& arguments) {
  command.add_option("BRIEFS", arguments.briefs, "A file with a brief a line, or - for standard input")
      ->type_name("FILE");
  command.add_option("-o,--out", arguments.out, "Folder for the results; made when missing")->type_name("DIR");
  command
      .add_option(
          "--keep", arguments.kept,
          "Files of each job: brief, room, ..., graph, layout, pictures, report, report.md, all, none; NAME.json "
          "for JSON (layout,pictures,report)")
      ->type_name("A,B");
  command
      .add_option("--shards", arguments.shard_size,
                  "Tar files of so many jobs, 1 to 1000000, instead of a folder for each job")
      ->type_name("JOBS")
      ->check(WholeNumber(1, 1000000));
  command
      .add_option("--name", arguments.name, "What you call the batch (the file's name); another name, another batch")
      ->type_name("NAME");
  command.add_flag("--submit-only", arguments.submit_only, "Submit the lines and do not wait for results");
}

}  // namespace

void AddBatch(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BatchArguments>();
  CLI::App* command = program.add_subcommand("batch", "Design rooms from a file of briefs, on one machine or many.");
  command->require_subcommand(0, 1);
  AddResultFlags(*command, *arguments);
  AddSpecFlags(*command, *arguments);
  AddBatchFlags(*command, arguments->flags, true);
  AddModelFlags(*command, arguments->model);
  command->add_flag("--json", arguments->json, "The summary as JSON on standard output");
  command->add_flag("-q,--quiet", arguments->quiet, "Print nothing unless something goes wrong");
  AddBatchActions(*command, result);
  command->footer(
      "A line is a sentence, or a JSON object with the fields of a Brief and id, variants, views, solve, "
      "render, models:\n"
      "    A bedroom that is 4m x 5m.\n"
      "    {\"id\": \"k17\", \"text\": \"A small kitchen.\", \"views\": [\"plan\", \"birdseye\"]}\n"
      "DIR gets a folder for each job under jobs/ (or shards/), results.db with a row for each job, and "
      "rejected.jsonl with the lines that are no briefs. After ^C or a crash the same command continues where "
      "it stopped; the same file with the same options is the same batch. ID is the batch's id, the beginning "
      "of it, or DIR. See docs/batches.md.");
  command->callback([arguments, command, &result] {
    if (!command->get_subcommands().empty()) return;
    if (arguments->briefs.empty()) throw CLI::RequiredError("BRIEFS, or one of the subcommands,");
    if (arguments->out.empty()) throw CLI::RequiredError("--out");
    result = Submit(*arguments);
    std::fflush(stdout);
  });
}

}  // namespace flair::cli
