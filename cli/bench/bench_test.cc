// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const fs::path kStudy = FLAIR_SOURCE_DIR "/cli/bench/testdata/small_study.json";

class BenchTest : public testing::Test {
 protected:
  BenchTest() : folder_(fs::path(testing::TempDir()) / fmt::format("flair_bench_{}", getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "bedroom");
  }
  ~BenchTest() override { fs::remove_all(folder_); }
  void Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  const fs::path folder_;
};

BenchProblem Study() { return ReadBenchProblem({"small_study", kStudy}).value(); }

const SolveMeasure& Measure() {
  static const SolveMeasure measure = [] {
    v1::SolveOptions options;
    options.set_seed(0);
    options.set_thread_count(1);
    return MeasureSolve(Study(), options, 2).value();
  }();
  return measure;
}

TEST_F(BenchTest, RecordedGraphsAreCompleted) {
  v1::LayoutGraph graph = Study().graph;
  const int before = graph.edges_size();
  ASSERT_TRUE(CompleteGraph(graph).ok());
  EXPECT_GT(graph.edges_size(), before);
  std::vector<std::string> implied;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (edge.id().starts_with("implied_")) implied.push_back(edge.type());
  }
  EXPECT_THAT(implied, Contains("next_to")) << "the chair is drawn up to the desk";
  EXPECT_EQ(graph.constraint_list().sentences(0).origin(), v1::SENTENCE_ORIGIN_IMPLIED);
}

TEST_F(BenchTest, FilesAndGraphsOfDesignsAreListedByName) {
  for (const char* name : {"b.json", "a.pb", "notes.txt", "bedroom/graph.pb", "bedroom/room.pb"}) Write(name, "x");
  const absl::StatusOr<std::vector<ProblemFile>> files = ListProblemFiles(folder_);
  ASSERT_TRUE(files.ok()) << files.status();
  std::vector<std::string> names;
  for (const ProblemFile& file : *files) names.push_back(file.name);
  EXPECT_THAT(names, ElementsAre("a", "b", "bedroom"));
}

TEST_F(BenchTest, FoldersWithoutProblemsAreNotFound) {
  EXPECT_EQ(ListProblemFiles(folder_).status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ListProblemFiles(folder_ / "none").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(BenchTest, GraphsAndLayoutsOfOursAreProblems) {
  Write("graph.pb", GraphArtifactBytes(Study().graph, "test", ""));
  Write("layout.pb", LayoutArtifactBytes(*Study().recorded, "test", ""));
  const absl::StatusOr<BenchProblem> graph = ReadBenchProblem({"graph", folder_ / "graph.pb"});
  const absl::StatusOr<BenchProblem> layout = ReadBenchProblem({"layout", folder_ / "layout.pb"});
  ASSERT_TRUE(graph.ok() && layout.ok());
  EXPECT_EQ(graph->graph.SerializeAsString(), Study().graph.SerializeAsString());
  EXPECT_FALSE(graph->recorded);
  EXPECT_EQ(layout->graph.SerializeAsString(), Study().graph.SerializeAsString());
  EXPECT_TRUE(layout->recorded);
}

TEST_F(BenchTest, FilesOfAnotherKindAreRefusedWithAReason) {
  Write("bad.json", "{\"a\":");
  const absl::StatusOr<BenchProblem> problem = ReadBenchProblem({"bad", folder_ / "bad.json"});
  EXPECT_EQ(problem.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(problem.status().message()), HasSubstr("bad.json:1: "));
}

TEST(SolveMeasureTest, CountsTheWorkOfEveryStage) {
  const Record& solve = Measure().record;
  EXPECT_GT(solve["cpu_s"], 0);
  EXPECT_EQ(solve["stages"].size(), 4u);
  for (const auto& [name, stage] : solve["stages"].items()) {
    EXPECT_GT(stage["restarts"], 0);
    EXPECT_GT(stage["evaluations"], 0);
    EXPECT_GT(stage["cpu_s"], 0);
    EXPECT_LE(stage["cpu_s"], solve["cpu_s"]);
  }
  // The account of the branch that won is part of it.
  int64_t winner = 0;
  for (const v1::StageOutcome& outcome : Measure().layout.stage_outcomes()) winner += outcome.evaluation_count();
  EXPECT_LE(winner, solve["evaluations"]);
}

TEST(SolveMeasureTest, MeasuresTheRecordedLayoutOnTheSameScale) {
  const auto all = [](const Record& quality) {
    return quality["held"].get<int>() + quality["missed"].get<int>() + quality["dropped"].get<int>();
  };
  const Record& solve = Measure().record;
  ASSERT_TRUE(solve.contains("recorded"));
  EXPECT_EQ(all(solve["ours"]), Study().graph.edges_size());
  EXPECT_EQ(all(solve["recorded"]), Study().graph.edges_size());
  EXPECT_GE(solve["ours"]["held"], solve["recorded"]["held"]);
}

TEST(SolveMeasureTest, AProblemThatDoesNotValidateIsAnError) {
  BenchProblem problem = Study();
  problem.graph.mutable_object_list()->mutable_objects(0)->set_width_m(-1);
  EXPECT_EQ(MeasureSolve(problem, {}, 1).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(RestartsMeasureTest, ScoresDoNotDependOnHowManyAreAskedFor) {
  const absl::StatusOr<Record> few = MeasureRestarts(Study(), {}, 2), more = MeasureRestarts(Study(), {}, 4);
  ASSERT_TRUE(few.ok() && more.ok());
  EXPECT_THAT((*few)["scores"], ElementsAre((*more)["scores"][0], (*more)["scores"][1]));
}

TEST(Statistics, QuantilesAreValuesOfTheSample) {
  EXPECT_EQ(Quantile({}, 0.5), 0);
  EXPECT_EQ(Quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(Quantile({3, 1, 2}, 0), 1);
  EXPECT_EQ(Quantile({3, 1, 2}, 1), 3);
}

}  // namespace
}  // namespace flair::cli
