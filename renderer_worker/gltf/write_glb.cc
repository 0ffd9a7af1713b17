// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/write_glb.h"

#include "renderer_worker/gltf/glb_text.h"
#include "renderer_worker/gltf/scene_writer.h"

namespace flair::renderer {

absl::StatusOr<std::string> WriteGlb(const Scene& scene, const GlbMetadata& metadata) {
  absl::StatusOr<tinygltf::Model> model = gltf::SceneWriter(scene).Write(metadata);
  if (!model.ok()) return model.status();
  return gltf::GlbText(*model);
}

}  // namespace flair::renderer
