// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/provenance.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// A light that shines from within a piece, in its frame O.
struct LampLight {
  Vec3 position;
  Vec3 colour{1, 0.85F, 0.65F};  // linear RGB, largest component 1
  float intensity_cd = 60;       // in every direction
  float radius_m = 0.05F;        // of the shining ball
};

// What an object is shown as.
struct Furnishing {
  std::string class_name;  // one of the furniture classes; "box" when nothing better is known
  std::shared_ptr<const Mesh> mesh;
  std::vector<LampLight> lights;
  std::string asset_id;       // empty when the mesh was made by us
  std::string asset_licence;  // as its manifest says, such as "CC-BY-4.0"; empty when it does not
};

// Where furniture comes from. Thread-safe; the same object and style give the same mesh.
class FurnishingSource {
 public:
  virtual ~FurnishingSource() = default;
  // Never fails: what is not known becomes a decent box, what went wrong on the way is said in `diagnostics`.
  // `style` may be null.
  virtual Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                  std::vector<v1::Diagnostic>& diagnostics) const = 0;
};

}  // namespace flair::renderer
