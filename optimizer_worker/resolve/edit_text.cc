// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fmt/format.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/read_number.h"

namespace flair::optimizer {
namespace {

using Words = std::vector<std::string>;
using Edit = absl::StatusOr<v1::LayoutEdit>;

// "1.5x0.6x2.1" as numbers; empty when it is none.
std::vector<double> ExtentsFrom(const std::string& word) {
  std::vector<double> extents;
  std::istringstream parts(word);
  for (std::string part; std::getline(parts, part, 'x');) {
    const std::optional<double> extent = ReadNumber(part);
    if (!extent) return {};
    extents.push_back(*extent);
  }
  return extents;
}

absl::Status Should(const char* form) { return InvalidArgument("should be: {}", form); }

Edit Move(const Words& words, const v1::SolvedLayout& layout) {
  constexpr const char* kForm = "move OBJECT X Y [HEADING], metres and degrees";
  if (words.size() < 4 || words.size() > 5) return Should(kForm);
  const std::optional<double> x = ReadNumber(words[2]), y = ReadNumber(words[3]);
  if (!x || !y) return Should(kForm);
  v1::LayoutEdit edit;
  v1::Placement& target = *edit.mutable_move_object();
  target.set_object_id(words[1]);
  target.set_x_m(*x);
  target.set_y_m(*y);
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == words[1]) target.set_theta_rad(placement.theta_rad());
  }
  if (words.size() == 5) {
    const std::optional<double> heading = ReadNumber(words[4]);
    if (!heading) return Should(kForm);
    target.set_theta_rad(WrapHeading(*heading * kPi / 180));
  }
  return edit;
}

Edit Resize(const Words& words) {
  constexpr const char* kForm = "resize OBJECT WIDTHxDEPTH[xHEIGHT], metres";
  if (words.size() != 3) return Should(kForm);
  const std::vector<double> extents = ExtentsFrom(words[2]);
  if (extents.size() != 2 && extents.size() != 3) return Should(kForm);
  v1::LayoutEdit edit;
  v1::ResizeObject& resize = *edit.mutable_resize_object();
  resize.set_object_id(words[1]);
  resize.set_width_m(extents[0]);
  resize.set_depth_m(extents[1]);
  if (extents.size() == 3) resize.set_height_m(extents[2]);
  return edit;
}

// The zone of an object; of the first one when there is no such object.
std::string ZoneOf(const v1::LayoutGraph& graph, const std::string& object_id) {
  for (const v1::Object& object : graph.object_list().objects()) {
    if (object.id() == object_id && !object.zone_id().empty()) return object.zone_id();
  }
  return graph.zone_plan().zones_size() > 0 ? graph.zone_plan().zones(0).id() : "";
}

Edit Add(const Words& words, const v1::LayoutGraph& graph) {
  constexpr const char* kForm = "add OBJECT WIDTHxDEPTHxHEIGHT [near OBJECT], metres";
  if (words.size() != 3 && (words.size() != 5 || words[3] != "near")) return Should(kForm);
  const std::vector<double> extents = ExtentsFrom(words[2]);
  if (extents.size() != 3) return Should(kForm);
  v1::LayoutEdit edit;
  v1::AddObject& add = *edit.mutable_add_object();
  v1::Object& object = *add.mutable_object();
  object.set_id(words[1]);
  object.set_name(words[1]);
  object.set_role(v1::OBJECT_ROLE_SECONDARY);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(extents[0]);
  object.set_depth_m(extents[1]);
  object.set_height_m(extents[2]);
  object.set_requested(true);
  object.set_zone_id(ZoneOf(graph, words.size() == 5 ? words[4] : ""));
  if (words.size() == 5) {
    v1::ConstraintEdge edge = EdgeFromText(kNearCall, fmt::format("object={} target={}", words[1], words[4]));
    edge.clear_id();
    *add.add_edges() = std::move(edge);
  }
  return edit;
}

Edit Weigh(const Words& words) {
  constexpr const char* kForm = "weight EDGE NUMBER";
  if (words.size() != 3) return Should(kForm);
  const std::optional<double> weight = ReadNumber(words[2]);
  if (!weight) return Should(kForm);
  v1::LayoutEdit edit;
  edit.mutable_set_edge_weight()->set_edge_id(words[1]);
  edit.mutable_set_edge_weight()->set_weight(*weight);
  return edit;
}

Edit AddEdge(const Words& words) {
  if (words.size() < 3) return Should("edge TYPE NAME=VALUE ...");
  std::string call;
  double weight = 1;
  for (size_t i = 2; i < words.size(); ++i) {
    if (words[i].rfind("weight=", 0) == 0) {
      const std::optional<double> given = ReadNumber(words[i].substr(7));
      if (!given) return Should("edge TYPE NAME=VALUE ... weight=NUMBER");
      weight = *given;
      continue;
    }
    call += words[i] + " ";
  }
  v1::LayoutEdit edit;
  *edit.mutable_add_edge() = EdgeFromText(words[1], call);
  edit.mutable_add_edge()->clear_id();
  edit.mutable_add_edge()->set_weight(weight);
  return edit;
}

// "pin bed" and the like: a verb and an id.
Edit OneId(const Words& words) {
  if (words.size() != 2) return Should(fmt::format("{} ID", words[0]).c_str());
  v1::LayoutEdit edit;
  if (words[0] == "pin") edit.set_pin_object_id(words[1]);
  if (words[0] == "unpin") edit.set_unpin_object_id(words[1]);
  if (words[0] == "remove") edit.set_remove_object_id(words[1]);
  if (words[0] == "drop") edit.set_remove_edge_id(words[1]);
  return edit;
}

}  // namespace

absl::StatusOr<v1::LayoutEdit> EditFromText(std::string_view line, const v1::SolvedLayout& layout) {
  Words words;
  std::istringstream stream{std::string(line)};
  for (std::string word; stream >> word;) words.push_back(word);
  const std::string verb = words.empty() ? "" : words[0];
  Edit edit =
      absl::InvalidArgumentError("should begin with move, pin, unpin, resize, add, remove, edge, drop or weight");
  if (verb == "move") edit = Move(words, layout);
  if (verb == "resize") edit = Resize(words);
  if (verb == "add") edit = Add(words, layout.graph());
  if (verb == "weight") edit = Weigh(words);
  if (verb == "edge") edit = AddEdge(words);
  if (verb == "pin" || verb == "unpin" || verb == "remove" || verb == "drop") edit = OneId(words);
  if (edit.ok()) return edit;
  return InvalidArgument("edit \"{}\": {}", line, edit.status().message());
}

}  // namespace flair::optimizer
