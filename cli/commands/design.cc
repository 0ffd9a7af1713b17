// SPDX-License-Identifier: GPL-3.0-or-later
// flair design: a room from a sentence.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/command_line.h"
#include "cli/input/llm_flags.h"
#include "cli/input/message_words.h"
#include "cli/input/room_file.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/models_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/progress/progress.h"
#include "cli/session/finished_job.h"
#include "cli/session/pictures.h"
#include "cli/session/session.h"
#include "cli/session/variants.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/pipeline/summary.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct DesignArguments {
  std::string text;
  std::string out;
  std::optional<int64_t> seed;
  std::string orchestrator;
  StageFlags stages;
  std::string brief;
  std::string room;
  LlmFlags llm;
  ModelFlags model;
  std::optional<int> size_px;
  std::optional<int> threads;
  std::optional<int> restarts;
  std::optional<int> variants;
  std::vector<std::string> views;
  bool json = false;
  bool quiet = false;
};

absl::StatusOr<v1::JobSpec> MakeSpec(const DesignArguments& arguments) {
  v1::JobSpec spec;
  if (!arguments.brief.empty()) {
    ASSIGN_OR_RETURN(v1::Brief brief, ReadBrief("--brief", arguments.brief));
    *spec.mutable_brief() = std::move(brief);
  }
  if (!arguments.text.empty()) spec.mutable_brief()->set_text(OneLine(arguments.text));
  if (arguments.seed) spec.mutable_brief()->set_seed(*arguments.seed);
  if (!arguments.room.empty()) {
    ASSIGN_OR_RETURN(const v1::Room room, ReadRoom(arguments.room));
    *spec.mutable_brief()->mutable_room() = room;
  }
  if (arguments.threads) spec.mutable_solve_options()->set_thread_count(*arguments.threads);
  if (arguments.restarts) spec.mutable_solve_options()->set_max_restart_count(*arguments.restarts);
  if (arguments.variants) spec.mutable_solve_options()->set_variant_count(*arguments.variants);
  if (arguments.size_px) spec.mutable_render_options()->set_size_px(*arguments.size_px);
  *spec.mutable_model_options() = MakeModelOptions(arguments.model);
  RETURN_IF_ERROR(Validate(spec.brief()));
  RETURN_IF_ERROR(Validate(spec));
  return spec;
}

void ShowUsage(const v1::ModelUsage& usage) {
  if (usage.call_count() == 0) return;
  fmt::print(stderr, "{:<12} {}, {}\n", "models", Counted(usage.call_count(), "call"),
             orchestrator::SummarizeUsage(usage));
}

// What a design that failed has cost in the stages that it finished; says nothing when that cannot be known.
void ShowSpent(Session& session, const std::string& id) {
  const absl::StatusOr<v1::Job> job = session.GetJob(id);
  if (!job.ok()) return;
  ArtifactsByKind artifacts;
  for (const v1::ArtifactRef& ref : job->artifacts()) {
    absl::StatusOr<v1::Artifact> artifact = session.GetArtifact(ref.id());
    if (artifact.ok()) artifacts[ref.kind()] = *std::move(artifact);
  }
  ShowUsage(UsageOf(artifacts));
}

// What a person wants to know at the end.
void ShowEnd(const DesignArguments& arguments, const v1::Job& job, const ArtifactsByKind& artifacts) {
  const v1::Artifact& layout = artifacts.at(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  const v1::ModelUsage usage = UsageOf(artifacts);
  if (arguments.json) {
    nlohmann::json done = {{"job_id", job.id()}, {"layout_id", layout.id()}, {"out", arguments.out}};
    if (usage.call_count() > 0) done["model_usage"] = nlohmann::json::parse(ToJsonLine(usage), nullptr, false);
    fmt::print(stdout, "{}\n", done.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  if (arguments.quiet) return;
  for (const std::string& line : NotAsAsked(layout.solved_layout())) fmt::print(stderr, "not as asked {}\n", line);
  ShowUsage(usage);
  fmt::print(stderr, "Done: {}/plan.png, and the reasons in {}/report.md\n", arguments.out, arguments.out);
}

// The further layouts of --variants, and a picture of all of them.
absl::Status AddVariants(const DesignArguments& arguments, const v1::JobSpec& spec, const v1::Artifact& layout,
                         std::vector<OutputFile>& files) {
  const int wanted = arguments.variants.value_or(1);
  if (wanted <= 1) return absl::OkStatus();
  ASSIGN_OR_RETURN(const std::vector<OutputFile> variants,
                   MakeVariantFiles(layout, spec.solve_options(),
                                    {.address = arguments.stages.addresses.renderer(), .asset_folder = {}}));
  files.insert(files.end(), variants.begin(), variants.end());
  if (arguments.json || arguments.quiet) return absl::OkStatus();
  // The picture is one of the files, and the best layout none.
  if (std::ssize(variants) < wanted) {
    fmt::print(stderr, "{:<12} {}\n", "variants", FewerVariants(variants.size(), wanted));
  }
  fmt::print(
      stderr, "{:<12} layout.pb{} in {}/{}\n", "variants",
      variants.size() > 1 ? fmt::format(" to {}", VariantPath("layout.pb", static_cast<int>(variants.size()))) : "",
      arguments.out, kVariantsPicture);
  return absl::OkStatus();
}

absl::Status Design(const DesignArguments& arguments) {
  RETURN_IF_ERROR(CheckViews(arguments.views));
  absl::Status stages = CheckStageFlags(arguments.stages, arguments.orchestrator, arguments.llm);
  if (!stages.ok()) return stages;
  ASSIGN_OR_RETURN(const v1::JobSpec spec, MakeSpec(arguments));
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadDesignModel(arguments.llm, arguments.model, arguments.orchestrator));
  RETURN_IF_ERROR(CheckOutputFolder(arguments.out, DesignFileNames()));
  ASSIGN_OR_RETURN(std::unique_ptr<Session> session, Session::Open(arguments.orchestrator, llm, arguments.stages));
  ASSIGN_OR_RETURN(const v1::Job created, session->CreateJob(spec));
  absl::Status finished;
  {
    const std::unique_ptr<Progress> progress = MakeProgress(ChooseProgressForm(arguments.json, arguments.quiet));
    finished = WaitForJob(*session, created.id(), *progress);
  }
  if (!finished.ok()) {
    if (!arguments.json && !arguments.quiet) ShowSpent(*session, created.id());
    return finished;
  }
  ASSIGN_OR_RETURN(const v1::Job job, session->GetJob(created.id()));
  ASSIGN_OR_RETURN(const ArtifactsByKind artifacts, CollectArtifacts(*session, job));
  std::vector<OutputFile> files = MakeDesignFiles(job, artifacts);
  absl::StatusOr<std::vector<OutputFile>> views =
      DrawViews(arguments.views, {.address = arguments.stages.addresses.renderer(), .asset_folder = {}},
                artifacts.at(v1::ARTIFACT_KIND_SOLVED_LAYOUT), spec.brief(), arguments.json || arguments.quiet);
  if (!views.ok()) return views.status();
  files.insert(files.end(), std::make_move_iterator(views->begin()), std::make_move_iterator(views->end()));
  RETURN_IF_ERROR(AddVariants(arguments, spec, artifacts.at(v1::ARTIFACT_KIND_SOLVED_LAYOUT), files));
  RETURN_IF_ERROR(WriteOutputFolder(arguments.out, files));
  ShowEnd(arguments, job, artifacts);
  return absl::OkStatus();
}

}  // namespace

void AddDesign(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<DesignArguments>();
  CLI::App* command = program.add_subcommand("design", "Design a room from a sentence.");
  CLI::Option* text =
      command->add_option("TEXT", arguments->text, "What you want, such as \"A bedroom that is 4m x 5m.\"");
  command->add_option("-o,--out", arguments->out, "Folder for the results; made when missing")
      ->required()
      ->type_name("DIR");
  command->add_option("--seed", arguments->seed, "Another seed, another design; the same seed, the same bytes (0)")
      ->type_name("N")
      ->check(Seed());
  command
      ->add_option("--brief", arguments->brief,
                   "A whole Brief as .json, text or artifact: own room, zones, objects, constraints; TEXT goes before "
                   "its text")
      ->type_name("FILE");
  command
      ->add_option(
          "--room", arguments->room,
          "Furnish this room instead of describing one: a Room as .json, .textproto or artifact (docs/rooms.md)")
      ->type_name("FILE");
  command->add_option("--size", arguments->size_px, "Longer side of plan.png in pixels, 256 to 8192 (1600)")
      ->type_name("PX")
      ->check(WholeNumber(256, 8192));
  command
      ->add_option("--view", arguments->views, "Further pictures in DIR: birdseye, perspective, with a comma between")
      ->type_name("A,B")
      ->delimiter(',');
  command->add_option("--threads", arguments->threads, "Threads of the solver, 1 to 256 (all cores); changes no result")
      ->type_name("N")
      ->check(WholeNumber(1, 256));
  command
      ->add_option("--restarts", arguments->restarts,
                   "Most restarts per stage of the solver, 1 to 10000 (by the stage's size)")
      ->type_name("N")
      ->check(WholeNumber(1, 10000));
  command
      ->add_option(
          "--variants", arguments->variants,
          "Layouts that differ visibly, 1 to 32 (1), best first: also writes layout-2.pb, ... and variants.png")
      ->type_name("K")
      ->check(WholeNumber(1, 32));
  command
      ->add_option("--orchestrator", arguments->orchestrator,
                   "Use the services of this orchestrator instead of those in this process")
      ->type_name("HOST:PORT");
  AddStageFlags(*command, arguments->stages);
  AddLlmFlags(*command, arguments->llm);
  AddModelFlags(*command, arguments->model);
  CLI::Option* json = command->add_flag("--json", arguments->json, "Events as JSON lines on standard output");
  command->add_flag("-q,--quiet", arguments->quiet, "Print nothing unless something goes wrong")->excludes(json);
  command->footer(
      "DIR gets plan.png, the pictures of --view, report.md and each stage's artifact as .pb and .json. It "
      "is written when all is done, whole or not at all; files of other names in it stay. Run again after "
      "an interruption: finished stages are not redone.");
  command->callback([arguments, text, &result] {
    if (text->count() == 0 && arguments->brief.empty()) throw CLI::RequiredError("TEXT or --brief");
    result = Design(*arguments);
  });
}

}  // namespace flair::cli
