// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/annotations.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace flair::renderer {
namespace {

// What an instance takes of the picture.
struct Extent {
  int64_t count = 0;
  int left = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::max(), right = 0, bottom = 0;
};

void CountPixels(const TracedView& view, v1::ViewAnnotations& annotations) {
  std::vector<Extent> extents(annotations.instances_size());
  for (int y = 0; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; ++x) {
      const int id = view.instance[static_cast<size_t>(y) * view.width_px + x];
      if (id <= 0) continue;
      Extent& e = extents[id - 1];
      ++e.count;
      e = {e.count, std::min(e.left, x), std::min(e.top, y), std::max(e.right, x + 1), std::max(e.bottom, y + 1)};
    }
  }
  for (size_t i = 0; i < extents.size(); ++i) {
    if (extents[i].count == 0) continue;
    v1::Instance& instance = *annotations.mutable_instances(static_cast<int>(i));
    instance.set_visible_pixel_count(extents[i].count);
    v1::PixelBox& box = *instance.mutable_pixel_box();
    box.set_left(extents[i].left);
    box.set_top(extents[i].top);
    box.set_right(extents[i].right);
    box.set_bottom(extents[i].bottom);
  }
}

}  // namespace

v1::ViewAnnotations AnnotationsOf(const Scene& scene, const World& world, const PinholeCamera& camera,
                                  const TracedView& view) {
  v1::ViewAnnotations annotations;
  *annotations.mutable_camera() = camera.Parameters();
  for (size_t i = 0; i < world.instances().size(); ++i) {
    v1::Instance& instance = *annotations.add_instances();
    instance.set_instance_id(world.instances()[i].instance_id);
    instance.set_class_id(world.instances()[i].class_id);
    if (i >= scene.objects.size()) {
      const ShellPart& part = scene.shell[i - scene.objects.size()];
      instance.set_class_name(std::string(NameOf(part.kind)));
      instance.set_subject_id(part.id);
      continue;
    }
    const SceneObject& object = scene.objects[i];
    instance.set_class_name(object.furnishing.class_name);
    instance.set_subject_id(object.object->id());
    instance.set_name(object.object->name());
    *instance.mutable_placement() = object.placement;
    instance.set_width_m(object.object->width_m());
    instance.set_depth_m(object.object->depth_m());
    instance.set_height_m(object.object->height_m());
  }
  CountPixels(view, annotations);
  return annotations;
}

}  // namespace flair::renderer
