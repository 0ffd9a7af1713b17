// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer_worker/assets/asset_library.h"

namespace flair::renderer {
namespace {

TEST(ReadManifest, ReadsOurOwnForm) {
  const auto manifest = ReadManifest(R"({"assets": [{"id": "a", "file": "chairs/a.glb", "name": "armchair",
      "tags": ["rattan", "boho"], "text": "A deep chair.", "width_m": 0.8, "depth_m": 0.7, "height_m": 0.9,
      "front": "-z", "up": "+y", "licence": "CC-BY-4.0"}]})");
  ASSERT_TRUE(manifest.ok()) << manifest.status();
  ASSERT_EQ(manifest->entries.size(), 1U);
  const AssetEntry& entry = manifest->entries[0];
  EXPECT_EQ(entry.file, "chairs/a.glb");
  EXPECT_EQ(entry.tags, "rattan boho");
  EXPECT_EQ(entry.axes.front, "-z");
  EXPECT_EQ(entry.licence, "CC-BY-4.0");
  EXPECT_EQ(entry.size_m, (Vec3{0.8F, 0.7F, 0.9F}));
  EXPECT_TRUE(manifest->diagnostics.empty());
}

TEST(ReadManifest, ReadsAnnotationsAsObjaverseHasThem) {
  const auto manifest = ReadManifest(R"({"0a1b": {"uid": "0a1b", "name": "Wooden stool",
      "tags": [{"name": "stool", "slug": "stool"}, {"name": "oak"}], "categories": [{"name": "furniture-home"}],
      "description": "A stool.", "license": "by", "vertexCount": 120}})");
  ASSERT_TRUE(manifest.ok()) << manifest.status();
  ASSERT_EQ(manifest->entries.size(), 1U);
  EXPECT_EQ(manifest->entries[0].id, "0a1b");
  EXPECT_EQ(manifest->entries[0].file, "0a1b.glb");
  EXPECT_EQ(manifest->entries[0].name, "Wooden stool");
  EXPECT_EQ(manifest->entries[0].tags, "stool oak furniture-home");
  EXPECT_EQ(manifest->entries[0].licence, "by");
  EXPECT_FALSE(manifest->entries[0].size_m.has_value());
}

TEST(ReadManifest, LeavesBadEntriesOutAndSaysWhy) {
  const auto manifest = ReadManifest(R"({"assets": [
      {"id": "good", "file": "a.glb", "name": "bed"},
      {"id": "good", "file": "b.glb", "name": "bed"},
      {"id": "", "file": "a.glb", "name": "bed"},
      {"id": "outside", "file": "../a.glb", "name": "bed"},
      {"id": "root", "file": "/etc/passwd", "name": "bed"},
      {"id": "lying", "file": "a.glb", "name": "bed", "front": "+y"},
      {"id": "silent", "file": "a.glb"},
      7, null, {"id": 4}]})");
  ASSERT_TRUE(manifest.ok()) << manifest.status();
  EXPECT_EQ(manifest->entries.size(), 1U);
  EXPECT_EQ(manifest->diagnostics.size(), 9U);
  for (const v1::Diagnostic& diagnostic : manifest->diagnostics) EXPECT_EQ(diagnostic.code(), "asset_entry_unusable");
}

TEST(ReadManifest, DoesNotBelieveSizesThatCannotBe) {
  for (const char* size : {"-1", "0", "1e9", "\"wide\"", "null"}) {
    const auto manifest = ReadManifest(std::string(R"({"assets": [{"id": "a", "file": "a.glb", "name": "bed",
        "depth_m": 1, "height_m": 1, "width_m": )") +
                                       size + "}]}");
    ASSERT_TRUE(manifest.ok()) << size;
    ASSERT_EQ(manifest->entries.size(), 1U) << size;
    EXPECT_FALSE(manifest->entries[0].size_m.has_value()) << size;
  }
}

TEST(ReadManifest, RefusesWhatIsNoManifest) {
  for (const char* text : {"", "[]", "3", "{", "\"a\"", "{\"a\": "}) EXPECT_FALSE(ReadManifest(text).ok()) << text;
}

TEST(StaysInFolder, RefusesEveryWayOut) {
  for (const char* file : {"a.glb", "b/a.glb", "b/c/..a.glb", "a..glb"}) EXPECT_TRUE(StaysInFolder(file)) << file;
  for (const char* file :
       {"", "/a.glb", "../a.glb", "b/../../a.glb", "b/..", "./a.glb", "b//a.glb", "b\\..\\a.glb", "b/"}) {
    EXPECT_FALSE(StaysInFolder(file)) << file;
  }
  EXPECT_FALSE(StaysInFolder(std::string_view("a\0.glb", 6)));
}

}  // namespace
}  // namespace flair::renderer
