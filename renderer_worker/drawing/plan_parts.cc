// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "absl/strings/str_join.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/sheet.h"
#include "renderer_worker/drawing/svg_paths.h"
#include "renderer_worker/drawing/text.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

// Draws at the scale of the plan, so that lines are as heavy, but in the frame of the parts.
class PartDrawer {
 public:
  PartDrawer(Plan plan, const Sheet& sheet)
      : plan_(std::move(plan)),
        plan_sheet_(sheet),
        sheet_(sheet),
        m_per_mm_(1 / sheet.mm_per_m()),
        svg_(m_per_mm_),
        surface_(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr)),
        cairo_(cairo_create(surface_.get())) {
    sheet_.origin_mm = {};
    sheet_.plan_mm = {};
    for (const Point vertex : plan_.floor) sheet_.plan_mm.Include(sheet_.ToSheet(vertex));
    // Names are labels: a screen has letters of its own.
    for (PlanOpening& opening : plan_.openings) opening.name.clear();
    cairo_scale(cairo_.get(), sheet.scale, sheet.scale);  // device units are millimetres of the room
    canvas_.emplace(cairo_.get(), &svg_);
  }

  void DrawBase(v1::PlanParts& parts) {
    DrawFloor(*canvas_, plan_, sheet_);
    parts.set_floor_svg(svg_.Take());
    DrawWalls(*canvas_, plan_, sheet_);
    DrawOpenings(*canvas_, plan_, sheet_);
    DrawSockets(*canvas_, plan_, sheet_);
    parts.set_walls_svg(svg_.Take());
  }

  void DrawObjects(const std::set<std::string_view>& ids, v1::PlanParts& parts) {
    const std::vector<NameOnPiece> names = NamesOnPieces(*canvas_, plan_, plan_sheet_);
    for (size_t i = 0; i < plan_.objects.size(); ++i) {
      const PlanObject& object = plan_.objects[i];
      if (!ids.empty() && !ids.contains(object.id)) continue;
      v1::PlanPart& part = *parts.add_parts();
      DrawPart(object, part);
      const auto name = std::ranges::find(names, static_cast<int>(i), &NameOnPiece::object);
      if (name != names.end()) SetLabel(object, *name, part);
    }
  }

  absl::Status status() const { return StatusOf(cairo_status(cairo_.get())); }

 private:
  void DrawPart(const PlanObject& object, v1::PlanPart& part) {
    part.set_object_id(object.id);
    part.set_above_walls(IsMounted(object));
    part.set_below_furniture(object.walk_over);
    PlanObject own = object;
    own.centre_m = {};
    own.theta_rad = 0;
    DrawPiece(*canvas_, own, IsAbove(plan_, object), sheet_);
    part.set_svg(svg_.Take());
    if (!HasShadow(object)) return;
    const Point offset_m = ShadowOffsetMm(object, sheet_) * m_per_mm_;
    own.centre_m = {-offset_m.x, offset_m.y};
    DrawShadow(*canvas_, own, sheet_);
    part.set_shadow_svg(svg_.Take());
    part.set_shadow_x_m(offset_m.x);
    part.set_shadow_y_m(offset_m.y);
  }

  void SetLabel(const PlanObject& object, const NameOnPiece& name, v1::PlanPart& part) const {
    const Point offset_m = (name.centre_mm - plan_sheet_.ToSheet(object.centre_m)) * m_per_mm_;
    part.set_label(absl::StrJoin(name.lines, "\n"));
    part.set_label_x_m(offset_m.x);
    part.set_label_y_m(offset_m.y);
    part.set_label_size_m(kNameSizeMm * m_per_mm_);
  }

  Plan plan_;
  const Sheet plan_sheet_;  // of the plan
  Sheet sheet_;             // of the parts
  const double m_per_mm_;
  SvgPaths svg_;
  SurfacePtr surface_;
  CairoPtr cairo_;
  std::optional<Canvas> canvas_;
};

}  // namespace

absl::StatusOr<v1::PlanParts> DrawPlanParts(const v1::DrawPlanPartsRequest& request) {
  const v1::SolvedLayout& layout = request.solved_layout();
  std::set<std::string_view> known, asked;
  for (const v1::Object& object : layout.graph().object_list().objects()) known.insert(object.id());
  for (int i = 0; i < request.object_ids_size(); ++i) {
    asked.insert(request.object_ids(i));
    if (!known.contains(request.object_ids(i)))
      return InvalidArgument("object_ids[{}]: there is no object \"{}\"", i, request.object_ids(i));
  }
  ASSIGN_OR_RETURN(PlanSheet made, MakePlanSheet(layout, {}));
  PartDrawer drawer(std::move(made.plan), made.sheet);
  v1::PlanParts parts;
  if (asked.empty()) drawer.DrawBase(parts);
  drawer.DrawObjects(asked, parts);
  RETURN_IF_ERROR(drawer.status());
  return parts;
}

}  // namespace flair::renderer
