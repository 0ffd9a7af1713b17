// SPDX-License-Identifier: GPL-3.0-or-later
// flair design: a room from a sentence.
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/job_options.h"
#include "cli/input/message_text.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "cli/session/session.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct DesignArguments : Options {
  using Options::Options;
  std::string& text = Text("TEXT", "What you want, such as \"A bedroom that is 4m x 5m.\"");
  std::string& out = Required("-o,--out DIR", "Folder for the results; created if missing");
  std::string& brief =
      Text("--brief FILE",
           "A whole Brief as .json, text or artifact: own room, zones, objects, constraints; TEXT replaces its text");
  std::string& room =
      Text("--room FILE",
           "Furnish this room instead of describing one: a Room as .json, .textproto or artifact (docs/rooms.md)");
  JobFlags job{command(),
               {{"brief.seed"},
                {"renderer.size", "Longer side of plan.png in pixels, 256 to 8192 (1600)"},
                {"optimizer.threads"},
                {"optimizer.restarts"},
                {"optimizer.variants",
                 "Number of visibly different layouts, 1 to 32 (1), best first: also writes layout-2.pb, ... and "
                 "variants.png"}}};
  std::vector<std::string>& views =
      Commas("--view A,B", "Further pictures in DIR: birdseye, perspective, separated by commas");
  std::string& orchestrator =
      Text("--orchestrator HOST:PORT", "Use the services of this orchestrator instead of the built-in ones");
  StageFlags stages{command()};
  LlmFlags llm{command()};
  ModelFlags model{command()};
  bool& no_completion =
      Flag("--no-completion", "Do not add relations that follow from use, such as a chair drawn up to its desk");
  bool& json = Flag("--json", "Events as JSON lines on standard output");
  bool& quiet = Flag("-q,--quiet", "Print nothing but errors", {"--json"});
};

absl::StatusOr<v1::JobSpec> MakeSpec(const DesignArguments& arguments) {
  v1::JobSpec spec;
  if (arguments.text.empty() && arguments.brief.empty()) {
    return absl::InvalidArgumentError("brief.text: is empty: give TEXT or --brief; flair design --help says more");
  }
  if (!arguments.brief.empty()) {
    ASSIGN_OR_RETURN(*spec.mutable_brief(), ReadBrief("--brief", arguments.brief));
  }
  if (!arguments.text.empty()) spec.mutable_brief()->set_text(OneLine(arguments.text));
  if (!arguments.room.empty()) {
    ASSIGN_OR_RETURN(*spec.mutable_brief()->mutable_room(), ReadRoom(arguments.room));
  }
  spec.set_no_completion(arguments.no_completion);
  spec.mutable_model_options();
  RETURN_IF_ERROR(arguments.job.Set(spec));
  RETURN_IF_ERROR(arguments.model.Set(spec));
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
    fmt::print(stdout, "{}\n", JsonText(done));
    return;
  }
  if (arguments.quiet) return;
  for (const std::string& line : NotAsAsked(layout.solved_layout())) fmt::print(stderr, "not as asked {}\n", line);
  constexpr size_t kShownWrongs = 5;
  const v1::LayoutMetrics& metrics = layout.solved_layout().metrics();
  for (const std::string& line : WrongInWords(metrics, kShownWrongs)) fmt::print(stderr, "wrong        {}\n", line);
  if (const std::string uses = UsesInWords(metrics); !uses.empty()) fmt::print(stderr, "uses         {}\n", uses);
  ShowUsage(usage);
  fmt::print(stderr, "Done: {}/plan.png, and the reasons in {}/report.md\n", arguments.out, arguments.out);
}

// The further layouts of --variants, and a picture of all of them.
absl::Status AddVariants(const DesignArguments& arguments, const v1::JobSpec& spec, const v1::Artifact& layout,
                         std::vector<OutputFile>& files) {
  const int wanted = spec.solve_options().variant_count();
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
  RETURN_IF_ERROR(CheckStageFlags(arguments.stages, arguments.orchestrator, arguments.llm));
  ASSIGN_OR_RETURN(const v1::JobSpec spec, MakeSpec(arguments));
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadDesignModel(arguments.llm, spec.model_options(), arguments.orchestrator));
  RETURN_IF_ERROR(CheckOutputFolder(arguments.out, DesignFileNames()));
  ASSIGN_OR_RETURN(std::unique_ptr<Session> session, Session::Open(arguments.orchestrator, llm, arguments.stages));
  ASSIGN_OR_RETURN(const v1::Job created, session->CreateJob(spec));
  absl::Status finished;
  {
    // Without the user and password that it may hold.
    const std::string url = llm.has_value() ? llm->base_url() : "";
    const std::unique_ptr<Progress> progress =
        MakeProgress(ChooseProgressForm(arguments.json, arguments.quiet), url.substr(url.rfind('@') + 1));
    finished = WaitForJob(*session, created.id(), *progress);
  }
  if (!finished.ok()) {
    if (!arguments.json && !arguments.quiet) ShowSpent(*session, created.id());
    return finished;
  }
  ASSIGN_OR_RETURN(const v1::Job job, session->GetJob(created.id()));
  ASSIGN_OR_RETURN(const ArtifactsByKind artifacts, CollectArtifacts(*session, job));
  std::vector<OutputFile> files = MakeDesignFiles(job, artifacts);
  ASSIGN_OR_RETURN(
      const std::vector<OutputFile> views,
      DrawViews(arguments.views, {.address = arguments.stages.addresses.renderer(), .asset_folder = {}},
                artifacts.at(v1::ARTIFACT_KIND_SOLVED_LAYOUT), spec.brief(), arguments.json || arguments.quiet));
  files.insert(files.end(), views.begin(), views.end());
  RETURN_IF_ERROR(AddVariants(arguments, spec, artifacts.at(v1::ARTIFACT_KIND_SOLVED_LAYOUT), files));
  RETURN_IF_ERROR(WriteOutputFolder(arguments.out, files));
  ShowEnd(arguments, job, artifacts);
  return absl::OkStatus();
}

}  // namespace

void AddDesign(const Commands& program) {
  program.Add("design", "Design a room from a sentence.", Design,
              "DIR gets plan.png, the pictures of --view, report.md and each stage's artifact as .pb and .json. It is "
              "written at the end, completely or not at all; other files in it stay. After an interruption, repeat the "
              "command: finished stages are not run again.");
}

}  // namespace flair::cli
