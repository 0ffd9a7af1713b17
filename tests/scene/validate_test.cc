// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms as GLB before the judge that the format's makers publish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/gltf.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;

// Runs the Khronos glTF validator on files; exit code 0 when it found no errors and no warnings. Installs it with npm
// into the build folder when it is not there yet; when that fails, the exit code is that of npm and `err` what it said.
Finished ValidateGlb(const std::vector<fs::path>& files) {
  static const NpmFolder validator("gltf_validator", fs::path(FLAIR_SOURCE_DIR) / "tests/scene",
                                   {"package.json", "package-lock.json", "validate.mjs"});
  std::vector<std::string> command = {"node", (validator.path() / "validate.mjs").string()};
  for (const fs::path& file : files) command.push_back(file.string());
  return validator.Run(command);
}

std::string GlbOf(const std::string& sample) {
  static const renderer::ProceduralFurniture furniture;
  const v1::SolvedLayout layout = renderer::ReadSample(sample);
  absl::StatusOr<renderer::Scene> scene = renderer::BuildScene(layout, furniture);
  EXPECT_TRUE(scene.ok()) << sample << ": " << scene.status();
  if (!scene.ok()) return "";
  absl::StatusOr<std::string> glb =
      renderer::WriteGlb(*scene, {.job_id = "job", .brief_text = "Ein Zimmer, größer als \"nötig\".", .brief_seed = 1});
  EXPECT_TRUE(glb.ok()) << sample << ": " << glb.status();
  return glb.value_or("");
}

TEST(KhronosValidator, FindsNoErrorAndNoWarningInAnyRoom) {
  const TestFolder folder;
  std::vector<fs::path> files;
  for (const std::string& sample : renderer::SampleLayouts()) {
    files.push_back(folder / (sample + ".glb"));
    WriteAll(files.back(), GlbOf(sample));
  }
  const Finished finished = ValidateGlb(files);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, ::testing::HasSubstr("\n0 errors, 0 warnings, 0 infos, 0 hints\n"));
}

// A model with a picture, brought by a user, for every chair.
TEST(KhronosValidator, FindsNoErrorAndNoWarningInRoomsWithModelsOfUsers) {
  const TestFolder assets;
  renderer::Mesh model;
  renderer::MeshPart& part = model.parts.emplace_back();
  part.material = {.name = "weave", .pattern = renderer::Pattern::kFabric};
  part.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 4.4F}, {-1, 1, 4.4F}};
  part.normals = std::vector<renderer::Vec3>(4, renderer::Normalized({0, -2.2F, 1}));
  part.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  part.indices = {0, 1, 2, 0, 2, 3};
  WriteAll(assets / "chair.glb", *renderer::WriteMeshGlb(model, "chair"));
  WriteAll(assets / "manifest.json", R"({"assets": [{"id": "my_chair", "file": "chair.glb", "name": "chair",
      "licence": "CC0-1.0"}]})");
  const auto library = renderer::AssetLibrary::Open(assets.path());
  ASSERT_TRUE(library.ok()) << library.status();
  const renderer::ProceduralFurniture furniture;
  const renderer::AssetFurniture source(**library, furniture);
  const TestFolder folder;
  std::vector<fs::path> files;
  size_t shown_count = 0;
  for (const std::string& sample : renderer::SampleLayouts()) {
    const v1::SolvedLayout layout = renderer::ReadSample(sample);
    const absl::StatusOr<renderer::Scene> scene = renderer::BuildScene(layout, source);
    ASSERT_TRUE(scene.ok()) << scene.status();
    const auto shown =
        std::count_if(scene->objects.begin(), scene->objects.end(), [](const renderer::SceneObject& object) {
          return object.furnishing.asset_id == "my_chair" && object.furnishing.mesh->parts[0].material.image != nullptr;
        });
    shown_count += static_cast<size_t>(shown);
    const absl::StatusOr<std::string> glb = renderer::WriteGlb(*scene, {});
    ASSERT_TRUE(glb.ok()) << glb.status();
    files.push_back(folder / (sample + ".glb"));
    WriteAll(files.back(), *glb);
  }
  EXPECT_GT(shown_count, 0U);
  const Finished finished = ValidateGlb(files);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, ::testing::HasSubstr("\n0 errors, 0 warnings, 0 infos, 0 hints\n"));
}

// Or else the tests above would prove nothing.
TEST(KhronosValidator, FindsWhatIsWrong) {
  const TestFolder folder;
  std::string glb = GlbOf("bare_hall");
  glb.resize(glb.size() - 64);
  WriteAll(folder / "cut.glb", glb);
  const Finished finished = ValidateGlb({folder / "cut.glb"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_THAT(finished.out, ::testing::HasSubstr("error: GLB_")) << finished.err;
}

}  // namespace
}  // namespace flair::testing
