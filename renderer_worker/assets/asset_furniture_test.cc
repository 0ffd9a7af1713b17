// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/gltf.h"
#include "tests/fixtures/programs.h"

namespace flair::renderer {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

v1::Object ObjectOf(const std::string& name, double width_m, double depth_m, double height_m,
                    v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR) {
  v1::Object object;
  object.set_id("it");
  object.set_name(name);
  object.set_kind(kind);
  object.set_width_m(width_m);
  object.set_depth_m(depth_m);
  object.set_height_m(height_m);
  return object;
}

// A folder of assets that our own generator made, each in the material that marks it.
class Assets {
 public:
  Assets() {
    Add("oak_chair", "dining chair", "oak wooden", "CC0-1.0", ObjectOf("dining chair", 0.45, 0.5, 0.9));
    Add("steel_chair", "dining chair", "steel metal", "CC-BY-4.0", ObjectOf("dining chair", 0.45, 0.5, 0.9));
    Add("long_sofa", "sofa", "grey linen", "CC0-1.0", ObjectOf("sofa", 2.2, 0.9, 0.8));
    Add("arch_mirror", "mirror", "brass", "CC0-1.0", ObjectOf("mirror", 0.8, 0.05, 1.2, v1::OBJECT_KIND_WALL));
  }

  void Add(const std::string& id, const std::string& name, const std::string& tags, const std::string& licence,
           const v1::Object& model) {
    std::vector<v1::Diagnostic> diagnostics;
    Mesh mesh = *furniture_.FurnishingOf(model, nullptr, diagnostics).mesh;
    mesh.parts[0].material.name = id;
    testing::WriteAll(folder_ / (id + ".glb"), *WriteMeshGlb(mesh, id));
    entries_.push_back({{"id", id},
                        {"file", id + ".glb"},
                        {"name", name},
                        {"tags", {tags}},
                        {"licence", licence},
                        {"width_m", model.width_m()},
                        {"depth_m", model.depth_m()},
                        {"height_m", model.height_m()}});
  }

  Json& entries() { return entries_; }
  const testing::TestFolder& folder() const { return folder_; }
  const ProceduralFurniture& furniture() const { return furniture_; }

  std::unique_ptr<AssetLibrary> Open() {
    testing::WriteAll(folder_ / "manifest.json", Json{{"assets", entries_}}.dump());
    absl::StatusOr<std::unique_ptr<AssetLibrary>> library = AssetLibrary::Open(folder_.path());
    EXPECT_TRUE(library.ok()) << library.status();
    return *std::move(library);
  }

 private:
  testing::TestFolder folder_;
  ProceduralFurniture furniture_;
  Json entries_ = Json::array();
};

struct Found {
  Furnishing furnishing;
  std::vector<v1::Diagnostic> diagnostics;
};

Found Furnish(const AssetLibrary& library, const ProceduralFurniture& furniture, const v1::Object& object,
              const v1::ObjectStyle* style = nullptr) {
  Found found;
  found.furnishing = AssetFurniture(library, furniture).FurnishingOf(object, style, found.diagnostics);
  return found;
}

TEST(AssetFurniture, TakesTheAssetWhoseNameStyleAndSizeFit) {
  Assets assets;
  const auto library = assets.Open();
  const v1::Object chair = ObjectOf("dining chair", 0.5, 0.5, 0.95);
  v1::ObjectStyle steel;
  steel.set_material("brushed steel");
  const Found plain = Furnish(*library, assets.furniture(), chair);
  const Found styled = Furnish(*library, assets.furniture(), chair, &steel);
  EXPECT_EQ(plain.furnishing.asset_id, "oak_chair") << "equal otherwise: by id";
  EXPECT_EQ(styled.furnishing.asset_id, "steel_chair");
  EXPECT_EQ(styled.furnishing.asset_licence, "CC-BY-4.0");
  EXPECT_EQ(styled.furnishing.class_name, "chair");
  EXPECT_THAT(styled.diagnostics, IsEmpty());
  EXPECT_EQ(Furnish(*library, assets.furniture(), ObjectOf("couch", 2, 0.9, 0.8)).furnishing.asset_id, "long_sofa")
      << "by its class, with no word in common";
}

TEST(AssetFurniture, MakesWhatNoAssetFits) {
  Assets assets;
  const auto library = assets.Open();
  for (const v1::Object& object : {ObjectOf("wardrobe", 1.2, 0.6, 2), ObjectOf("sofa table", 1.2, 0.4, 0.75),
                                   ObjectOf("sofa", 0.8, 2.4, 0.4), ObjectOf("", 1, 1, 1), ObjectOf("!!!", 1, 1, 1)}) {
    const Found found = Furnish(*library, assets.furniture(), object);
    EXPECT_EQ(found.furnishing.asset_id, "") << object.name();
    EXPECT_NE(found.furnishing.mesh, nullptr);
    EXPECT_THAT(found.diagnostics, IsEmpty());
  }
}

TEST(AssetFurniture, ScalesToWidthAndDepthAndKeepsHeightInProportion) {
  Assets assets;
  const auto library = assets.Open();
  const Vec3 chair =
      ExtentOf(*Furnish(*library, assets.furniture(), ObjectOf("dining chair", 0.5, 0.5, 0.95)).furnishing.mesh);
  EXPECT_NEAR(chair.x, 0.5, 1e-4);
  EXPECT_NEAR(chair.y, 0.5, 1e-4);
  EXPECT_NEAR(chair.z, 0.9 * std::sqrt((0.5 / 0.45) * (0.5 / 0.5)), 1e-4);
  const v1::Object wide = ObjectOf("mirror", 1, 0.02, 1.4, v1::OBJECT_KIND_WALL);
  const Found mirror = Furnish(*library, assets.furniture(), wide);
  ASSERT_EQ(mirror.furnishing.asset_id, "arch_mirror");
  const Vec3 extent = ExtentOf(*mirror.furnishing.mesh);
  EXPECT_NEAR(extent.x, 1, 1e-4);
  EXPECT_NEAR(extent.y, 0.02, 1e-4);
  EXPECT_NEAR(extent.z, 1.2 / 0.8, 1e-4) << "as wide as high, whatever its depth";
}

TEST(AssetFurniture, TurnsAssetsByTheirFrontAxis) {
  Assets assets;
  const v1::Object sofa = ObjectOf("sofa", 2.2, 0.9, 0.8);
  const Mesh straight = *Furnish(*assets.Open(), assets.furniture(), sofa).furnishing.mesh;
  for (Json& entry : assets.entries()) entry["front"] = "-z";
  const Mesh turned = *Furnish(*assets.Open(), assets.furniture(), sofa).furnishing.mesh;
  ASSERT_EQ(straight.parts.size(), turned.parts.size());
  for (size_t p = 0; p < straight.parts.size(); ++p) {
    ASSERT_EQ(straight.parts[p].positions.size(), turned.parts[p].positions.size());
    for (size_t i = 0; i < straight.parts[p].positions.size(); ++i) {
      const Vec3 a = straight.parts[p].positions[i];
      const Vec3 b = turned.parts[p].positions[i];
      ASSERT_NEAR(a.x, -b.x, 1e-4);
      ASSERT_NEAR(a.y, -b.y, 1e-4);
      ASSERT_NEAR(a.z, b.z, 1e-4);
    }
  }
}

TEST(AssetFurniture, FallsBackWithAWordWhereAnAssetIsMissingOrBroken) {
  Assets assets;
  testing::WriteAll(assets.folder() / "long_sofa.glb", "glTF");
  assets.entries().push_back({{"id", "gone"}, {"file", "gone.glb"}, {"name", "wardrobe"}});
  assets.entries().push_back({{"id", "folder"}, {"file", "."}, {"name", "bed"}});
  std::filesystem::create_directory(assets.folder() / "bed.glb");
  assets.entries().push_back({{"id", "bed"}, {"file", "bed.glb"}, {"name", "bed"}});
  const auto library = assets.Open();
  EXPECT_EQ(library->manifest().diagnostics.size(), 1U);
  for (const v1::Object& object :
       {ObjectOf("sofa", 2.2, 0.9, 0.8), ObjectOf("wardrobe", 1.2, 0.6, 2), ObjectOf("bed", 1.6, 2, 0.6)}) {
    const Found found = Furnish(*library, assets.furniture(), object);
    EXPECT_EQ(found.furnishing.asset_id, "") << object.name();
    EXPECT_NE(found.furnishing.mesh, nullptr);
    ASSERT_EQ(found.diagnostics.size(), 1U) << object.name();
    EXPECT_EQ(found.diagnostics[0].code(), "asset_unreadable");
    EXPECT_EQ(found.diagnostics[0].severity(), v1::SEVERITY_WARNING);
    EXPECT_EQ(found.diagnostics[0].subject_id(), "it");
    EXPECT_THAT(found.diagnostics[0].message(), HasSubstr(object.name()));
  }
}

// Proportions that the manifest does not tell are found in the file.
TEST(AssetFurniture, PassesOverAssetsThatTurnOutToHaveOtherProportions) {
  Assets assets;
  for (Json& entry : assets.entries()) entry.erase("depth_m");
  const auto library = assets.Open();
  EXPECT_EQ(Furnish(*library, assets.furniture(), ObjectOf("sofa", 2, 0.9, 0.8)).furnishing.asset_id, "long_sofa");
  EXPECT_EQ(Furnish(*library, assets.furniture(), ObjectOf("sofa", 0.7, 2.8, 0.4)).furnishing.asset_id, "");
}

TEST(AssetFurniture, EqualObjectsShareAMeshAndThreadsAgree) {
  Assets assets;
  const auto library = assets.Open();
  const AssetFurniture source(*library, assets.furniture());
  std::vector<Furnishing> found(8);
  std::vector<std::thread> threads;
  for (Furnishing& furnishing : found) {
    threads.emplace_back([&] {
      std::vector<v1::Diagnostic> diagnostics;
      furnishing = source.FurnishingOf(ObjectOf("dining chair", 0.5, 0.5, 0.95), nullptr, diagnostics);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Furnishing& furnishing : found) {
    EXPECT_EQ(furnishing.asset_id, "oak_chair");
    EXPECT_EQ(furnishing.mesh->parts[0].positions, found[0].mesh->parts[0].positions);
  }
  std::vector<v1::Diagnostic> diagnostics;
  const auto again = source.FurnishingOf(ObjectOf("dining chair", 0.5, 0.5, 0.95), nullptr, diagnostics).mesh;
  EXPECT_EQ(again, source.FurnishingOf(ObjectOf("dining chair", 0.5, 0.5, 0.95), nullptr, diagnostics).mesh);
}

TEST(AssetLibrary, SaysWhatIsWrongWithAFolder) {
  const testing::TestFolder folder;
  EXPECT_EQ(AssetLibrary::Open(folder / "nowhere").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(AssetLibrary::Open(folder.path()).status().code(), absl::StatusCode::kNotFound);
  testing::WriteAll(folder / "annotations.json", "[1, 2");
  EXPECT_EQ(AssetLibrary::Open(folder.path()).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(AssetLibrary, FindsModelsWhereObjaverseAndObjathorKeepThem) {
  Assets assets;
  const std::string glb = testing::ReadAll(assets.folder() / "long_sofa.glb");
  const testing::TestFolder folder;
  std::filesystem::create_directories(folder.path() / "glbs" / "000-000");
  std::filesystem::create_directories(folder.path() / "b2");
  testing::WriteAll(folder.path() / "glbs" / "000-000" / "a1.glb", glb);
  testing::WriteAll(folder.path() / "b2" / "b2.glb", glb);
  testing::WriteAll(folder / "annotations.json",
                    R"({"a1": {"name": "Old sofa", "tags": [{"name": "couch"}], "categories": [], "license": "by"},
                        "b2": {"category": "sofa", "description": "A sofa.", "width": 220, "depth": 90, "height": 80}})");
  testing::WriteAll(folder / "object-paths.json", R"({"a1": "glbs/000-000/a1.glb", "b2": "../../etc/passwd"})");
  const auto library = AssetLibrary::Open(folder.path());
  ASSERT_TRUE(library.ok()) << library.status();
  ASSERT_EQ((*library)->manifest().entries.size(), 2U);
  for (const size_t entry : {0U, 1U}) EXPECT_TRUE((*library)->MeshOf(entry).ok()) << (*library)->MeshOf(entry).status();
  EXPECT_EQ((*library)->manifest().entries[0].licence, "by");
}

}  // namespace
}  // namespace flair::renderer
