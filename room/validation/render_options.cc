// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr Range kSize{.least = 256, .most = 8192};
// Nearer than this to straight up or down, a camera that stands upright has no direction.
constexpr double kLeastHorizontalShare = 0.01;

bool IsPlan(v1::PreviewView view) { return view == v1::PREVIEW_VIEW_PLAN || view == v1::PREVIEW_VIEW_UNSPECIFIED; }

bool IsVector(v1::PreviewFormat format) { return format == v1::PREVIEW_FORMAT_SVG || format == v1::PREVIEW_FORMAT_PDF; }

void CheckVector(const google::protobuf::RepeatedField<double>& vector, const Field& at) {
  if (vector.size() != 3) {
    at.Reject("has {} numbers; x, y and z in metres", vector.size());
    return;
  }
  for (int i = 0; i < 3; ++i) at[i].InRange(vector[i], kCoordinate);
}

void CheckCamera(const v1::ViewCamera& camera, const Field& at) {
  CheckVector(camera.eye_m(), at["eye_m"]);
  CheckVector(camera.target_m(), at["target_m"]);
  if (camera.has_field_of_view_rad()) {
    at["field_of_view_rad"].InRange(camera.field_of_view_rad(), {.least = 0.1, .most = 2.6});
  }
  if (camera.eye_m_size() != 3 || camera.target_m_size() != 3) return;
  double difference[3];
  for (int i = 0; i < 3; ++i) difference[i] = camera.target_m(i) - camera.eye_m(i);
  const double horizontal = std::hypot(difference[0], difference[1]);
  const double distance = std::hypot(horizontal, difference[2]);
  if (!std::isfinite(distance)) return;  // said already
  if (distance < 0.01) {
    at["target_m"].Reject("is at the eye; at least 0.01 m away");
  } else if (horizontal < kLeastHorizontalShare * distance) {
    at["target_m"].Reject("is straight {} the eye; at least {:.3g} m aside", difference[2] > 0 ? "above" : "below",
                          kLeastHorizontalShare * distance);
  }
}

void CheckFormat(const v1::RenderOptions& options, const Field& at) {
  if (!v1::PreviewView_IsValid(options.view())) at["view"].Reject("{} is no known value", int{options.view()});
  if (!v1::PreviewFormat_IsValid(options.format())) {
    at["format"].Reject("{} is no known value", int{options.format()});
  } else if (IsPlan(options.view()) && options.format() == v1::PREVIEW_FORMAT_EXR) {
    at["format"].Reject("EXR is for the ray-traced views; a plan is PNG, JPEG, TIFF, SVG or PDF");
  } else if (!IsPlan(options.view()) && IsVector(options.format())) {
    at["format"].Reject("{} is for plans; a ray-traced view is PNG, JPEG, TIFF or EXR",
                        options.format() == v1::PREVIEW_FORMAT_SVG ? "SVG" : "PDF");
  }
}

// Sizes that exclude each other: pixels, dots per inch, or none where the drawing has no pixels.
void CheckSize(const v1::RenderOptions& options, const Field& at) {
  if (options.has_size_px()) at["size_px"].InRange(options.size_px(), kSize);
  if (options.has_dpi()) at["dpi"].InRange(options.dpi(), {.least = 36, .most = 1200});
  if (options.has_size_px() && options.has_dpi()) {
    at["size_px"].Reject("{} and dpi {} say both how large the picture is; one of them", options.size_px(),
                         options.dpi());
  }
  if (IsVector(options.format()) && options.has_size_px()) {
    at["size_px"].Reject("{} has no meaning for SVG and PDF, whose size is that of the paper; leave it out",
                         options.size_px());
  }
  if (IsVector(options.format()) && options.has_dpi()) {
    at["dpi"].Reject("{} has no meaning for SVG and PDF, which have no dots; leave it out", options.dpi());
  }
}

void CheckLayers(const v1::RenderOptions& options, const Field& at) {
  std::set<int> seen;
  for (int i = 0; i < options.layers_size(); ++i) {
    const bool is_known = at[i].Enum(options.layers(i), v1::PlanLayer_IsValid(options.layers(i)));
    if (is_known && !seen.insert(options.layers(i)).second) {
      at[i].Reject("{} stands there twice", v1::PlanLayer_Name(options.layers(i)));
    }
  }
}

// What only the other kind of view has a use for.
void CheckUse(const v1::RenderOptions& options, const Field& at) {
  if (IsPlan(options.view())) {
    constexpr char kOnly[] = "is for the ray-traced views; leave it out for a plan";
    if (options.has_sample_count()) at["sample_count"].Reject("{} {}", options.sample_count(), kOnly);
    if (options.seed() != 0) at["seed"].Reject("{} {}", options.seed(), kOnly);
    if (options.has_camera()) at["camera"].Reject("{}", kOnly);
    return;
  }
  constexpr char kOnly[] = "is for plans; leave it out for a ray-traced view";
  if (options.has_dpi()) at["dpi"].Reject("{} {}; size_px says its pixels", options.dpi(), kOnly);
  if (options.paper() != v1::PAPER_SIZE_UNSPECIFIED) at["paper"].Reject("{}", kOnly);
  if (options.has_scale_denominator()) at["scale_denominator"].Reject("{} {}", options.scale_denominator(), kOnly);
  if (options.layers_size() > 0) at["layers"].Reject("{}", kOnly);
}

}  // namespace

void Check(const v1::RenderOptions& options, const Field& at) {
  CheckFormat(options, at);
  CheckSize(options, at);
  if (!v1::PaperSize_IsValid(options.paper())) at["paper"].Reject("{} is no known value", int{options.paper()});
  if (options.has_scale_denominator()) {
    at["scale_denominator"].InRange(options.scale_denominator(), {.least = 5, .most = 1000});
  }
  CheckLayers(options, at["layers"]);
  if (options.has_sample_count()) at["sample_count"].InRange(options.sample_count(), {.least = 1, .most = 4096});
  if (options.has_camera()) CheckCamera(options.camera(), at["camera"]);
  CheckUse(options, at);
}

void Check(const v1::ContactSheetOptions& options, const Field& at) {
  at["request_id"].Text(options.request_id(), 0, 128);
  at["title"].Text(options.title(), 0, 200);
  at["tile_count"].InRange(options.tile_count(), {.least = 1, .most = 10000});
  if (options.has_tile_px()) at["tile_px"].InRange(options.tile_px(), {.least = 64, .most = 1024});
  switch (options.format()) {
    case v1::PREVIEW_FORMAT_UNSPECIFIED:
    case v1::PREVIEW_FORMAT_PNG:
    case v1::PREVIEW_FORMAT_JPEG:
    case v1::PREVIEW_FORMAT_TIFF:
      break;
    default:
      at["format"].Reject("{}; a contact sheet is PNG, JPEG or TIFF", v1::PreviewFormat_IsValid(options.format())
                                                                          ? v1::PreviewFormat_Name(options.format())
                                                                          : std::to_string(int{options.format()}));
  }
}

// The picture itself is not checked: a tile that cannot be drawn says so in its place.
void Check(const v1::ContactSheetTile& tile, const Field& at) {
  at["caption"].Text(tile.caption(), 0, 200);
  at["remark"].Text(tile.remark(), 0, 400);
  if (tile.picture_case() == v1::ContactSheetTile::PICTURE_NOT_SET && tile.remark().empty()) {
    at["picture"].Reject("is not set; solved_layout or image, or a remark that says why there is none");
  }
}

}  // namespace flair::validation
