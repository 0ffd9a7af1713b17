// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/sheet.h"
#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

v1::DrawPlanPartsRequest RequestFor(const v1::SolvedLayout& layout, std::initializer_list<const char*> ids = {}) {
  v1::DrawPlanPartsRequest request;
  *request.mutable_solved_layout() = layout;
  for (const char* id : ids) request.add_object_ids(id);
  return request;
}

v1::PlanParts PartsOf(const v1::SolvedLayout& layout, std::initializer_list<const char*> ids = {}) {
  const absl::StatusOr<v1::PlanParts> parts = DrawPlanParts(RequestFor(layout, ids));
  EXPECT_TRUE(parts.ok()) << parts.status();
  return parts.ok() ? *parts : v1::PlanParts();
}

// A reader of parts that knows what they may be made of: groups, paths, and nine attributes. Paints them with cairo.
class Painter {
 public:
  explicit Painter(cairo_t* cairo) : cairo_(cairo) {}

  void Paint(const std::string& svg) {
    const std::string open = "<g fill=\"none\" stroke-miterlimit=\"10\">", close = "</g>";
    ASSERT_TRUE(svg.starts_with(open) && svg.ends_with(close)) << svg.substr(0, 80);
    cairo_set_miter_limit(cairo_, 10);
    const std::string paths = svg.substr(open.size(), svg.size() - open.size() - close.size());
    for (size_t at = 0; at < paths.size();) {
      const size_t end = paths.find("/>", at);
      ASSERT_NE(end, std::string::npos);
      ASSERT_EQ(paths.substr(at, 6), "<path ");
      PaintPath(paths.substr(at + 6, end - at - 6));
      at = end + 2;
    }
  }

 private:
  void PaintPath(const std::string& text) {
    static const std::set<std::string> kAllowed = {"d",
                                                   "fill",
                                                   "fill-opacity",
                                                   "fill-rule",
                                                   "stroke",
                                                   "stroke-opacity",
                                                   "stroke-width",
                                                   "stroke-dasharray",
                                                   "stroke-linejoin",
                                                   "stroke-linecap"};
    std::map<std::string, std::string> attributes;
    for (size_t at = 0; at < text.size();) {
      const size_t equals = text.find("=\"", at), end = text.find('"', equals + 2);
      ASSERT_NE(end, std::string::npos) << text;
      const std::string name = text.substr(at, equals - at);
      ASSERT_TRUE(kAllowed.contains(name)) << name;
      attributes[name] = text.substr(equals + 2, end - equals - 2);
      at = end + (end + 1 < text.size() ? 2 : 1);
    }
    Trace(attributes["d"]);
    if (!attributes["fill"].empty()) {
      SetColour(attributes["fill"], attributes["fill-opacity"]);
      cairo_set_fill_rule(cairo_, attributes["fill-rule"].empty() ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
      cairo_fill_preserve(cairo_);
    }
    if (!attributes["stroke"].empty()) {
      SetColour(attributes["stroke"], attributes["stroke-opacity"]);
      cairo_set_line_width(cairo_, std::stod(attributes["stroke-width"]));
      double dash[2] = {};
      std::istringstream(attributes["stroke-dasharray"]) >> dash[0] >> dash[1];
      cairo_set_dash(cairo_, dash, dash[0] > 0 ? 2 : 0, 0);
      cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
  }

  void SetColour(const std::string& colour, const std::string& opacity) {
    ASSERT_EQ(colour.size(), 7U);
    const int value = std::stoi(colour.substr(1), nullptr, 16);
    cairo_set_source_rgba(cairo_, (value >> 16) / 255.0, ((value >> 8) & 255) / 255.0, (value & 255) / 255.0,
                          opacity.empty() ? 1 : std::stod(opacity));
  }

  void Trace(const std::string& path) {
    const char* at = path.c_str();
    char command = 0;
    const auto number = [&at] {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      EXPECT_NE(at, end) << at;
      at = end;
      return value;
    };
    cairo_move_to(cairo_, 0, 0);
    while (*at != 0 && !testing::Test::HasFailure()) {
      if (std::isalpha(*at) != 0) command = *at++;
      double v[6] = {};
      for (int i = 0; i < (command == 'c' ? 6 : command == 'z' ? 0 : 2); ++i) v[i] = number();
      switch (command) {
        case 'm':
          cairo_rel_move_to(cairo_, v[0], v[1]);
          break;
        case 'l':
          cairo_rel_line_to(cairo_, v[0], v[1]);
          break;
        case 'c':
          cairo_rel_curve_to(cairo_, v[0], v[1], v[2], v[3], v[4], v[5]);
          break;
        default:
          ASSERT_EQ(command, 'z') << path;
          cairo_close_path(cairo_);
      }
    }
  }

  cairo_t* cairo_;
};

// Puts the parts together as a page does.
void Compose(cairo_t* cairo, const v1::SolvedLayout& layout, const v1::PlanParts& parts) {
  Painter painter(cairo);
  const auto paint = [&](const v1::PlanPart& part, const std::string& svg, double x_m, double y_m) {
    const auto& placements = layout.placements();
    const auto at = std::ranges::find(placements, part.object_id(), &v1::Placement::object_id);
    ASSERT_NE(at, placements.end());
    cairo_save(cairo);
    cairo_translate(cairo, at->x_m() + x_m, -at->y_m() + y_m);
    cairo_rotate(cairo, -at->theta_rad());
    painter.Paint(svg);
    cairo_restore(cairo);
  };
  const auto paint_all = [&](bool above_walls) {
    for (const v1::PlanPart& part : parts.parts()) {
      if (part.above_walls() != above_walls) continue;
      if (!part.shadow_svg().empty()) paint(part, part.shadow_svg(), part.shadow_x_m(), part.shadow_y_m());
      paint(part, part.svg(), 0, 0);
    }
  };
  painter.Paint(parts.floor_svg());
  paint_all(false);
  painter.Paint(parts.walls_svg());
  paint_all(true);
}

constexpr double kPxPerMm = 3;

// Share of pixels that differ by more than a shade.
double DifferenceOf(const v1::SolvedLayout& layout) {
  absl::StatusOr<PlanSheet> made = MakePlanSheet(layout, {});
  if (!made.ok()) return ADD_FAILURE() << made.status(), 1;
  for (PlanOpening& opening : made->plan.openings) opening.name.clear();  // letters are no part
  const auto white = [&](Canvas& canvas) {
    canvas.Rectangle({0, 0, made->sheet.size_mm.width, made->sheet.size_mm.height});
    canvas.Fill(kWhite);
  };
  const auto plan = DrawOnPixels(made->sheet, kPxPerMm, [&](Canvas& canvas) {
    white(canvas);
    DrawRoom(canvas, made->plan, made->sheet);
  });
  const auto composed = DrawOnPixels(made->sheet, kPxPerMm, [&](Canvas& canvas) {
    white(canvas);
    cairo_translate(canvas.cairo(), made->sheet.origin_mm.x, made->sheet.origin_mm.y);
    cairo_scale(canvas.cairo(), made->sheet.mm_per_m(), made->sheet.mm_per_m());
    Compose(canvas.cairo(), layout, PartsOf(layout));
  });
  if (!plan.ok() || !composed.ok()) return ADD_FAILURE() << plan.status() << composed.status(), 1;
  int differing = 0;
  for (size_t i = 0; i < plan->rgb.size(); ++i) differing += std::abs(plan->rgb[i] - composed->rgb[i]) > 12 ? 1 : 0;
  return static_cast<double>(differing) / static_cast<double>(plan->rgb.size());
}

class PlanPartsOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Samples, PlanPartsOf, testing::ValuesIn(SampleLayouts()),
                         [](const auto& sample) { return sample.param; });

TEST_P(PlanPartsOf, TogetherAreThePlan) { EXPECT_LT(DifferenceOf(ReadSample(GetParam())), 2e-4); }

TEST_P(PlanPartsOf, TogetherAreThePlanHoweverPiecesAreTurned) {
  v1::SolvedLayout layout = ReadSample(GetParam());
  for (v1::Placement& placement : *layout.mutable_placements())
    placement.set_theta_rad(std::fmod(placement.theta_rad() + std::numbers::pi / 6, 2 * std::numbers::pi));
  EXPECT_LT(DifferenceOf(layout), 2e-4);
}

TEST_P(PlanPartsOf, AreSmallAndTheSameEveryTime) {
  const v1::SolvedLayout layout = ReadSample(GetParam());
  const v1::PlanParts parts = PartsOf(layout);
  EXPECT_LT(parts.floor_svg().size(), 60 << 10);
  EXPECT_LT(parts.ByteSizeLong(), 400 << 10);
  EXPECT_EQ(parts.SerializeAsString(), PartsOf(layout).SerializeAsString());
}

// What a part paints, in its own frame, metres.
Box InkOf(const std::string& svg) {
  const SurfacePtr surface(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
  const CairoPtr cairo(cairo_create(surface.get()));
  constexpr double kUnitsPerM = 10000;  // extents are whole units
  cairo_scale(cairo.get(), kUnitsPerM, kUnitsPerM);
  Painter(cairo.get()).Paint(svg);
  double x = 0, y = 0, width = 0, height = 0;
  cairo_recording_surface_ink_extents(surface.get(), &x, &y, &width, &height);
  return {x / kUnitsPerM, y / kUnitsPerM, (x + width) / kUnitsPerM, (y + height) / kUnitsPerM};
}

TEST_P(PlanPartsOf, StayInTheirFootprints) {
  const v1::SolvedLayout layout = ReadSample(GetParam());
  const double mm_per_m = MakePlanSheet(layout, {})->sheet.mm_per_m(), least_depth_m = 1.1 / mm_per_m;
  std::map<std::string, v1::Object> objects;
  for (const v1::Object& object : layout.graph().object_list().objects()) objects[object.id()] = object;
  const v1::PlanParts parts = PartsOf(layout);
  for (const v1::PlanPart& part : parts.parts()) {
    const v1::Object& object = objects[part.object_id()];
    const double front = std::max(object.depth_m() / 2, least_depth_m - object.depth_m() / 2);
    const Box footprint{-object.width_m() / 2, part.above_walls() ? -front : -object.depth_m() / 2,
                        object.width_m() / 2, object.depth_m() / 2};
    EXPECT_TRUE(footprint.Grown(0.7 / mm_per_m).Contains(InkOf(part.svg()))) << part.object_id();
  }
}

TEST_P(PlanPartsOf, CarryTheNamesThatThePlanWritesOnThem) {
  const v1::SolvedLayout layout = ReadSample(GetParam());
  const PlanSheet made = *MakePlanSheet(layout, {});
  const DrawnPlan plan = *DrawPlan(layout, {});
  std::map<std::string, Point> names_mm;  // from the middles of their pieces
  for (const PlacedLabel& label : plan.labels) {
    if (label.form == kBadgeForm || label.leader || label.item >= static_cast<int>(made.plan.objects.size())) continue;
    const PlanObject& object = made.plan.objects[label.item];
    names_mm[object.id] = label.box_mm.centre() - made.sheet.ToSheet(object.centre_m);
  }
  const v1::PlanParts parts = PartsOf(layout);
  for (const v1::PlanPart& part : parts.parts()) {
    const auto name = names_mm.find(part.object_id());
    ASSERT_EQ(part.label().empty(), name == names_mm.end()) << part.object_id();
    if (name == names_mm.end()) continue;
    EXPECT_NEAR(part.label_x_m() * made.sheet.mm_per_m(), name->second.x, 1e-6) << part.label();
    EXPECT_NEAR(part.label_y_m() * made.sheet.mm_per_m(), name->second.y, 1e-6) << part.label();
  }
}

std::vector<std::string> IdsOf(const v1::PlanParts& parts) {
  std::vector<std::string> ids;
  for (const v1::PlanPart& part : parts.parts()) ids.push_back(part.object_id());
  return ids;
}

// A room of 4 x 3 m with a lamp on a desk on a rug, and a shelf on the wall.
v1::SolvedLayout Study() {
  v1::SolvedLayout layout;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"pb(
        graph {
          room {
            room_type: "study"
            floor {
              vertices { x_m: 0 y_m: 0 }
              vertices { x_m: 4 y_m: 0 }
              vertices { x_m: 4 y_m: 3 }
              vertices { x_m: 0 y_m: 3 }
            }
            height_m: 2.5
          }
          object_list {
            objects { id: "lamp" name: "lamp" kind: OBJECT_KIND_SURFACE width_m: 0.3 depth_m: 0.3 height_m: 0.5 }
            objects { id: "shelf" name: "wall shelf" kind: OBJECT_KIND_WALL width_m: 1 depth_m: 0.02 height_m: 0.3 }
            objects { id: "desk" name: "desk <b>" kind: OBJECT_KIND_FLOOR width_m: 1.6 depth_m: 0.8 height_m: 0.75 }
            objects { id: "chair" name: "chair" kind: OBJECT_KIND_FLOOR width_m: 0.5 depth_m: 0.5 height_m: 0.9 }
            objects {
              id: "rug"
              name: "rug"
              kind: OBJECT_KIND_FLOOR
              walk_over: true
              width_m: 2
              depth_m: 2
              height_m: 0.01
            }
          }
        }
        placements { object_id: "lamp" x_m: 1.4 y_m: 0.6 z_m: 0.75 }
        placements { object_id: "shelf" x_m: 3 y_m: 0.01 z_m: 1.5 }
        placements { object_id: "desk" x_m: 2 y_m: 0.6 theta_rad: 0.5 }
        placements { object_id: "rug" x_m: 2 y_m: 1.5 }
      )pb",
      &layout));
  return layout;
}

TEST(PlanParts, ComeInTheOrderOfThePlanWithoutWhatHasNoPlace) {
  const v1::PlanParts parts = PartsOf(Study());
  EXPECT_THAT(IdsOf(parts), ElementsAre("rug", "desk", "lamp", "shelf"));
  EXPECT_TRUE(parts.parts(0).below_furniture());
  EXPECT_FALSE(parts.parts(1).below_furniture());
  EXPECT_FALSE(parts.parts(2).above_walls());
  EXPECT_TRUE(parts.parts(3).above_walls());
}

TEST(PlanParts, OfSomeObjectsComeWithoutBaseAndAreTheSame) {
  const v1::PlanParts some = PartsOf(Study(), {"shelf", "desk", "chair"}), all = PartsOf(Study());
  EXPECT_THAT(IdsOf(some), ElementsAre("desk", "shelf"));
  EXPECT_EQ(some.parts(0).SerializeAsString(), all.parts(1).SerializeAsString());
  EXPECT_THAT(some.floor_svg() + some.walls_svg(), IsEmpty());
}

TEST(PlanParts, OfAnUnknownObjectAreRefused) {
  const absl::Status status = DrawPlanParts(RequestFor(Study(), {"desk", "sofa"})).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(status.message(), "object_ids[1]: there is no object \"sofa\"");
}

TEST(PlanParts, CarryNamesAsTheyAreAndOnlyInLabels) {
  const v1::PlanPart desk = PartsOf(Study(), {"desk"}).parts(0);
  EXPECT_EQ(desk.label(), "desk <b>");
  EXPECT_THAT(desk.svg(), Not(HasSubstr("<b>")));
  EXPECT_LT(std::hypot(desk.label_x_m(), desk.label_y_m()), 0.8);
  EXPECT_GT(desk.label_size_m(), 0);
}

TEST(PlanParts, CastTheirShadowsToOneSideHoweverTheyStand) {
  v1::SolvedLayout turned = Study();
  turned.mutable_placements(2)->set_theta_rad(3);
  const v1::PlanPart a = PartsOf(Study(), {"desk"}).parts(0), b = PartsOf(turned, {"desk"}).parts(0);
  EXPECT_EQ(a.svg() + a.shadow_svg(), b.svg() + b.shadow_svg());
  EXPECT_GT(a.shadow_x_m(), 0);
  EXPECT_GT(a.shadow_y_m(), 0);
  const Box shadow = InkOf(a.shadow_svg());
  EXPECT_NEAR(shadow.centre().x, 0, 1e-3);
  EXPECT_NEAR(shadow.centre().y, 0, 1e-3);
  EXPECT_THAT(PartsOf(Study(), {"rug"}).parts(0).shadow_svg(), IsEmpty());
}

TEST(PlanParts, AreWrittenAsPathsOnly) {
  EXPECT_EQ(PartsOf(Study(), {"shelf"}).parts(0).svg(),
            R"(<g fill="none" stroke-miterlimit="10">)"
            R"(<path d="m-.5 .01l1 0 0-.022-1 0z" fill="#e6ceb5" stroke="#49331a" stroke-width=".006"/>)"
            R"(<path d="m0 .01l0-.022" stroke="#49331a" stroke-opacity=".8" stroke-width=".0032"/>)"
            R"(<path d="m-.5 .0069l1 0" stroke="#49331a" stroke-opacity=".8" stroke-width=".0032"/></g>)");
}

// Boards differ too little in tone for the eye of TogetherAreThePlan.
TEST(PlanParts, BeginEveryBoardOfACutFloorAnew) {
  const std::string floor = PartsOf(ReadSample("l_shaped_studio")).floor_svg();
  size_t board_count = 0;
  for (size_t at = floor.find('z'); at != std::string::npos; at = floor.find('z', at + 1), ++board_count) {
    EXPECT_THAT(floor[at + 1], testing::AnyOf('m', '"')) << floor.substr(at > 40 ? at - 40 : 0, 80);
  }
  EXPECT_GT(board_count, 20u);
}

TEST(PlanParts, OfAnEmptyRoomAreItsBase) {
  v1::SolvedLayout layout = Study();
  layout.clear_placements();
  layout.mutable_graph()->clear_object_list();
  const v1::PlanParts parts = PartsOf(layout);
  EXPECT_THAT(IdsOf(parts), IsEmpty());
  EXPECT_THAT(parts.floor_svg(), HasSubstr("<path d=\"m0 0"));
  EXPECT_THAT(parts.walls_svg(), HasSubstr("<path"));
}

TEST(PlanParts, OfAPieceWithoutWidthAreRefused) {
  v1::SolvedLayout layout = Study();
  layout.mutable_graph()->mutable_object_list()->mutable_objects(2)->set_width_m(0);
  EXPECT_THAT(std::string(DrawPlanParts(RequestFor(layout)).status().message()), HasSubstr("\"desk\""));
}

}  // namespace
}  // namespace flair::renderer
