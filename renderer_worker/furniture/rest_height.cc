// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/rest_height.h"

#include <algorithm>

namespace flair::renderer {

float RestHeightOf(std::string_view class_name, float height_m) {
  const float h = height_m;
  if (class_name == "bed") return h > 1.5F ? std::min(0.62F, 0.3F * h) : std::min(0.6F, 0.66F * h);
  if (class_name == "sofa" || class_name == "armchair") return std::min(0.44F, 0.55F * h);
  if (class_name == "daybed") return std::min(0.45F, 0.6F * h);
  if (class_name == "cot") return 0.45F * h;
  if (class_name == "chair" || class_name == "rocking_chair") return std::min(0.47F, 0.56F * h);
  if (class_name == "office_chair") return std::min(0.52F, 0.52F * h);
  if (class_name == "throne") return std::min(0.5F, 0.36F * h);
  if (class_name == "bench") return h > 0.65F ? 0.45F : h;
  if (class_name == "vanity") return h > 1 ? std::min(0.76F, 0.58F * h) : h;
  if (class_name == "sink") return h > 1 ? 0.9F : 0.75F * h;
  if (class_name == "basin") return h - std::min(0.14F, 0.16F * h);
  return h;
}

}  // namespace flair::renderer
