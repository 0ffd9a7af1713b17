// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of the corpus through its target: what a fuzzer found once stays found, with any compiler.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

constexpr Target kTargets[] = {
    {"read_graph", ReadGraph},          {"solve_problem", SolveProblem},        {"edit_layout", EditLayout},
    {"read_scene_text", ReadSceneText}, {"read_model_answer", ReadModelAnswer}, {"read_reply", ReadReply},
    {"model_step", ModelStep},          {"read_artifact", ReadArtifact},        {"select_field", SelectField},
    {"read_asset", ReadAsset},          {"read_manifest", ReadManifest},        {"studio_request", StudioRequest}};

std::vector<std::filesystem::path> FilesOf(std::string_view target) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(FLAIR_SOURCE_DIR) / "tests/fuzz/corpus" / target;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string ReadAll(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Corpus : public ::testing::TestWithParam<Target> {};

// A broken promise ends the program; the file's name is printed before.
TEST_P(Corpus, KeepsEveryPromise) {
  const std::vector<std::filesystem::path> files = FilesOf(GetParam().name);
  ASSERT_FALSE(files.empty());
  for (const std::filesystem::path& file : files) {
    std::fprintf(stderr, "%s\n", file.filename().c_str());
    const std::string bytes = ReadAll(file);
    GetParam().run(bytes);
    // Files that are cut off anywhere are the most common damage.
    for (size_t part = 1; part < 8; ++part) GetParam().run(std::string_view(bytes).substr(0, bytes.size() * part / 8));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, ::testing::ValuesIn(kTargets),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace flair::fuzz
