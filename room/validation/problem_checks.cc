// SPDX-License-Identifier: GPL-3.0-or-later
// What is put into a room and where: objects, styles, edges and their types, layouts, and the artifacts that hold them.
#include <algorithm>
#include <cmath>

#include "room/validation/checks.h"

namespace flair::validation {

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
  for (int i = 0; i < type.anchors_size(); ++i) {
    at["anchors"][i].Refers(type.anchors(i), parameters, "a parameter");
  }
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

}  // namespace

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

}  // namespace flair::validation
