// SPDX-License-Identifier: GPL-3.0-or-later
// Options of solving, drawing, models and jobs.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr Range kFactor{.least = 0, .most = 1e9};

void CheckLambdas(const v1::Lambdas& lambdas, const Field& at) {
  if (lambdas.has_door_overlap()) at["door_overlap"].InRange(lambdas.door_overlap(), kFactor);
  if (lambdas.has_wall_attraction_divisor()) {
    at["wall_attraction_divisor"].InRange(lambdas.wall_attraction_divisor(),
                                          {.least = 0, .most = 1e9, .open_least = true});
  }
  if (lambdas.has_no_overlap()) at["no_overlap"].InRange(lambdas.no_overlap(), kFactor);
  if (lambdas.has_balanced()) at["balanced"].InRange(lambdas.balanced(), kFactor);
  if (lambdas.has_in_bounds()) at["in_bounds"].InRange(lambdas.in_bounds(), kFactor);
  if (lambdas.has_zone()) at["zone"].InRange(lambdas.zone(), kFactor);
  if (lambdas.has_tertiary_in_bounds()) at["tertiary_in_bounds"].InRange(lambdas.tertiary_in_bounds(), kFactor);
  if (lambdas.has_on_wall()) at["on_wall"].InRange(lambdas.on_wall(), kFactor);
}

void CheckTolerances(const v1::Tolerances& tolerances, const Field& at) {
  constexpr Range kTolerance{.least = 0, .most = 1e9, .open_least = true};
  if (tolerances.has_relative()) at["relative"].InRange(tolerances.relative(), kTolerance);
  if (tolerances.has_absolute()) at["absolute"].InRange(tolerances.absolute(), kTolerance);
  if (tolerances.has_max_evaluation_count()) {
    at["max_evaluation_count"].InRange(tolerances.max_evaluation_count(), {.least = 1, .most = 100000});
  }
}

}  // namespace

void Check(const v1::SolveOptions& options, const Field& at) {
  if (options.has_seed()) at["seed"].InRange(static_cast<double>(options.seed()), kSeed);
  if (options.has_max_restart_count()) {
    at["max_restart_count"].InRange(options.max_restart_count(), {.least = 1, .most = 10000});
  }
  if (options.has_thread_count()) at["thread_count"].InRange(options.thread_count(), {.least = 1, .most = 256});
  if (options.has_path_width_m()) at["path_width_m"].InRange(options.path_width_m(), {.least = 0, .most = 2});
  CheckLambdas(options.lambdas(), at["lambdas"]);
  CheckTolerances(options.tolerances(), at["tolerances"]);
  if (options.has_variant_count()) at["variant_count"].InRange(options.variant_count(), {.least = 1, .most = 32});
  if (!v1::MisfitPolicy_IsValid(options.misfit_policy())) {
    at["misfit_policy"].Reject("{} is no known value", int{options.misfit_policy()});
  }
  if (options.has_time_limit()) {
    const double seconds = static_cast<double>(options.time_limit().seconds()) + 1e-9 * options.time_limit().nanos();
    at["time_limit"].InRange(seconds, {.least = 0, .most = 315576000000.0, .open_least = true});
  }
}

void Check(const v1::ModelOptions& options, const Field& at) {
  const v1::ModelBudget& budget = options.budget();
  const Field limits = at["budget"];
  if (budget.has_call_count()) limits["call_count"].InRange(budget.call_count(), {.least = 0, .most = 100000});
  if (budget.has_token_count()) {
    limits["token_count"].InRange(static_cast<double>(budget.token_count()), {.least = 0, .most = 1e9});
  }
  if (budget.has_cost_usd()) limits["cost_usd"].InRange(budget.cost_usd(), {.least = 0, .most = 1e6});
}

void Check(const v1::JobSpec& spec, const Field& at) {
  Check(spec.brief(), at["brief"]);
  Check(spec.solve_options(), at["solve_options"]);
  Check(spec.render_options(), at["render_options"]);
  Check(spec.model_options(), at["model_options"]);
  if (!at["further_views"].Count(spec.further_views_size(), 0, 4, "views")) return;
  for (int i = 0; i < spec.further_views_size(); ++i) Check(spec.further_views(i), at["further_views"][i]);
}

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
