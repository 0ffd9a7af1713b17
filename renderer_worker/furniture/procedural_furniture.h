// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/statusor.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Extents that a mesh is made for, metres: what is smaller, larger or no number at all is brought to the nearest.
inline constexpr float kSmallestExtent_m = 0.002F;
inline constexpr float kLargestExtent_m = 100;

struct MadePiece {
  Mesh mesh;
  std::vector<LampLight> lights;
};

// The mesh of `object` as a piece of class `class_name` (a box when that is no class), in the look of `style`, which
// may be null: what the script of pieces/ that its record names makes. Equal input gives equal bits. INVALID_ARGUMENT
// with file and line when the script fails. Thread-safe.
absl::StatusOr<MadePiece> MakePiece(std::string_view class_name, const v1::Object& object,
                                    const v1::ObjectStyle* style);

// Whether pieces/ has a mesh of that name.
bool HasMesh(std::string_view name);

// Furniture of our own making: a parametric mesh for every class of furniture, in the size of its object and the
// materials of its style. Equal objects share one mesh as long as somebody holds it.
class ProceduralFurniture final : public FurnishingSource {
 public:
  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override;

 private:
  struct Made {
    std::weak_ptr<const Mesh> mesh;
    std::vector<LampLight> lights;
  };
  mutable std::mutex mutex_;
  // By everything that decides a mesh: class, size and words.
  mutable absl::flat_hash_map<std::string, Made> made_;
};

}  // namespace flair::renderer
