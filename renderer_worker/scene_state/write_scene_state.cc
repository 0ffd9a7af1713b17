// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene_state/write_scene_state.h"

#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>

#include "fmt/format.h"
#include "renderer_worker/gltf/gltf.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kRoomId[] = "room";

// Without the noise of the last bits; never -0.
double Tidy(double value) { return std::round(value * 1e9) / 1e9 + 0.0; }

Json Point(const v1::Point2& p) { return {Tidy(p.x_m()), Tidy(p.y_m()), 0.0}; }

Json FloorOf(const v1::Room& room) {
  Json floor = {{"id", "floor"}, {"roomId", kRoomId}, {"type", "Floor"}, {"depth", 0.05}};
  Json points = Json::array();
  for (const v1::Point2& corner : room.floor().vertices()) points.push_back(Point(corner));
  floor["points"] = std::move(points);
  return floor;
}

// A hole is a rectangle in the wall, measured from the wall's first point and the floor.
Json HolesOf(const v1::Room& room, const std::string& wall) {
  Json holes = Json::array();
  for (const v1::Opening& opening : room.openings()) {
    if (opening.wall() != wall) continue;
    holes.push_back({{"id", opening.id()},
                     {"type", opening.kind() == v1::OPENING_KIND_DOOR ? "Door" : "Window"},
                     {"box",
                      {{"min", {Tidy(opening.offset_m()), Tidy(opening.sill_height_m())}},
                       {"max", {Tidy(opening.offset_m() + opening.width_m()), Tidy(opening.head_height_m())}}}}});
  }
  return holes;
}

Json ArchOf(const v1::Room& room) {
  Json elements = Json::array({FloorOf(room)});
  const auto& corners = room.floor().vertices();
  for (int i = 0; i < room.walls_size() && i < corners.size(); ++i) {
    const std::string& name = room.walls(i).name();
    elements.push_back({{"id", "wall_" + name},
                        {"roomId", kRoomId},
                        {"type", "Wall"},
                        {"height", Tidy(room.height_m())},
                        {"depth", 0.1},
                        {"points", {Point(corners[i]), Point(corners[(i + 1) % corners.size()])}},
                        {"holes", HolesOf(room, name)}});
  }
  return {{"version", "arch@1.0.2"},
          {"up", {0, 0, 1}},
          {"front", {0, 1, 0}},
          {"coords2d", {0, 1}},
          {"scaleToMeters", 1.0},
          {"id", "flair"},
          {"defaults", {{"Wall", {{"depth", 0.1}, {"extraHeight", 0.0}}}, {"Floor", {{"depth", 0.05}}}}},
          {"elements", std::move(elements)},
          {"regions", Json::array()}};
}

// From the mesh's frame, glTF's (x, y, z) = O's (-x, z, y), to R: a turn by theta and the place.
Json TransformOf(const v1::Placement& p) {
  const double c = Tidy(std::cos(p.theta_rad()));
  const double s = Tidy(std::sin(p.theta_rad()));
  const Json data = {-c, -s, 0.0, 0.0, 0.0,           0.0,           1.0,           0.0,
                     -s, c,  0.0, 0.0, Tidy(p.x_m()), Tidy(p.y_m()), Tidy(p.z_m()), 1.0};
  return {{"rows", 4}, {"cols", 4}, {"data", data}};
}

// SceneEval splits a modelId at its dot.
std::string ModelName(const std::string& id) {
  std::string name = id;
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    if (!plain) c = '_';
  }
  return name;
}

// One per object, unique.
std::vector<std::string> ModelNames(const Scene& scene) {
  std::vector<std::string> names;
  std::map<std::string, int> seen;
  for (const SceneObject& shown : scene.objects) {
    std::string name = ModelName(shown.object->id());
    for (int number = ++seen[name]; number > 1; number = ++seen[name]) name = fmt::format("{}_{}", name, number);
    names.push_back(std::move(name));
  }
  return names;
}

absl::StatusOr<Json> ObjectsOf(const Scene& scene) {
  const std::vector<std::string> names = ModelNames(scene);
  std::map<std::string, size_t> index_of;
  for (size_t i = 0; i < scene.objects.size(); ++i) index_of.emplace(scene.objects[i].object->id(), i);
  Json objects = Json::array();
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& shown = scene.objects[i];
    const v1::Placement& p = shown.placement;
    RETURN_IF_ERROR(CheckFinite(p));
    const auto host = index_of.find(shown.object->host_id());
    Json object = {{"id", shown.object->id()},
                   {"index", i},
                   {"modelId", fmt::format("{}.{}", kSceneStateAssetPrefix, names[i])},
                   {"parentId", host == index_of.end() ? "" : shown.object->host_id()},
                   {"parentIndex", host == index_of.end() ? -1 : static_cast<int>(host->second)},
                   {"transform", TransformOf(p)}};
    objects.push_back(std::move(object));
  }
  return objects;
}

// What the benchmark's judges are told of an object.
Json AnnotationsOf(const SceneObject& shown) {
  const v1::Object& object = *shown.object;
  std::string description = object.description();
  std::string materials;
  if (shown.style != nullptr) {
    if (description.empty()) description = shown.style->description();
    materials = shown.style->material();
  }
  Json annotations = {{"category", object.name()}, {"description", description}, {"materials", materials},
                      {"width", object.width_m()}, {"depth", object.depth_m()},  {"height", object.height_m()}};
  if (!shown.furnishing.asset_id.empty()) {
    annotations["source"] = shown.furnishing.asset_id;
    annotations["licence"] = shown.furnishing.asset_licence;
  }
  return {{"annotations", std::move(annotations)}};
}

// JSON throws at what is no UTF-8.
absl::StatusOr<std::string> Text(const Json& json) {
  try {
    return json.dump(1) + "\n";
  } catch (const std::exception& failure) {
    return Internal("the SceneState could not be written: {}", failure.what());
  }
}

}  // namespace

absl::StatusOr<std::string> WriteSceneState(const Scene& scene) {
  ASSIGN_OR_RETURN(Json objects, ObjectsOf(scene));
  const v1::Room& room = scene.layout->graph().room();
  Json state = {{"format", "sceneState"},
                {"scene",
                 {{"version", "scene@1.0.2"},
                  {"id", room.room_type()},
                  {"up", {0, 0, 1}},
                  {"front", {0, 1, 0}},
                  {"unit", 1.0},
                  {"assetSource", Json::array({kSceneStateAssetPrefix})},
                  {"arch", ArchOf(room)},
                  {"object", std::move(objects)}}},
                {"selected", Json::array()}};
  return Text(state);
}

absl::StatusOr<std::vector<SceneStateFile>> SceneStateAssets(const Scene& scene) {
  const std::vector<std::string> names = ModelNames(scene);
  std::vector<SceneStateFile> files;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& shown = scene.objects[i];
    ASSIGN_OR_RETURN(std::string glb, WriteMeshGlb(*shown.furnishing.mesh, shown.object->name()));
    ASSIGN_OR_RETURN(std::string annotations, Text(AnnotationsOf(shown)));
    files.push_back({fmt::format("{0}/{0}.glb", names[i]), std::move(glb)});
    files.push_back({fmt::format("{}/data.json", names[i]), std::move(annotations)});
  }
  return files;
}

}  // namespace flair::renderer
