// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/annotations.h"

#include <algorithm>

namespace flair::renderer {
namespace {

void CountPixels(const TracedView& view, v1::ViewAnnotations& annotations) {
  for (int y = 0; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; ++x) {
      const int id = view.instance[static_cast<size_t>(y) * view.width_px + x];
      if (id <= 0) continue;
      v1::Instance& instance = *annotations.mutable_instances(id - 1);
      v1::PixelBox& box = *instance.mutable_pixel_box();
      const bool first = instance.visible_pixel_count() == 0;
      instance.set_visible_pixel_count(instance.visible_pixel_count() + 1);
      box.set_left(first ? x : std::min(box.left(), x));
      box.set_top(first ? y : std::min(box.top(), y));
      box.set_right(first ? x + 1 : std::max(box.right(), x + 1));
      box.set_bottom(first ? y + 1 : std::max(box.bottom(), y + 1));
    }
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
