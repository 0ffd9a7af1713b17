// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/exr_planes.h"

namespace flair::renderer {
namespace {

std::span<const float> Floats(const PixelVector<Vec3>& values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return {reinterpret_cast<const float*>(values.data()), 3 * values.size()};
}

// Ids are never negative.
std::span<const uint32_t> Numbers(const PixelVector<int32_t>& values) {
  return {reinterpret_cast<const uint32_t*>(values.data()), values.size()};
}

}  // namespace

std::vector<ImagePlane> ExrPlanes(const TracedView& view) {
  return {{{"R", "G", "B"}, ChannelStorage::kHalf, Floats(view.colour), {}},
          {{"Z"}, ChannelStorage::kFloat, view.depth_m, {}},
          {{"N.X", "N.Y", "N.Z"}, ChannelStorage::kHalf, Floats(view.normal), {}},
          {{"albedo.R", "albedo.G", "albedo.B"}, ChannelStorage::kHalf, Floats(view.albedo), {}},
          {{"instance"}, ChannelStorage::kUint32, {}, Numbers(view.instance)},
          {{"class"}, ChannelStorage::kUint32, {}, Numbers(view.object_class)}};
}

}  // namespace flair::renderer
