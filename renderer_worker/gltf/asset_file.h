// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::renderer::gltf {

// A GLB that a stranger made, opened: its JSON and its binary chunk. Nothing in the JSON is trusted: every number is
// checked where it is used. Borrows the file's bytes.
class AssetFile {
 public:
  // INVALID_ARGUMENT says what of the container is wrong; UNIMPLEMENTED names what it requires and we cannot read.
  static absl::StatusOr<AssetFile> Open(std::string_view bytes);

  const nlohmann::json& json() const { return json_; }

  // Element `index` of a top-level array, null when there is none.
  const nlohmann::json* Item(const char* array, size_t index) const;

  // The bytes of a buffer view. INVALID_ARGUMENT when they are not in the file.
  absl::StatusOr<std::string_view> View(size_t index) const;

  // An accessor's elements as numbers, `components` each, integers as glTF's normalisation has it; what `type` the
  // accessor must have: "VEC3" and the like. At most `max_count` elements: more is RESOURCE_EXHAUSTED.
  absl::StatusOr<std::vector<float>> Numbers(size_t accessor, std::string_view type, size_t components,
                                             size_t max_count) const;

  // An accessor of unsigned integers, each below `bound`.
  absl::StatusOr<std::vector<uint32_t>> Indices(size_t accessor, size_t bound, size_t max_count) const;

 private:
  struct Elements {
    std::string_view bytes;  // from the first element on
    size_t stride = 0;
    size_t count = 0;
    int component_type = 0;
    bool normalized = false;
  };
  absl::StatusOr<Elements> ElementsOf(size_t accessor, std::string_view type, size_t components,
                                      size_t max_count) const;

  nlohmann::json json_;
  std::string_view binary_;
};

}  // namespace flair::renderer::gltf
