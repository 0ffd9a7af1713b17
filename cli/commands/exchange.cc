// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev import and flair-dev export: to and from the format of the released implementation, and what a model once
// wrote for a room as a folder of answers that a design replays.
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/bench/bench.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/recorded/import_answers.h"
#include "llm/wrappers/llm_wrappers.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/validation/validate.h"
#include "translator_worker/model/model_translator.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ImportFlairGptArguments : Options {
  using Options::Options;
  std::string& in = Required("ROOM", "Its .json");
  std::string& out = Required("-o,--out FILE", "Where the graph (.pb) goes");
  bool& complete = Flag("--complete", "Add relations that follow from use, as a design does");
};

absl::Status ImportFlairGpt(const ImportFlairGptArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string text, ReadFile(arguments.in));
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  absl::StatusOr<v1::LayoutGraph> graph = evaluation::ReadFlairGptRoom(text);
  if (!graph.ok()) return InvalidArgument("{}: {}", arguments.in, graph.status().message());
  if (arguments.complete) RETURN_IF_ERROR(CompleteGraph(*graph));
  if (const absl::Status good = Validate(*graph); !good.ok()) {
    return InvalidArgument("{}: not a graph that can be solved: {}", arguments.in, good.message());
  }
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, GraphArtifactBytes(*graph, "import flairgpt", runtime::BuildName())));
  for (const v1::Diagnostic& diagnostic : graph->diagnostics())
    fmt::print(stderr, "left out: {}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {}, {} left out\n", arguments.out, Counted(graph->object_list().objects_size(), "object"),
             Counted(graph->edges_size(), "constraint"), Counted(graph->diagnostics_size(), "call"));
  fmt::print(stderr, "next       flair solve {} --out layout.pb --stats\n", arguments.out);
  return absl::OkStatus();
}

struct ExportFlairGptArguments : Options {
  using Options::Options;
  std::string& in = Required("LAYOUT", "A layout: layout.pb or layout.json of a design");
  std::string& out = Required("-o,--out FILE", "Where the .json goes");
  std::string& name = Text("--name", "Name of the problem (that of FILE)");
};

absl::Status ExportFlairGpt(const ExportFlairGptArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, ReadArtifact(arguments.in));
  if (!artifact.has_solved_layout()) {
    return InvalidArgument("{}: not a layout; give a layout.pb of flair solve", arguments.in);
  }
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  const std::string name =
      arguments.name.empty() ? std::filesystem::path(arguments.out).stem().string() : arguments.name;
  // How long somebody took is not in a layout.
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, evaluation::WriteFlairGptLayout(artifact.solved_layout(), name, 0)));
  fmt::print(stderr, "{}: poses of {}, named \"{}\"\n", arguments.out,
             Counted(artifact.solved_layout().placements_size(), "object"), name);
  return absl::OkStatus();
}

namespace fs = std::filesystem;

struct ImportAnswersArguments : Options {
  using Options::Options;
  std::string& room = Required("ROOM", "The room's .json, of the released implementation");
  std::string& out = Required("-o,--out DIR", "Folder for the answers and their brief; created if missing");
};

constexpr char kBriefFile[] = "brief.json";
constexpr char kRemarksFile[] = "remarks.txt";

// A folder for the answers while they are made; removed with them.
class WorkFolder {
 public:
  absl::Status Make() {
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "flair-import-XXXXXX").string();
    if (error || mkdtemp(pattern.data()) == nullptr) return FileError(pattern + ": no temporary folder can be made");
    path_ = pattern;
    return absl::OkStatus();
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

  // What is in it, by name.
  absl::StatusOr<std::vector<OutputFile>> Files() const {
    std::vector<OutputFile> files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_, error)) {
      ASSIGN_OR_RETURN(std::string content, ReadFile(entry.path()));
      files.push_back({entry.path().filename().string(), std::move(content)});
    }
    std::ranges::sort(files, [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
    return files;
  }

 private:
  std::string path_;
};

// Answers of two recordings do not mix: a folder of another one is refused.
absl::Status CheckFolder(const ImportAnswersArguments& arguments, const language::RecordedRoom& room,
                         const language::Handbook& handbook) {
  const absl::StatusOr<std::string> there = llm::AnswerFolder(arguments.out).Identity();
  const std::string identity = language::RecordedRoomClient(room, handbook).identity();
  if (there.ok() && *there != identity) {
    return FailedPrecondition("{}: holds answers of \"{}\", not of \"{}\"; choose another folder", arguments.out,
                              *there, identity);
  }
  // The same recording again replaces its own files.
  if (there.ok()) return CheckOutputFolder(arguments.out, {});
  return CheckOutputFolder(arguments.out, {kBriefFile, kRemarksFile});
}

// Asks the translation's questions too, so that the folder has all answers of a design.
absl::Status ImportTranslation(const language::RecordedRoom& room, const language::Handbook& handbook,
                               const std::string& folder, language::ImportedAnswers& imported) {
  auto recorded = std::make_unique<language::RecordedRoomClient>(room, handbook);
  const language::RecordedRoomClient& client = *recorded;
  ASSIGN_OR_RETURN(std::unique_ptr<llm::LlmClient> recording, llm::MakeRecordingClient(std::move(recorded), folder));
  ASSIGN_OR_RETURN(const auto translator,
                   translator::ModelTranslator::Make(std::move(recording), translator::DefaultPromptFolder(), {}));
  v1::TranslateRequest request;
  request.set_request_id("import");
  *request.mutable_room() = imported.room;
  *request.mutable_zone_plan() = imported.zones;
  *request.mutable_object_list() = imported.objects;
  *request.mutable_constraint_list() = imported.completed;
  *request.mutable_catalog() = optimizer::MakeCatalog();
  runtime::CallContext call;
  ASSIGN_OR_RETURN(const v1::TranslateResponse response, translator->Translate(request, call));
  imported.calls.insert(imported.calls.end(), response.model_calls().begin(), response.model_calls().end());
  for (auto& [step, conversion] : client.conversions()) imported.conversions[step] = conversion;
  return absl::OkStatus();
}

std::string RemarksText(const language::ImportedAnswers& imported) {
  std::string text;
  for (const auto& [step, conversion] : imported.conversions) {
    for (const language::ConversionRemark& remark : conversion.remarks) {
      const std::string place = remark.line > 0 ? fmt::format(", line {}", remark.line) : "";
      text += fmt::format("{}{} ({}): {}\n", remark.source, place, remark.reason, remark.text);
    }
  }
  return text;
}

// What a person wants to know at the end.
void ShowEnd(const ImportAnswersArguments& arguments, const language::ImportedAnswers& imported) {
  language::Conversion all;
  for (const auto& [step, conversion] : imported.conversions) {
    if (!step.starts_with("translation.")) all.Add(conversion);
  }
  int64_t tokens = 0;
  for (const v1::ModelCall& call : imported.calls) {
    tokens += call.usage().input_token_count() + call.usage().output_token_count();
  }
  fmt::print(stderr, "{}: {}, {}; {} of {} converted, the others are in {}\n", arguments.out,
             Counted(imported.objects.objects_size(), "object"),
             Counted(imported.constraints.sentences_size(), "sentence"), all.converted, Counted(all.lines, "line"),
             kRemarksFile);
  for (const auto& [step, conversion] : imported.conversions) {
    if (!step.starts_with("translation.") || conversion.lines == 0) continue;
    fmt::print(stderr, "{}: {} of {} to a sentence\n", step, conversion.converted,
               Counted(conversion.lines, "recorded call belongs", "recorded calls belong"));
  }
  fmt::print(stderr, "{}, about {}\n", Counted(std::ssize(imported.calls), "question"), Counted(tokens, "token"));
  fmt::print(stderr, "next       flair design --brief {0}/{1} --replay {0} --out DIR\n", arguments.out, kBriefFile);
}

absl::Status ImportAnswersOf(const ImportAnswersArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string text, ReadFile(arguments.room));
  const absl::StatusOr<language::RecordedRoom> room = language::ReadRecordedRoom(text);
  if (!room.ok()) return InvalidArgument("{}: {}", arguments.room, room.status().message());
  ASSIGN_OR_RETURN(const auto handbook, language::LoadHandbook(language::DefaultHandbookFolder()));
  ASSIGN_OR_RETURN(const auto prompts,
                   llm::PromptLibrary::Load(language::DefaultPromptsFolder(), {}, language::LanguagePrompts()));
  RETURN_IF_ERROR(CheckFolder(arguments, *room, *handbook));
  WorkFolder work;
  RETURN_IF_ERROR(work.Make());
  ASSIGN_OR_RETURN(language::ImportedAnswers imported, language::ImportAnswers(*room, *handbook, prompts, work.path()));
  RETURN_IF_ERROR(ImportTranslation(*room, *handbook, work.path(), imported));
  ASSIGN_OR_RETURN(std::vector<OutputFile> files, work.Files());
  files.push_back({kBriefFile, ToJson(room->brief)});
  files.push_back({kRemarksFile, RemarksText(imported)});
  RETURN_IF_ERROR(WriteOutputFolder(arguments.out, files));
  ShowEnd(arguments, imported);
  return absl::OkStatus();
}

}  // namespace

void AddImport(const Commands& program) {
  const Commands import = program.Group("import", "Import problems of other systems as graphs.");
  import.Add("flairgpt", "Import a recorded problem of the released implementation.", ImportFlairGpt);
  import.Add("answers", "Import what a model wrote for a recorded room, as answers that a design can replay.",
             ImportAnswersOf,
             "DIR gets one file for each question with its answer, brief.json, and remarks.txt with every line of "
             "the recorded texts that has no place in a typed answer, and why. The answers belong to the prompts, "
             "the handbook and the catalogue of this version.");
}

void AddExportFlairGpt(const Commands& program) {
  program.Group("export", "Export layouts in the format of the released implementation.")
      .Add("flairgpt", "Export poses as the released implementation writes them.", ExportFlairGpt);
}

}  // namespace flair::cli
