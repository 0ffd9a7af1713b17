// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/recorded_stages.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "optimizer_worker/constraints/registry.h"

namespace flair::orchestrator {
namespace {

std::string ReadRecorded(const char* name) {
  const char* folder = std::getenv("FLAIR_BENCH_DESIGN");
  const std::string path = std::string(folder == nullptr ? "out" : folder) + "/" + name;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: cannot be read; FLAIR_BENCH_DESIGN is to be a folder that `flair design` wrote\n",
                 path.c_str());
    std::exit(2);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

RecordedStages::RecordedStages() : picture_(ReadRecorded("plan.png")) {
  v1::Artifact artifact;
  artifact.ParseFromString(ReadRecorded("layout.pb"));
  layout_ = artifact.solved_layout();
  graph_ = layout_.graph();
  *catalog_.mutable_catalog() = optimizer::MakeCatalog();
}

v1::JobSpec SpecOf(int64_t number) {
  v1::JobSpec spec;
  spec.mutable_brief()->set_text("Room " + std::to_string(number));
  return spec;
}

}  // namespace flair::orchestrator
