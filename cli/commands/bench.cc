// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench: measures solver, renderer and translator on folders of problems.
#include "cli/bench/bench.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

#include "absl/time/clock.h"
#include "cli/bench/translate_bench.h"
#include "cli/commands/commands.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/message_text.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"
#include "renderer_worker/images/image_files.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BenchArguments : Options {
  using Options::Options;
  std::string& problems = Required("DIR", "Folder (or file) of graphs, layouts or recorded FlairGPT problems");
};

// Measures every problem. Those that cannot be read or measured are named and returned.
std::vector<Record> MeasureEach(const std::vector<ProblemFile>& files,
                                const std::function<absl::Status(BenchProblem&)>& measure) {
  // The lines on standard output show how far it is, unless they go elsewhere.
  const bool show_progress = isatty(STDERR_FILENO) && !isatty(STDOUT_FILENO);
  const char* const clear_line = show_progress ? "\r\033[K" : "";
  std::vector<Record> failures;
  for (size_t i = 0; i < files.size(); ++i) {
    if (show_progress) fmt::print(stderr, "{}{}/{} {}", clear_line, i + 1, files.size(), files[i].name);
    absl::StatusOr<BenchProblem> problem = ReadBenchProblem(files[i]);
    const absl::Status status = problem.ok() ? measure(*problem) : problem.status();
    if (status.ok()) continue;
    const std::string file = files[i].path.string(), reason(status.message());
    failures.push_back({{"file", file}, {"reason", reason}});
    fmt::print(stderr, "{}{}: {}\n", clear_line, file, reason);
  }
  fmt::print(stderr, "{}", clear_line);
  return failures;
}

absl::Status AllMeasured(const std::vector<Record>& failures, const std::vector<ProblemFile>& files) {
  if (failures.empty()) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures.size(), Counted(std::ssize(files), "problem")));
}

struct BenchSolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  std::string& out = Text("-o,--out DIR", "Folder for the layouts, as .pb and in the FlairGPT format");
  std::string& json = Text("--json FILE", "Write all figures as JSON");
  std::vector<std::string>& only = List("--only NAME", "Only these problems, by file name without extension");
  int& threads = Whole("--threads N", 1, 256, 1, "Threads of the solver, 1 to 256 (1); changes no result");
  int& repeats = Whole("--repeat N", 1, 1000, 1, "Solves of each problem, 1 to 1000 (1); the median counts");
  int64_t& seed = SeedNumber("Seed; another seed gives another layout (0)");
  std::optional<int>& restarts =
      Whole("--restarts N", 1, 10000, "Maximum number of restarts per stage, 1 to 10000 (by the stage's size)");
  bool& complete = Flag("--complete", "Add relations that follow from use, as a design does");
};

// NAME.json for the judge of the reference data, NAME.pb for flair render and flair inspect.
absl::Status WriteLayout(const SolveMeasure& measure, const std::filesystem::path& folder) {
  if (folder.empty()) return absl::OkStatus();
  const std::string name = measure.record["name"];
  RETURN_IF_ERROR(WriteOutputFile(folder / (name + ".json"),
                                  evaluation::WriteFlairGptLayout(measure.layout, name, measure.record["cpu_s"])));
  return WriteOutputFile(folder / (name + ".pb"),
                         LayoutArtifactBytes(measure.layout, "bench solve", runtime::BuildName()));
}

// A folder that can be written; made when missing.
absl::Status MakeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) return absl::OkStatus();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return FileError("--out: {}: {}", folder.string(), error.message());
  return CheckOutputFile(folder / "layout.pb");
}

absl::Status KeepOnly(const std::vector<std::string>& names, std::vector<ProblemFile>& files) {
  constexpr size_t kShownNames = 10;
  for (const std::string& name : names) {
    if (std::ranges::find(files, name, &ProblemFile::name) != files.end()) continue;
    std::vector<std::string> known;
    for (const ProblemFile& file : files) known.push_back(file.name);
    return NotFound("--only: {}: no such problem in the folder; there are {}", name, ListNames(known, kShownNames));
  }
  if (names.empty()) return absl::OkStatus();
  std::erase_if(files, [&](const ProblemFile& file) { return std::ranges::find(names, file.name) == names.end(); });
  return absl::OkStatus();
}

absl::Status BenchSolve(const BenchSolveArguments& arguments) {
  ASSIGN_OR_RETURN(std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  RETURN_IF_ERROR(KeepOnly(arguments.only, files));
  RETURN_IF_ERROR(MakeFolder(arguments.out));
  RETURN_IF_ERROR(CheckOutputFile(arguments.json));
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  options.set_thread_count(arguments.threads);
  if (arguments.restarts) options.set_max_restart_count(*arguments.restarts);
  size_t name_width = 0;
  for (const ProblemFile& file : files) name_width = std::max(name_width, file.name.size());
  const TextTable table = SolveTable(name_width);
  fmt::print("{}{}", SolveLegend(), table.Header());
  const double memory_before_MiB = Memory_MiB();
  std::vector<Record> solves;
  const std::vector<Record> failures = MeasureEach(files, [&](BenchProblem& problem) {
    if (arguments.complete) RETURN_IF_ERROR(CompleteGraph(problem.graph));
    ASSIGN_OR_RETURN(const SolveMeasure measure, MeasureSolve(problem, options, arguments.repeats));
    fmt::print("{}", table.Row(SolveCells(measure.record)));
    std::fflush(stdout);
    solves.push_back(measure.record);
    return WriteLayout(measure, arguments.out);
  });
  if (!solves.empty()) fmt::print("{}", SolveSummary(solves, memory_before_MiB));
  std::fflush(stdout);
  if (!arguments.json.empty()) RETURN_IF_ERROR(WriteOutputFile(arguments.json, SolvesToJson(solves, failures)));
  if (!arguments.out.empty() && !solves.empty()) {
    fmt::print("layouts are in {0}: NAME.json for the judge, NAME.pb for flair render {0}/NAME.pb --out NAME.png\n",
               arguments.out);
  }
  return AllMeasured(failures, files);
}

struct BenchResolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  int& per_kind =
      Whole("--per-kind N", 1, 1000, 4, "Objects and constraints of a room to edit in each way, 1 to 1000 (4)");
  bool& list = Flag("--list", "List every edit");
};

absl::Status BenchResolve(const BenchResolveArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  v1::SolveOptions options;
  options.set_thread_count(1);
  std::vector<Record> all;
  const std::vector<Record> failures = MeasureEach(files, [&](const BenchProblem& problem) -> absl::Status {
    ASSIGN_OR_RETURN(const std::vector<Record> edits, MeasureResolves(problem, options, arguments.per_kind));
    all.insert(all.end(), edits.begin(), edits.end());
    if (!arguments.list) return absl::OkStatus();
    for (const Record& edit : edits) {
      fmt::print("{:<28}{:<60}{:>8.1f} ms {:>3} moved, {} -> {}\n", edit["room"].get<std::string>(),
                 edit["edit"].get<std::string>(), 1e3 * edit["cpu_s"].get<double>(), edit["moved"].dump(),
                 edit["held_before"].dump(), edit["held_after"].dump());
    }
    return absl::OkStatus();
  });
  if (!all.empty()) fmt::print("{}", ResolveTable(all));
  return AllMeasured(failures, files);
}

struct BenchRestartsArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  int& restarts = Whole("--restarts N", 1, 10000, 64, "Restarts of the primary stage of each problem, 1 to 10000 (64)");
  int64_t& seed = SeedNumber("Other restarts (0)");
};

absl::Status BenchRestarts(const BenchRestartsArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  std::vector<RestartsMeasure> measures;
  const std::vector<Record> failures = MeasureEach(files, [&](const BenchProblem& problem) -> absl::Status {
    ASSIGN_OR_RETURN(RestartsMeasure measure, MeasureRestarts(problem, options, arguments.restarts));
    measures.push_back(std::move(measure));
    return absl::OkStatus();
  });
  if (!measures.empty()) fmt::print("{}", RestartsTable(measures));
  return AllMeasured(failures, files);
}

constexpr size_t kMostRooms = 10000;

struct BenchRenderArguments : Options {
  using Options::Options;
  std::string& folder = Required("DIR", "Folder of designs, at any depth");
  int& repeats =
      Whole("--repeat N", 1, 100, RenderBench().repeat_count, "Times to draw each, 1 to 100 (3); the fastest counts");
  int& size_px = Whole("--size PX", 256, 4096, RenderBench().view_size_px,
                       "Longer side of the bird's-eye view in pixels, 256 to 4096 (1024)");
  int& samples = Whole("--samples N", 1, 4096, RenderBench().sample_count, "Its light paths per pixel, 1 to 4096 (16)");
  int& threads = Whole("--threads N", 1, 256, RenderBench().thread_count, "Its threads, 1 to 256 (2)");
  bool& no_views = Flag("--no-views", "Skip the views");
  bool& list = Flag("--list", "List every room");
  std::string& json = Text("--json FILE", "Write all figures as JSON");
};

absl::Status BenchRender(const BenchRenderArguments& arguments) {
  RenderBench bench;
  bench.repeat_count = arguments.repeats;
  bench.view_size_px = arguments.size_px;
  bench.sample_count = arguments.samples;
  bench.thread_count = arguments.threads;
  bench.views = !arguments.no_views;
  ASSIGN_OR_RETURN(const std::vector<std::filesystem::path> folders,
                   FindFoldersWith(arguments.folder, "layout.pb", kMostRooms));
  RETURN_IF_ERROR(CheckOutputFile(arguments.json));
  const std::unique_ptr<renderer::ImageWriter> writer = renderer::MakeImageWriter();
  std::vector<Record> rooms;
  for (const std::filesystem::path& folder : folders) {
    ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(folder / "layout.pb"));
    const v1::SolvedLayout& solved = layout.artifact.solved_layout();
    const std::string room = folder.lexically_relative(arguments.folder).string();
    // The first picture loads what all of them need.
    if (rooms.empty()) {
      RenderBench once = bench;
      once.repeat_count = 1;
      RETURN_IF_ERROR(MeasureRenders(room, solved, once, *writer).status());
    }
    const absl::StatusOr<Record> measure = MeasureRenders(room, solved, bench, *writer);
    if (!measure.ok()) return About(folder.string(), measure.status());
    if (arguments.list) {
      fmt::print("{:<34}{:>4} objects", room, (*measure)["object_count"].dump());
      for (const std::string& kind : RenderKinds()) {
        const std::optional<double> cpu_s = NumberAt(*measure, fmt::format("/{}/cpu_s", kind));
        if (cpu_s.has_value()) fmt::print("{:>9.1f} ms", 1e3 * *cpu_s);
      }
      fmt::print("\n");
    }
    rooms.push_back(*measure);
  }
  fmt::print("{}, {}, views of {} px with {} per pixel on {}\n{}", Counted(std::ssize(rooms), "room"),
             Counted(bench.repeat_count, "repeat"), bench.view_size_px, Counted(bench.sample_count, "path"),
             Counted(bench.thread_count, "thread"), RenderTable(rooms));
  if (arguments.json.empty()) return absl::OkStatus();
  return WriteOutputFile(arguments.json, RenderJson(rooms, bench));
}

constexpr absl::Duration kRoomWithin = absl::Minutes(10);

struct BenchTranslateArguments : Options {
  using Options::Options;
  std::string& labels = Required("DIR", "Folder of .jsonl labels, or one file of them");
  std::string& rooms = Text("--rooms DIR", "Folder of the recorded rooms; by default in DIR or beside it");
  bool& misses = Flag("--misses", "List every sentence with a mistake");
  std::string& address = Text("--translator HOST:PORT", "Use this server instead of the built-in translator");
  LlmFlags llm{command()};
};

// The model that the flags name; none without them, whatever $FLAIR_LLM says: the grammar is what is measured then.
absl::StatusOr<OptionalLlm> ReadModel(const BenchTranslateArguments& arguments) {
  const std::string given = arguments.llm.Given();
  if (given.empty()) return OptionalLlm();
  if (arguments.address.empty()) return ReadLlmFlags(arguments.llm);
  return InvalidArgument("{}: not with --translator {}, which has its own model or none; name the model in its config",
                         given, arguments.address);
}

absl::StatusOr<TranslateScore> Measure(const std::vector<LabelledRoom>& rooms, const v1::ConstraintCatalog& catalog,
                                       const std::string& address, const OptionalLlm& model) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    ASSIGN_OR_RETURN(services, EmbeddedServices::StartStages(model));
    channel = services->stages().translator.channel;
  } else {
    ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
    ASSIGN_OR_RETURN(channel, runtime::MakeChannel(address, v1::TranslatorService::service_full_name(), options));
  }
  const auto stub = v1::TranslatorService::NewStub(channel);
  size_t asked = 0;
  return MeasureTranslation(rooms, catalog, [&](const v1::TranslateRequest& request) {
    // The grammar is through with all rooms at once, a model takes its time for each.
    if (model.has_value()) fmt::print(stderr, "{} of {}: {}\n", asked + 1, rooms.size(), rooms[asked].name);
    ++asked;
    runtime::CallContext call;
    return runtime::UnaryRequest(*stub, &v1::TranslatorService::StubInterface::Translate, request, call,
                                 absl::Now() + kRoomWithin);
  });
}

absl::Status BenchTranslate(const BenchTranslateArguments& arguments) {
  ASSIGN_OR_RETURN(const TranslateLabels labels, ReadTranslateLabels(arguments.labels, arguments.rooms));
  for (const std::string& failure : labels.failures) fmt::print(stderr, "{}\n", failure);
  ASSIGN_OR_RETURN(const OptionalLlm model, ReadModel(arguments));
  const double started = ProcessCpu_s();
  ASSIGN_OR_RETURN(const TranslateScore score,
                   Measure(labels.rooms, TypesOfTheReference(optimizer::MakeCatalog()), arguments.address, model));
  const double cpu_ms = 1e3 * (ProcessCpu_s() - started);
  if (arguments.misses) fmt::print("{}\n", score.misses);
  fmt::print("{}", TranslateScoreText(score, cpu_ms));
  std::fflush(stdout);
  if (labels.failures.empty()) return absl::OkStatus();
  return InvalidArgument("{} could not be measured",
                         Counted(std::ssize(labels.failures), "line of labels", "lines of labels"));
}

}  // namespace

void AddBench(const Commands& program) {
  const Commands bench = program.Group("bench", "Measure the solver.");
  bench.Add("solve", "Solve every problem of a folder: times, costs, measures.", BenchSolve);
  bench.Add("render", "Draw the layouts of a folder: CPU of plans, bird's-eye views and scenes.", BenchRender);
  bench.Add("resolve", "Edit solved layouts of a folder's problems: times, moves, constraints that hold.",
            BenchResolve);
  bench.Add("restarts", "Measure how many restarts it takes to find the best primary layout.", BenchRestarts);
  bench.Add("translate", "Translate labelled sentences of recorded rooms: correct, wrong, missed, wrongly refused.",
            BenchTranslate);
}

}  // namespace flair::cli
