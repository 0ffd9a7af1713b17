// SPDX-License-Identifier: GPL-3.0-or-later
// Options of solving and drawing, and requests.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "room/validation/checks.h"

namespace flair::validation {

void Check(const v1::SolveOptions& options, const Known&, const Field& at) {
  if (!options.has_time_limit()) return;
  const double seconds = static_cast<double>(options.time_limit().seconds()) + 1e-9 * options.time_limit().nanos();
  at["time_limit"].InRange(seconds, {.least = 0, .most = 315576000000.0, .open_least = true});
}

namespace {

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

void CheckFormat(const v1::RenderOptions& options, const Field& at) {
  if (IsPlan(options.view()) && options.format() == v1::PREVIEW_FORMAT_EXR) {
    at["format"].Reject("EXR is for the ray-traced views; a plan is PNG, JPEG, TIFF, SVG or PDF");
  } else if (!IsPlan(options.view()) && IsVector(options.format())) {
    at["format"].Reject("{} is for plans; a ray-traced view is PNG, JPEG, TIFF or EXR",
                        options.format() == v1::PREVIEW_FORMAT_SVG ? "SVG" : "PDF");
  }
}

// Sizes that exclude each other: pixels, dots per inch, or none where the drawing has no pixels.
void CheckSize(const v1::RenderOptions& options, const Field& at) {
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
    if (v1::PlanLayer_IsValid(options.layers(i)) && !seen.insert(options.layers(i)).second) {
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

void Check(const v1::RenderOptions& options, const Known&, const Field& at) {
  CheckFormat(options, at);
  CheckSize(options, at);
  CheckLayers(options, at["layers"]);
  CheckUse(options, at);
}

void Check(const v1::ViewCamera& camera, const Known&, const Field& at) {
  CheckVector(camera.eye_m(), at["eye_m"]);
  CheckVector(camera.target_m(), at["target_m"]);
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

void Check(const v1::ContactSheetOptions& options, const Known&, const Field& at) {
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

void Check(const v1::ContactSheetTile& tile, const Known&, const Field& at) {
  if (tile.picture_case() == v1::ContactSheetTile::PICTURE_NOT_SET && tile.remark().empty()) {
    at["picture"].Reject("is not set; solved_layout or image, or a remark that says why there is none");
  }
}

void Check(const v1::SolveRestartsRequest& request, const Known& known, const Field& at) {
  const NameSet stages = {"primary", "secondary", "tertiary", "polish"};
  if (at["stage"].Refers(request.stage(), stages, "a stage") && request.stage() == "secondary") {
    at["zone_id"].Refers(request.zone_id(), known.zones == nullptr ? NameSet() : *known.zones, "a zone");
  }
}

void Check(const v1::RenderRequest& request, const Known&, const Field& at) {
  if (!request.beside().empty() && !IsPlan(request.options().view())) {
    at["beside"].Reject("is for plans; leave it out for a ray-traced view");
  }
}

void Check(const v1::CreateBatchRequest& request, const Known&, const Field& at) {
  if (!request.open()) at["specs"].Count(request.specs_size(), 1, 10000, "jobs");
}

}  // namespace flair::validation
