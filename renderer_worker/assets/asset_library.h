// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/provenance.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// One 3D model that a user brings along.
struct AssetEntry {
  std::string id;
  std::string file;            // relative to the folder, never leaving it
  std::string name;            // what it is, such as "rattan armchair"
  std::string tags;            // further words, spaces between
  std::string text;            // a description
  std::optional<Vec3> size_m;  // width, depth, height; nothing when not known
  AssetAxes axes;
  std::string licence;
};

struct Manifest {
  std::vector<AssetEntry> entries;          // unique ids, in the file's order (by id for annotations)
  std::vector<v1::Diagnostic> diagnostics;  // entries that cannot be used, with the reason; at most 100
};

inline constexpr size_t kMaxManifestBytes = size_t{256} << 20;

// Reads a manifest of ours, {"assets": [{"id": ..., "file": ..., ...}]}, or annotations as Objaverse and its followers
// have them, {uid: {"name": ..., "tags": [...], ...}}; docs/assets.md tells both. A bad entry is left out with a
// diagnostic. INVALID_ARGUMENT: no JSON of either form; RESOURCE_EXHAUSTED: more than kMaxManifestBytes.
absl::StatusOr<Manifest> ReadManifest(std::string_view json);

// `file` names something below a folder: relative, no "..", no back slash, no NUL.
bool StaysInFolder(std::string_view file);

// An asset that may stand for an object.
struct AssetMatch {
  size_t entry = 0;  // index in the manifest
  double score = 0;  // [0, 1], see Find
};

// How well an asset of that size takes the object's place: 1 when it only has to be scaled evenly, less the more it is
// stretched between width and depth and the more its height, kept in proportion, misses the object's. A quarter turn
// is no option: fronts are fronts.
//   fit = exp(-(ln²(s_w / s_d) + ln²(h' / h)) / (2 · 0.45²)),  s_w, s_d scales of width and depth, h' = √(s_w s_d)
//   h_asset
// Things that hang on a wall keep their proportion of width to height, whatever their depth: s_d = s_w there. The
// height of what is thinner than 5 cm does not count.
double SizeFit(Vec3 asset_size, const v1::Object& object);

// The score of a match whose size was not known when it was scored, now that it is.
double WithSize(double score, Vec3 asset_size, const v1::Object& object);

// Below this a mesh made for the object shows it better.
inline constexpr double kLeastAssetScore = 0.45;

// Finds assets by text: an SQLite FTS5 table in memory. Thread-safe.
class AssetIndex {
 public:
  // `entries` are read here only. INTERNAL when SQLite fails.
  static absl::StatusOr<std::unique_ptr<AssetIndex>> Make(std::span<const AssetEntry> entries);
  virtual ~AssetIndex() = default;

  // The best matches for an object, best first, at most `max_count`, those below kLeastAssetScore left out. `style` may
  // be null. Candidates are the 60 that FTS5 ranks best (bm25: name 8, tags 4, text 1) for the words of the object's
  // name, category and style; their score is
  //   score = what · (0.7 + 0.2 style + 0.1 text) · (0.4 + 0.6 fit)
  //   what   how much it is the same thing: the share of the words of the object's name that its name and tags hold,
  //          the last counting double; 0.85 when both are of one class of furniture; 0 when their classes differ
  //   style  the share of the words of material and colour that it holds
  //   text   its bm25 rank as a share of the best candidate's
  //   fit    SizeFit, 0.8 while its size is not known
  // Equal scores go by id, so the same manifest gives the same matches.
  virtual absl::StatusOr<std::vector<AssetMatch>> Find(const v1::Object& object, const v1::ObjectStyle* style,
                                                       size_t max_count) = 0;
};

// A folder of 3D models with its manifest. Models are read when first used and kept while there is room. Thread-safe.
class AssetLibrary {
 public:
  // Reads `folder`/manifest.json, or else `folder`/annotations.json. NOT_FOUND: no such folder or neither file; errors
  // of ReadManifest with the file's name.
  static absl::StatusOr<std::unique_ptr<AssetLibrary>> Open(const std::filesystem::path& folder);

  const Manifest& manifest() const { return manifest_; }
  AssetIndex& index() const { return *index_; }

  // The model of an entry. NOT_FOUND: no such file; errors of ReadAsset. An error is remembered as long as the model
  // would be.
  absl::StatusOr<std::shared_ptr<const AssetMesh>> MeshOf(size_t entry) const;

 private:
  using Loaded = absl::StatusOr<std::shared_ptr<const AssetMesh>>;
  struct Kept {
    Loaded mesh;
    size_t vertex_count;
    std::list<size_t>::iterator used;
  };

  Loaded Load(const AssetEntry& entry) const;

  std::filesystem::path folder_;
  Manifest manifest_;
  std::unique_ptr<AssetIndex> index_;
  mutable std::mutex mutex_;
  mutable std::map<size_t, Kept> kept_;  // by entry
  mutable std::list<size_t> used_;       // entries, last used first
  mutable size_t kept_vertex_count_ = 0;
};

// Width, depth and height of the box round a mesh's triangles; 0 for a mesh without.
Vec3 ExtentOf(const Mesh& mesh);

// An asset (x right, y front, z up, any unit and origin) as a piece of furniture in frame O: scaled to the object's
// width and depth, its height in proportion (by the mean of both scales, on walls by that of the width) but at most a
// quarter higher than the object's; what stands has its underside at 0, what hangs on a wall is centred in the object's
// height, what hangs from the ceiling reaches up to it. An extent of nothing stays nothing.
Mesh Fitted(const Mesh& asset, const v1::Object& object);

// Furniture from a user's own models: the asset whose words and size fit an object best, scaled to its width and depth;
// where none fits well enough, or it is missing or broken, what `fallback` makes. Assets keep their own proportions of
// height: unlike procedural meshes they need not fill the object's box. Lamps shine where those of `fallback` do.
//
// Diagnostics: "asset_unreadable" (warning, with the object as its subject) for a model that was chosen and could not
// be read, "asset_partly_read" (note) for pictures that were left out.
class AssetFurniture final : public FurnishingSource {
 public:
  // Both must outlive this.
  AssetFurniture(const AssetLibrary& library, const FurnishingSource& fallback)
      : library_(library), fallback_(fallback) {}

  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override;

 private:
  std::shared_ptr<const Mesh> FittedMesh(size_t entry, const AssetMesh& asset, const v1::Object& object) const;

  const AssetLibrary& library_;
  const FurnishingSource& fallback_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::weak_ptr<const Mesh>> fitted_;  // by entry, size and kind
};

}  // namespace flair::renderer
