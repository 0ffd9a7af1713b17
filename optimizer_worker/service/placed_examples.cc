// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/placed_examples.h"

#include <utility>

#include "optimizer_worker/constraints/call_text.h"
#include "room/conversion/conversion.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

constexpr double kUsualHeight_m = 0.5;
constexpr double kMarkerExtent_m = 0.1;

// Whether it counts for the mean point of its zone; see ZoneCenters.
bool CountsForZone(const Object& object) {
  return object.kind == ObjectKind::kFloor && object.role != ObjectRole::kTertiary;
}

// Primaries and secondaries stand on the floor and belong to a zone.
void GiveRolesAndZones(Scene& scene) {
  const bool has_zones = !scene.zones.empty();
  if (!has_zones) scene.zones.push_back({.id = "room", .name = "room"});
  for (Object& object : scene.objects) {
    if (object.height_m == 0) object.height_m = kUsualHeight_m;
    const bool zoneless = object.zone < 0 && has_zones;
    if (object.kind != ObjectKind::kFloor || zoneless) object.role = ObjectRole::kTertiary;
    if (object.zone < 0 && !has_zones && CountsForZone(object)) object.zone = 0;
  }
}

// Where one more object of the zone has to stand for the mean point of all to be `center`.
Vec2<double> Counterweight(const SceneText& text, int zone, const Vec2<double>& center) {
  Vec2<double> place = center;
  for (size_t i = 0; i < text.scene.objects.size(); ++i) {
    if (text.scene.objects[i].zone == zone && CountsForZone(text.scene.objects[i])) {
      place += center - Vec2<double>{text.layout[i].x_m, text.layout[i].y_m};
    }
  }
  return place;
}

void MarkZoneCenters(SceneText& text) {
  std::vector<Vec2<double>> places;
  for (size_t zone = 0; zone < text.zone_centers.size(); ++zone) {
    places.push_back(Counterweight(text, static_cast<int>(zone), text.zone_centers[zone]));
  }
  for (size_t zone = 0; zone < places.size(); ++zone) {
    Object marker;
    marker.id = marker.name = text.scene.zones[zone].id + "_marker";
    marker.zone = static_cast<int>(zone);
    marker.footprint = {.width_m = kMarkerExtent_m, .depth_m = kMarkerExtent_m};
    marker.height_m = kMarkerExtent_m;
    text.scene.objects.push_back(std::move(marker));
    text.layout.push_back({.x_m = places[zone].x, .y_m = places[zone].y, .theta_rad = 0});
  }
}

v1::PlacedExample ToMessage(SceneText text, const ConstraintFacts& facts, const LayoutExample& example) {
  GiveRolesAndZones(text.scene);
  MarkZoneCenters(text);
  v1::LayoutGraph graph = GraphFromScene(text.scene);
  v1::PlacedExample message;
  *message.mutable_room() = std::move(*graph.mutable_room());
  message.mutable_room()->set_room_type("room");
  *message.mutable_zone_plan() = std::move(*graph.mutable_zone_plan());
  *message.mutable_object_list() = std::move(*graph.mutable_object_list());
  *message.mutable_placements() = PlacementsFromPoses(text.scene, text.layout);
  for (v1::Argument& argument : ArgumentsFromText(facts, example.call)) *message.add_arguments() = std::move(argument);
  message.set_satisfied(example.satisfied);
  return message;
}

}  // namespace

google::protobuf::RepeatedPtrField<v1::PlacedExample> PlacedExamplesOf(const ConstraintFacts& facts) {
  google::protobuf::RepeatedPtrField<v1::PlacedExample> examples;
  for (const LayoutExample& example : facts.layouts) {
    absl::StatusOr<SceneText> text = ParseScene(example.scene);
    // A text that cannot be read is found by the battery of tests.
    if (text.ok()) *examples.Add() = ToMessage(*std::move(text), facts, example);
  }
  return examples;
}

}  // namespace flair::optimizer
