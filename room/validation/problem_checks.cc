// SPDX-License-Identifier: GPL-3.0-or-later
// What is put into a room and where: objects, styles, edges and their types, layouts, and the artifacts that hold them.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "room/validation/field.h"

namespace flair::validation {
namespace {

void CheckArgument(const v1::Argument& argument, const Field& at) {
  const Field value = at["value"];
  switch (argument.value().value_case()) {
    case v1::ArgumentValue::kText:
      value["text"].Text(argument.value().text(), 1, 200);
      break;
    case v1::ArgumentValue::kTexts:
      if (!value["texts"].Count(argument.value().texts().items_size(), 1, 1000, "items")) break;
      for (int i = 0; i < argument.value().texts().items_size(); ++i) {
        value["texts"]["items"][i].Text(argument.value().texts().items(i), 1, 200);
      }
      break;
    case v1::ArgumentValue::kNumber:
      if (!std::isfinite(argument.value().number()))
        value["number"].Reject("{} is not a number", argument.value().number());
      break;
    case v1::ArgumentValue::kFlag:
      break;
    case v1::ArgumentValue::VALUE_NOT_SET:
      value.Reject("is not set");
  }
}

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

void Check(const v1::Object& object, const Known&, const Field& at) {
  const bool standing = object.role() == v1::OBJECT_ROLE_PRIMARY || object.role() == v1::OBJECT_ROLE_SECONDARY;
  if (standing && object.kind() != v1::OBJECT_KIND_FLOOR && object.kind() != v1::OBJECT_KIND_UNSPECIFIED) {
    at["kind"].Reject("is {} for a {}; primaries and secondaries stand on the floor",
                      v1::ObjectKind_Name(object.kind()), v1::ObjectRole_Name(object.role()));
  }
  if (object.walk_over() && object.kind() != v1::OBJECT_KIND_FLOOR) {
    at["walk_over"].Reject("is set for {}; only what lies on the floor is walked over",
                           v1::ObjectKind_Name(object.kind()));
  }
  if (standing && object.zone_id().empty())
    at["zone_id"].Reject("is empty; every primary and secondary belongs to a zone");
}

void Check(const v1::ObjectList& list, const Known&, const Field& at) {
  const NameSet ids = IdsOf(list.objects());
  for (int i = 0; i < list.objects_size(); ++i) {
    const v1::Object& object = list.objects(i);
    if (object.host_id().empty()) continue;
    const Field host = at["objects"][i]["host_id"];
    if (host.Refers(object.host_id(), ids, "an object") && object.host_id() == object.id()) {
      host.Reject("\"{}\" is the object itself", object.id());
    }
  }
}

void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at) {
  const NameSet surface_names = {"walls", "floor", "ceiling"};
  for (int i = 0; i < sheet.surfaces_size(); ++i) {
    at["surfaces"][i]["surface"].Refers(sheet.surfaces(i).surface(), surface_names, "a surface");
  }
  if (known.objects == nullptr || known.openings == nullptr) return;
  for (int i = 0; i < sheet.objects_size(); ++i) {
    const std::string& subject = sheet.objects(i).subject_id();
    if (known.openings->contains(subject)) continue;
    at["objects"][i]["subject_id"].Refers(subject, *known.objects, "an object or opening");
  }
}

void Check(const v1::ParameterSpec& parameter, const Known&, const Field& at) {
  const bool bounded = parameter.has_min_number() && parameter.has_max_number();
  if (bounded && !(parameter.min_number() <= parameter.max_number())) {
    at["min_number"].Reject("{} is above max_number {}", parameter.min_number(), parameter.max_number());
  }
  if (parameter.required() && parameter.has_default_value()) at["default_value"].Reject("is set, but it is required");
}

void Check(const v1::ConstraintType& type, const Known&, const Field& at) {
  NameSet parameters;
  for (const v1::ParameterSpec& parameter : type.parameters()) parameters.insert(parameter.name());
  for (int i = 0; i < type.examples_size(); ++i) {
    const Field arguments = at["examples"][i]["arguments"];
    for (int k = 0; k < type.examples(i).arguments_size(); ++k) {
      arguments[k]["name"].Refers(type.examples(i).arguments(k).name(), parameters, "a parameter");
    }
  }
  for (int i = 0; i < type.anchors_size(); ++i) at["anchors"][i].Refers(type.anchors(i), parameters, "a parameter");
}

void Check(const v1::ConstraintCatalog& catalog, const Known&, const Field& at) {
  NameSet names;  // aliases share them
  for (int i = 0; i < catalog.types_size(); ++i) at["types"][i]["name"].NewId(catalog.types(i).name(), names);
  for (int i = 0; i < catalog.types_size(); ++i) {
    const v1::ConstraintType& type = catalog.types(i);
    for (int k = 0; k < type.aliases_size(); ++k) {
      if (type.aliases(k) != type.name()) at["types"][i]["aliases"][k].NewId(type.aliases(k), names);
    }
  }
}

void Check(const v1::Participant& participant, const Known&, const Field& at) {
  if (participant.thing_case() == v1::Participant::THING_NOT_SET)
    at["object_id"].Reject("is not set, nor zone_id, wall or part; it is one of them");
}

void Check(const v1::Measure& measure, const Known&, const Field& at) {
  if (!measure.has_min_m() && !measure.has_max_m()) at["min_m"].Reject("is not set, nor is max_m");
  if (measure.has_min_m() && measure.has_max_m() && measure.min_m() > measure.max_m())
    at["min_m"].Reject("{} is above max_m {}", measure.min_m(), measure.max_m());
}

void Check(const v1::ConstraintEdge& edge, const Known&, const Field& at) {
  NameSet names;
  for (int i = 0; i < edge.arguments_size(); ++i) {
    at["arguments"][i]["name"].NewId(edge.arguments(i).name(), names);
    CheckArgument(edge.arguments(i), at["arguments"][i]);
  }
}

void Check(const v1::LayoutGraph& graph, const Known& known, const Field& at) {
  for (const v1::Opening& opening : graph.room().openings()) {
    if (known.objects == nullptr || !known.objects->contains(opening.id())) continue;
    at["object_list"].Reject("\"{}\" is an object and an opening; ids differ", opening.id());
  }
  // A pinned object may stick out of the room, which the solve reports; further away it is a slip of the pen.
  constexpr double kPinMargin_m = 1;
  double least_x = 0, most_x = 0, least_y = 0, most_y = 0;
  for (const v1::Point2& p : graph.room().floor().vertices()) {
    least_x = std::min(least_x, p.x_m());
    most_x = std::max(most_x, p.x_m());
    least_y = std::min(least_y, p.y_m());
    most_y = std::max(most_y, p.y_m());
  }
  for (int i = 0; i < graph.pinned_placements_size(); ++i) {
    const v1::Placement& pin = graph.pinned_placements(i);
    at["pinned_placements"][i]["x_m"].InRange(pin.x_m(),
                                              {.least = least_x - kPinMargin_m, .most = most_x + kPinMargin_m});
    at["pinned_placements"][i]["y_m"].InRange(pin.y_m(),
                                              {.least = least_y - kPinMargin_m, .most = most_y + kPinMargin_m});
  }
}

void Check(const v1::ZoneRegion& region, const Known&, const Field& at) {
  for (int k = 0; k < region.parts_size(); ++k) {
    for (const v1::Point2& p : region.parts(k).vertices()) {
      at["parts"][k].InRange(p.x_m(), kCoordinate);
      at["parts"][k].InRange(p.y_m(), kCoordinate);
    }
  }
}

void Check(const v1::SolvedLayout& layout, const Known&, const Field& at) {
  if (!std::isfinite(layout.total_cost())) at["total_cost"].Reject("{} is not a number", layout.total_cost());
}

void Check(const v1::Preview& preview, const Known&, const Field& at) {
  const bool is_page = preview.format() == v1::PREVIEW_FORMAT_SVG || preview.format() == v1::PREVIEW_FORMAT_PDF;
  const double least = is_page ? 0 : 1;  // pages have no pixels
  at["width_px"].InRange(preview.width_px(), {.least = least, .most = 16384});
  at["height_px"].InRange(preview.height_px(), {.least = least, .most = 16384});
  if (preview.image().empty()) at["image"].Reject("is empty");
  const int matrix_size = preview.annotations().camera().camera_from_room_size();
  if (matrix_size != 0 && matrix_size != 16) {
    at["annotations"]["camera"]["camera_from_room"].Reject("has {} numbers; 16", matrix_size);
  }
}

void Check(const v1::Report& report, const Known&, const Field& at) {
  constexpr Range kShare{.least = 0, .most = 1};
  constexpr Range kPercent{.least = 0, .most = 1e9};
  const v1::LayoutMetrics& metrics = report.metrics();
  at["metrics"]["oob_percent"].InRange(metrics.oob_percent(), kPercent);
  at["metrics"]["oor_percent"].InRange(metrics.oor_percent(), kPercent);
  at["metrics"]["reachable_floor_share"].InRange(metrics.reachable_floor_share(), kShare);
  at["metrics"]["reachable_front_share"].InRange(metrics.reachable_front_share(), kShare);
}

void Check(const v1::Artifact& artifact, const Known&, const Field& at) {
  if (artifact.content_case() == v1::Artifact::CONTENT_NOT_SET) at["content"].Reject("is not set");
}

// Options of solving and drawing, and requests.

void Check(const v1::SolveOptions& options, const Known&, const Field& at) {
  if (!options.has_time_limit()) return;
  const double seconds = static_cast<double>(options.time_limit().seconds()) + 1e-9 * options.time_limit().nanos();
  at["time_limit"].InRange(seconds, {.least = 0, .most = 315576000000.0, .open_least = true});
}

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
