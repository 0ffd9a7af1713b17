// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench: measures solver, renderer and translator on folders of problems. Prints a JSON object a line, of
// which evaluation/bench makes tables for people.
#include "cli/bench/bench.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

#include "absl/time/clock.h"
#include "cli/commands/commands.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/message_text.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
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
  std::string& problems = Required("DIR", "Folder (or file) of graphs or layouts");
};

using Measure = std::function<absl::StatusOr<std::vector<Record>>(BenchProblem&)>;

// Measures every problem and prints each record on a line of its own; with `json`, all of them also go into that file.
// Problems that cannot be read or measured are named, and the others measured all the same.
absl::Status MeasureEach(const std::vector<ProblemFile>& files, const std::string& json, const Measure& measure) {
  std::vector<Record> records, failures;
  for (const ProblemFile& file : files) {
    absl::StatusOr<BenchProblem> problem = ReadBenchProblem(file);
    const auto measured = problem.ok() ? measure(*problem) : problem.status();
    if (!measured.ok()) {
      const std::string reason(measured.status().message());
      failures.push_back({{"file", file.path.string()}, {"reason", reason}});
      // A file that cannot be read is named already.
      fmt::print(stderr, "{}{}\n", problem.ok() ? file.path.string() + ": " : "", reason);
      continue;
    }
    for (const Record& record : *measured) fmt::print("{}\n", JsonText(record));
    std::fflush(stdout);
    records.insert(records.end(), measured->begin(), measured->end());
  }
  if (!json.empty()) {
    const Record all = {{"rooms", records}, {"failures", failures}};
    RETURN_IF_ERROR(WriteOutputFile(json, JsonText(all, 1) + "\n"));
  }
  if (failures.empty()) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures.size(), Counted(std::ssize(files), "problem")));
}

struct BenchSolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  std::string& out =
      Text("-o,--out DIR", "Folder for the layouts, as .pb and, from ./flair-dev, in the FlairGPT format");
  std::string& json = Text("--json FILE", "Write all figures as JSON");
  std::vector<std::string>& only = List("--only NAME", "Only these problems, by file name without extension");
  int& threads = Whole("--threads N", 1, 256, 1, "Threads of the solver, 1 to 256 (1); changes no result");
  int& repeats = Whole("--repeat N", 1, 1000, 1, "Solves of each problem, 1 to 1000 (1); the median counts");
  int64_t& seed = SeedNumber("Seed; another seed gives another layout (0)");
  std::optional<int>& restarts =
      Whole("--restarts N", 1, 10000, "Maximum number of restarts per stage, 1 to 10000 (by the stage's size)");
  bool& complete = Flag("--complete", "Add relations that follow from use, as a design does");
};

// NAME.pb for flair render and flair inspect.
absl::Status WriteLayout(const SolveMeasure& measure, const std::filesystem::path& folder) {
  if (folder.empty()) return absl::OkStatus();
  return WriteOutputFile(folder / (measure.record["name"].get<std::string>() + ".pb"),
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
  const auto measure_one = [&](BenchProblem& problem) -> absl::StatusOr<std::vector<Record>> {
    if (arguments.complete) RETURN_IF_ERROR(CompleteGraph(problem.graph));
    ASSIGN_OR_RETURN(const SolveMeasure measure, MeasureSolve(problem, options, arguments.repeats));
    RETURN_IF_ERROR(WriteLayout(measure, arguments.out));
    return std::vector<Record>{measure.record};
  };
  const absl::Status status = MeasureEach(files, arguments.json, measure_one);
  if (!arguments.out.empty()) {
    fmt::print(stderr, "layouts are in {0}: NAME.json for the judge, NAME.pb for flair render\n", arguments.out);
  }
  return status;
}

struct BenchResolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  int& per_kind =
      Whole("--per-kind N", 1, 1000, 4, "Objects and constraints of a room to edit in each way, 1 to 1000 (4)");
};

absl::Status BenchResolve(const BenchResolveArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  v1::SolveOptions options;
  options.set_thread_count(1);
  return MeasureEach(
      files, "", [&](const BenchProblem& problem) { return MeasureResolves(problem, options, arguments.per_kind); });
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
  return MeasureEach(files, "", [&](const BenchProblem& problem) -> absl::StatusOr<std::vector<Record>> {
    ASSIGN_OR_RETURN(Record measure, MeasureRestarts(problem, options, arguments.restarts));
    return std::vector<Record>{std::move(measure)};
  });
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
    fmt::print("{}\n", JsonText(*measure));
    std::fflush(stdout);
    rooms.push_back(*measure);
  }
  if (arguments.json.empty()) return absl::OkStatus();
  return WriteOutputFile(arguments.json, JsonText(Record{{"rooms", rooms}}, 1) + "\n");
}

constexpr absl::Duration kRoomWithin = absl::Minutes(10);

struct BenchTranslateArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  std::vector<std::string>& types = Commas("--types A,B", "Only these types of constraints, by name or alias");
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

// The types of our catalogue that have one of these names, as their own or as an alias, or are built in; all without.
v1::ConstraintCatalog CatalogOf(const std::vector<std::string>& names) {
  v1::ConstraintCatalog known = optimizer::MakeCatalog();
  const auto is_other = [&](const v1::ConstraintType& type) {
    const auto is_named = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
    return !type.built_in() && !is_named(type.name()) && std::ranges::none_of(type.aliases(), is_named);
  };
  auto& types = *known.mutable_types();
  if (!names.empty()) types.erase(std::remove_if(types.begin(), types.end(), is_other), types.end());
  return known;
}

absl::Status BenchTranslate(const BenchTranslateArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  ASSIGN_OR_RETURN(const OptionalLlm model, ReadModel(arguments));
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (arguments.address.empty()) {
    ASSIGN_OR_RETURN(services, EmbeddedServices::StartStages(model));
    channel = services->stages().translator.channel;
  } else {
    ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
    ASSIGN_OR_RETURN(channel,
                     runtime::MakeChannel(arguments.address, v1::TranslatorService::service_full_name(), options));
  }
  const auto stub = v1::TranslatorService::NewStub(channel);
  return MeasureEach(files, "", [&](const BenchProblem& problem) -> absl::StatusOr<std::vector<Record>> {
    v1::TranslateRequest request;
    request.set_request_id("bench-" + problem.name);
    *request.mutable_catalog() = CatalogOf(arguments.types);
    *request.mutable_room() = problem.graph.room();
    *request.mutable_zone_plan() = problem.graph.zone_plan();
    *request.mutable_object_list() = problem.graph.object_list();
    *request.mutable_constraint_list() = problem.graph.constraint_list();
    runtime::CallContext call;
    const double started = ProcessCpu_s();
    ASSIGN_OR_RETURN(const v1::TranslateResponse response,
                     runtime::UnaryRequest(*stub, &v1::TranslatorService::StubInterface::Translate, request, call,
                                           absl::Now() + kRoomWithin));
    return std::vector<Record>{{{"name", problem.name},
                                {"cpu_s", ProcessCpu_s() - started},
                                {"graph", Record::parse(ToJsonLine(response.layout_graph()))}}};
  });
}

}  // namespace

void AddBench(const Commands& program) {
  const Commands bench = program.Group("bench", "Measure; prints JSON, of which ./flair-dev makes tables.");
  bench.Add("solve", "Solve every problem of a folder: times, costs, measures.", BenchSolve);
  bench.Add("render", "Draw the layouts of a folder: CPU of plans, bird's-eye views and scenes.", BenchRender);
  bench.Add("resolve", "Edit solved layouts of a folder's problems: times, moves, constraints that hold.",
            BenchResolve);
  bench.Add("restarts", "Measure how many restarts it takes to find the best primary layout.", BenchRestarts);
  bench.Add("translate", "Translate the sentences of a folder's graphs.", BenchTranslate);
}

}  // namespace flair::cli
