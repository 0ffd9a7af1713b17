// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/drawing/box.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/furniture/furniture.pb.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// The colours one object is drawn in: what says most of it, its lines, its frame, its upholstery.
struct Ink {
  Rgb fill;
  Rgb line;
  Rgb hard = fill;
  Rgb soft = fill;
};

// Draws the plan symbol `plan.NAME` of furniture/pieces/ in object frame O: origin in the middle, x to the right of
// someone who stands behind the object and looks the way it faces, y to its front, metres. Symbols fill exactly
// [-width/2, width/2] x [-depth/2, depth/2]. The canvas must be in frame O already. Where there is no such symbol, or
// its script fails, a plain block is drawn and the error returned. Thread-safe for different canvases.
//
// What scripts draw with; any box {x0, y0, x1, y1} may be given in any corner order, points are {x, y}:
//   area(box, tone, line = "outline", corner radius = 0)
//   oval(centre, radius_x, radius_y, tone, line = "detail")
//   shape(points, tone, line = "outline")
//   segment(from, to, line = "detail")
//   curve(from, control, control, to, line = "detail")
// Tones: none, body, light, pale, dark, deep (of the object's colour), hard, soft (of its parts), water, glass, leaf,
// wood, metal, fire. Lines: none, outline, detail, faint, dashed.
absl::Status DrawSymbol(Canvas& canvas, const Ink& ink, double width_m, double depth_m, std::string_view name);

// What is drawn beside walls and openings; as it is when nothing is asked for.
struct PlanLayers {
  bool floor_pieces = true;
  bool tertiary = true;
  bool zones = false;
  bool dimensions = true;
  bool constraints = false;
  bool circulation = false;
};

// The layers of the options; INVALID_ARGUMENT for one that does not exist.
absl::StatusOr<PlanLayers> LayersOf(const v1::RenderOptions& options);

// What a plan shows, free of messages: everything resolved, every number finite. Room frame R, metres and radians.
struct PlanWall {
  Point start;
  Point end;
  Point along;    // unit, from start to end
  Point outward;  // unit, away from the room
  double length_m = 0;
};

struct PlanOpening {
  int wall = 0;
  double offset_m = 0;
  double width_m = 0;
  bool door = false;
  bool hinge_at_start = true;
  v1::DoorSwing swing = v1::DOOR_SWING_NONE;
  double swing_angle_rad = 0;
  std::string id;
  std::string name;  // "kitchen door", written on its threshold; empty where nothing tells it from others
};

struct PlanSocket {
  int wall = 0;
  double offset_m = 0;
};

struct PlanZone {
  std::string name;
  Rgb tint;
  std::vector<std::vector<Point>> parts;
};

struct PlanObject {
  std::string id;
  std::string name;
  const FurnitureClass* shown_as = nullptr;
  Ink ink;
  v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR;
  bool walk_over = false;
  Point centre_m;
  double theta_rad = 0;
  double width_m = 0;
  double depth_m = 0;
  double level_m = 0;    // drawing order within a layer
  double low_m = 0;      // height of its underside above the floor
  double top_m = 0;      // of its top, for the shadow
  int key = 0;           // index in Plan::keys
  bool blocked = false;  // nobody can stand at its front; known with the layer of circulation only

  // Back-left, back-right, front-right, front-left.
  std::vector<Point> Corners() const;
};

// One line of the legend: objects that are the same thing in the same zone.
struct PlanKey {
  std::string name;
  int zone = -1;  // index in Plan::zones; -1: of the whole room
  v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR;
  bool walk_over = false;
  double width_m = 0;
  double depth_m = 0;
  int count = 0;
  int number = 0;  // in the drawing; 0 for those that have their names there
};

// A constraint as the overlay shows it: lines from its first operand to each other one, or a mark at its only one.
struct PlanEdge {
  v1::OutcomeStatus status = v1::OUTCOME_STATUS_DROPPED;
  std::vector<Point> operands_m;  // middles of objects and openings, points on walls
  std::string words;              // the sentence it comes from, else its type and operands
  std::string miss;               // by how much it is violated, such as "0.12 m"; may be empty
};

struct Plan {
  PlanLayers layers;
  std::string title;
  std::string remark;  // in small print below the title; may be empty
  std::string room_type;
  double height_m = 0;
  double area_m2 = 0;
  std::vector<Point> floor;
  Box bounds_m;
  std::vector<PlanWall> walls;
  std::vector<PlanOpening> openings;
  std::vector<PlanSocket> sockets;
  std::vector<PlanZone> zones;
  std::vector<PlanObject> objects;  // in drawing order
  std::vector<PlanKey> keys;        // in legend order
  std::vector<std::string> unplaced;
  std::vector<PlanEdge> edges;               // with the layer of constraints only
  std::vector<std::vector<Point>> routes_m;  // with the layer of circulation only: from doors to fronts
  std::vector<std::string> blocked;          // names of what they do not reach
  std::string style_name;
  std::string style_summary;
  std::vector<std::pair<std::string, Rgb>> palette;
  std::string floor_material;
  std::string wall_material;
  Material floor_look;  // as views show it
  Rgb floor_tint;
  Rgb wall_tint;
};

// Resolves a layout. INVALID_ARGUMENT with the field path for what cannot be drawn: no floor, numbers that are not
// finite, openings in walls that do not exist. Objects without a placement are listed as unplaced, but for spare ones;
// those of layers that are not drawn are left out.
absl::StatusOr<Plan> ReadPlan(const v1::SolvedLayout& layout, const PlanLayers& layers = {});

// overlay_layers.cc, parts of the above: what the layers of constraints and circulation show.
void ReadEdges(const v1::SolvedLayout& layout, Plan& plan);
absl::Status ReadRoutes(const v1::SolvedLayout& layout, Plan& plan);

}  // namespace flair::renderer
