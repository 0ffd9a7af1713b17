// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/glb_text.h"

#include <exception>
#include <sstream>
#include <utility>

#include "fmt/format.h"

namespace flair::renderer::gltf {
namespace {

// The header counts bytes in 32 bits; this leaves room for the JSON.
constexpr size_t kMaxBinaryBytes = (size_t{1} << 32) - (size_t{256} << 20);

}  // namespace

absl::StatusOr<std::string> GlbText(const tinygltf::Model& model) {
  const size_t size = model.buffers.front().data.size();
  if (size > kMaxBinaryBytes) {
    return absl::ResourceExhaustedError(fmt::format("the room's meshes take {} bytes, GLB holds 4 GiB", size));
  }
  // tinygltf's JSON throws, at what is no UTF-8 for one.
  try {
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model, stream, /*prettyPrint=*/false, /*writeBinary=*/true) || !stream) {
      return absl::InternalError("the GLB could not be written to memory");
    }
    return std::move(stream).str();
  } catch (const std::exception& failure) {
    return absl::InternalError(fmt::format("the GLB could not be written: {}", failure.what()));
  }
}

}  // namespace flair::renderer::gltf
