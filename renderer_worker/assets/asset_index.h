// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/assets/manifest.h"

namespace flair::renderer {

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

}  // namespace flair::renderer
