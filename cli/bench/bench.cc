// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench.h"

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "absl/strings/str_replace.h"
#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "flair/v1/translator_service.pb.h"
#include "language_worker/handbook/completion/complete_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "optimizer_worker/constraints/registry.h"
#include "translator_worker/grammar/translate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What an edge says, as a sentence of its own.
v1::Sentence SentenceOf(const v1::ConstraintEdge& edge, const std::map<std::string, v1::ObjectRole>& roles) {
  v1::Sentence sentence;
  sentence.set_id(edge.id());
  sentence.set_text(absl::StrReplaceAll(edge.type(), {{"_", " "}}));
  sentence.set_weight(edge.weight());
  const auto add = [&](const std::string& text) {
    if (roles.contains(text)) sentence.add_subject_ids(text);
  };
  for (const v1::Argument& argument : edge.arguments()) {
    if (argument.value().has_text()) add(argument.value().text());
    for (const std::string& item : argument.value().texts().items()) add(item);
  }
  const bool alone = sentence.subject_ids_size() < 2;
  sentence.set_scope(alone ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER);
  if (sentence.subject_ids_size() > 0 && roles.at(sentence.subject_ids(0)) == v1::OBJECT_ROLE_TERTIARY) {
    sentence.set_scope(v1::SENTENCE_SCOPE_TERTIARY);
  }
  return sentence;
}

// The objects as completion sees them: recorded problems have no heights, so a wardrobe is as tall as wardrobes are.
v1::ObjectList WithUsualHeights(const v1::ObjectList& objects, const language::Handbook& handbook) {
  const language::FurnitureIndex index(handbook);
  v1::ObjectList tall = objects;
  for (v1::Object& object : *tall.mutable_objects()) {
    const language::hb::Furniture* furniture = index.Find(object.name());
    if (furniture != nullptr && object.kind() == v1::OBJECT_KIND_FLOOR) {
      object.set_height_m(furniture->height_m().typical());
    }
  }
  return tall;
}

}  // namespace

namespace fs = std::filesystem;

absl::StatusOr<std::vector<ProblemFile>> ListProblemFiles(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return std::vector<ProblemFile>{{path.stem().string(), path}};
  std::vector<ProblemFile> files;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const fs::path file = entry.path();
    if (file.extension() == ".json" || file.extension() == ".pb") files.push_back({file.stem().string(), file});
    const fs::path graph = file / "graph.pb";
    std::error_code absent;
    if (entry.is_directory(absent) && fs::is_regular_file(graph, absent)) {
      files.push_back({file.filename().string(), graph});
    }
  }
  if (error) return NotFound("{}: {}", path.string(), error.message());
  if (files.empty()) return NotFound("{}: no .json or .pb files in it", path.string());
  std::ranges::sort(files, [](const ProblemFile& a, const ProblemFile& b) { return a.path < b.path; });
  return files;
}

absl::StatusOr<BenchProblem> ReadBenchProblem(const ProblemFile& file) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, ReadArtifact(file.path));
  if (artifact.has_layout_graph()) return BenchProblem{file.name, artifact.layout_graph(), std::nullopt};
  if (artifact.has_solved_layout()) {
    return BenchProblem{file.name, artifact.solved_layout().graph(), artifact.solved_layout()};
  }
  return absl::InvalidArgumentError("an artifact, but neither a graph nor a layout");
}

double ProcessCpu_s() { return Seconds(CLOCK_PROCESS_CPUTIME_ID); }
double ThreadCpu_s() { return Seconds(CLOCK_THREAD_CPUTIME_ID); }
double Wall_s() { return Seconds(CLOCK_MONOTONIC); }

double PeakMemory_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

absl::Status CompleteGraph(v1::LayoutGraph& graph) {
  ASSIGN_OR_RETURN(const std::unique_ptr<const language::Handbook> handbook,
                   language::LoadHandbook(language::DefaultHandbookFolder()));
  v1::Brief brief;
  brief.set_text(graph.room().title().empty() ? graph.room().room_type() : graph.room().title());
  std::map<std::string, v1::ObjectRole> roles;
  for (const v1::Object& object : graph.object_list().objects()) roles[object.id()] = object.role();
  v1::ConstraintList said;
  for (const v1::ConstraintEdge& edge : graph.edges()) *said.add_sentences() = SentenceOf(edge, roles);
  const v1::ConstraintList completed = language::CompleteConstraints(
      {brief, graph.room(), graph.zone_plan()}, WithUsualHeights(graph.object_list(), *handbook), said, *handbook);

  v1::TranslateRequest request;
  std::set<std::string> kept;
  for (const v1::Sentence& sentence : completed.sentences()) {
    if (sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED) {
      *request.mutable_constraint_list()->add_sentences() = sentence;
    } else {
      kept.insert(sentence.id());
    }
  }
  auto& edges = *graph.mutable_edges();
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](const v1::ConstraintEdge& edge) { return !kept.contains(edge.id()); }),
              edges.end());
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  *request.mutable_object_list() = graph.object_list();
  *request.mutable_style_sheet() = graph.style_sheet();
  *request.mutable_catalog() = optimizer::MakeCatalog();
  v1::LayoutGraph implied = translator::Translate(request);
  for (v1::ConstraintEdge& edge : *implied.mutable_edges()) {
    edge.set_id("implied_" + edge.id());
    *edges.Add() = std::move(edge);
  }
  graph.mutable_constraint_list()->MergeFrom(request.constraint_list());
  graph.mutable_diagnostics()->MergeFrom(implied.diagnostics());
  return absl::OkStatus();
}

}  // namespace flair::cli
