// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms as GLB before the judge that the format's makers publish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer_worker/drawing/testdata/read_layout.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/write_glb.h"
#include "tests/scene/validator.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;

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

// Or else the test above would prove nothing.
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
