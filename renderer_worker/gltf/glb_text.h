// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "renderer_worker/gltf/tiny_gltf.h"

namespace flair::renderer::gltf {

// The bytes of a model with one buffer. RESOURCE_EXHAUSTED: more than GLB holds; INTERNAL: what JSON cannot hold.
absl::StatusOr<std::string> GlbText(const tinygltf::Model& model);

}  // namespace flair::renderer::gltf
