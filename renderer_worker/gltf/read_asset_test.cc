// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "renderer_worker/gltf/mesh_book.h"
#include "renderer_worker/gltf/testing/glb_files.h"

namespace flair::renderer {
namespace {

using gltf::TriangleGlb;
using Json = nlohmann::json;
using ::testing::HasSubstr;

absl::StatusOr<AssetMesh> Read(const std::string& glb, const AssetAxes& axes = {}) { return ReadAsset(glb, axes); }

// A triangle in O: its tip is the front's middle.
Mesh Pointer() {
  Mesh mesh;
  MeshPart& part = mesh.parts.emplace_back();
  part.material = {.name = "brass", .colour = {0.8F, 0.6F, 0.2F}, .roughness = 0.3F, .metallic = 1};
  part.positions = {{-0.5F, -1, 0}, {0.5F, -1, 0}, {0, 1, 0.25F}};
  const Vec3 normal = Normalized(Cross(part.positions[1] - part.positions[0], part.positions[2] - part.positions[0]));
  part.normals = {normal, normal, normal};
  part.indices = {0, 1, 2};
  return mesh;
}

void ExpectNear(Vec3 a, Vec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-5);
  EXPECT_NEAR(a.y, b.y, 1e-5);
  EXPECT_NEAR(a.z, b.z, 1e-5);
}

TEST(ReadAsset, ReadsBackWhatWeWrite) {
  const Mesh mesh = Pointer();
  absl::StatusOr<AssetMesh> read = Read(*WriteMeshGlb(mesh, "pointer"));
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->mesh.parts.size(), 1U);
  const MeshPart& part = read->mesh.parts[0];
  EXPECT_EQ(part.positions, mesh.parts[0].positions);
  EXPECT_EQ(part.indices, mesh.parts[0].indices);
  for (size_t i = 0; i < 3; ++i) ExpectNear(part.normals[i], mesh.parts[0].normals[i]);
  EXPECT_EQ(part.material.name, "brass");
  EXPECT_NEAR(part.material.colour.y, 0.6F, 1e-6);
  EXPECT_NEAR(part.material.metallic, 1, 1e-6);
  EXPECT_THAT(read->notes, ::testing::IsEmpty());
}

// Where the file's axes go: `front` to +y, `up` to +z.
TEST(ReadAsset, TurnsTheFrontForwardAndTheUpUpwards) {
  const Json ahead = {{"translation", {0, 0, 5}}};  // along the file's +z
  const Json above = {{"translation", {0, 7, 0}}};  // along its +y
  const auto first = [](const Json& node, const AssetAxes& axes) {
    return Read(TriangleGlb({.node = node}), axes)->mesh.parts[0].positions[0];
  };
  ExpectNear(first(ahead, {"+z", "+y"}), {0, 5, 0});
  ExpectNear(first(above, {"+z", "+y"}), {0, 0, 7});
  ExpectNear(first(ahead, {"-z", "+y"}), {0, -5, 0});
  ExpectNear(first(ahead, {"+x", "+y"}), {5, 0, 0});
  ExpectNear(first(ahead, {"-y", "+z"}), {0, 0, 5});
  ExpectNear(first(above, {"-y", "+z"}), {0, -7, 0});
}

TEST(ReadAsset, MakesFlatNormalsWhereThereAreNoneAndKeepsWindingInMirrors) {
  for (const double mirror : {1.0, -1.0}) {
    absl::StatusOr<AssetMesh> read = Read(TriangleGlb({.node = {{"scale", {mirror, 1, 1}}}}));
    ASSERT_TRUE(read.ok()) << read.status();
    const MeshPart& part = read->mesh.parts[0];
    const Vec3 a = part.positions[part.indices[0]];
    const Vec3 face = Cross(part.positions[part.indices[1]] - a, part.positions[part.indices[2]] - a);
    // The triangle lies in the file's xy plane and is seen from +z, which is the front.
    EXPECT_GT(face.y, 0) << mirror;
    for (const uint32_t i : part.indices) ExpectNear(part.normals[i], {0, 1, 0});
  }
}

TEST(ReadAsset, ReadsStripsFansAndTrianglesWithoutIndices) {
  for (const int mode : {4, 5, 6}) {
    absl::StatusOr<AssetMesh> read = Read(TriangleGlb({.primitive = {{"mode", mode}}}));
    ASSERT_TRUE(read.ok()) << mode << read.status();
    EXPECT_EQ(read->mesh.parts[0].indices.size(), 3U);
  }
}

TEST(ReadAsset, HandsBaseColourPicturesOnUnread) {
  const std::string png = gltf::PatternPng({.pattern = Pattern::kTiles});
  absl::StatusOr<AssetMesh> read = Read(TriangleGlb({.image = png}));
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_NE(read->mesh.parts[0].material.image, nullptr);
  EXPECT_EQ(read->mesh.parts[0].material.image->bytes, png);
  EXPECT_EQ(read->mesh.parts[0].material.image->mime_type, "image/png");
}

TEST(ReadAsset, LeavesOutPicturesThatWouldFillTheMemory) {
  std::string bomb = gltf::PatternPng({.pattern = Pattern::kTiles});
  for (const size_t at : {16, 20}) bomb.replace(at, 4, std::string("\x00\x01\x00\x00", 4));  // 65536 x 65536
  absl::StatusOr<AssetMesh> read = Read(TriangleGlb({.image = bomb}));
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(read->mesh.parts[0].material.image, nullptr);
  ASSERT_EQ(read->notes.size(), 1U);
  EXPECT_THAT(read->notes[0], HasSubstr("65536 x 65536"));
}

struct Hostile {
  const char* name;
  gltf::TriangleFile file;
  absl::StatusCode code;
};

TEST(ReadAsset, RefusesFilesThatLie) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Hostile> cases = {
      {"absurd count", {.accessor = {{"count", 4000000000000ULL}}}, absl::StatusCode::kResourceExhausted},
      {"count past the end", {.accessor = {{"count", 4}}}, absl::StatusCode::kInvalidArgument},
      {"negative count", {.accessor = {{"count", -3}}}, absl::StatusCode::kInvalidArgument},
      {"offset past the end", {.accessor = {{"byteOffset", 1e15}}}, absl::StatusCode::kInvalidArgument},
      {"view past the end", {.view = {{"byteLength", 1e12}}}, absl::StatusCode::kInvalidArgument},
      {"huge stride", {.view = {{"byteStride", 9007199254740992.0}}}, absl::StatusCode::kInvalidArgument},
      {"not a number", {.positions = {0, 0, 0, nan, 0, 0, 0, 1, 0}}, absl::StatusCode::kInvalidArgument},
      {"far away", {.positions = {0, 0, 0, 1e30F, 0, 0, 0, 1, 0}}, absl::StatusCode::kInvalidArgument},
      {"infinite scale", {.node = {{"scale", {1e38, 1, 1}}}}, absl::StatusCode::kInvalidArgument},
      {"node of itself", {.node = {{"children", {0}}}}, absl::StatusCode::kResourceExhausted},
      {"no such mesh", {.node = {{"mesh", 7}}}, absl::StatusCode::kInvalidArgument},
      {"wrong type", {.accessor = {{"type", "VEC4"}}}, absl::StatusCode::kInvalidArgument},
      {"unknown component", {.accessor = {{"componentType", 5124}}}, absl::StatusCode::kInvalidArgument},
      {"sparse", {.accessor = {{"sparse", Json::object()}}}, absl::StatusCode::kUnimplemented},
      {"draco", {.top = {{"extensionsRequired", {"KHR_draco_mesh_compression"}}}}, absl::StatusCode::kUnimplemented},
      {"buffer elsewhere",
       {.top = {{"buffers", {{{"uri", "/etc/passwd"}, {"byteLength", 36}}}}}},
       absl::StatusCode::kInvalidArgument},
      {"nothing", {.top = {{"scenes", Json::array({Json::object()})}}}, absl::StatusCode::kNotFound},
  };
  for (const Hostile& c : cases) EXPECT_EQ(Read(TriangleGlb(c.file)).status().code(), c.code) << c.name;
}

TEST(ReadAsset, RefusesEveryTruncation) {
  const std::string glb = *WriteMeshGlb(Pointer(), "pointer");
  for (size_t size = 0; size < glb.size(); ++size) EXPECT_FALSE(Read(glb.substr(0, size)).ok()) << size;
}

TEST(ReadAsset, RefusesHeadersOfAGigabyteAndDeepNests) {
  std::string glb = TriangleGlb({});
  const uint32_t gigabyte = 1U << 30;
  for (const size_t at : {size_t{8}, size_t{12}}) {
    std::string lying = glb;
    std::memcpy(lying.data() + at, &gigabyte, 4);
    EXPECT_EQ(Read(lying).status().code(), absl::StatusCode::kInvalidArgument) << at;
  }
  EXPECT_EQ(Read(gltf::GlbOf(std::string(100000, '[') + std::string(100000, ']'), "")).status().code(),
            absl::StatusCode::kInvalidArgument);
}

TEST(ReadAsset, RefusesAxesThatAreNone) {
  for (const AssetAxes& axes :
       {AssetAxes{"+z", "-z"}, AssetAxes{"z", "+y"}, AssetAxes{"", ""}, AssetAxes{"+w", "+y"}}) {
    EXPECT_EQ(Read(TriangleGlb({}), axes).status().code(), absl::StatusCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace flair::renderer
