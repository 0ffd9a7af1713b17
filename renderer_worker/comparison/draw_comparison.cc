// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/draw_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr double kLeastColumnMm = 88;
constexpr double kRowMm = 5.4;
constexpr double kAboveMm = 3;
constexpr int kMostRows = 12;

int ColumnCount(double width_mm) { return std::max(1, static_cast<int>(width_mm / kLeastColumnMm)); }

int RowCount(const Comparison& comparison, double width_mm) {
  const int columns = ColumnCount(width_mm);
  return std::min(kMostRows, (comparison.change_count + columns - 1) / columns);
}

std::string WordsOf(const PlanChange& change) {
  if (change.kind == ChangeKind::kAdded) return change.words.empty() ? "added" : "added, " + change.words;
  if (change.kind == ChangeKind::kRemoved) return change.words.empty() ? "removed" : "removed, " + change.words;
  return change.words;
}

void DrawRow(Canvas& canvas, const PlanChange& change, Point left_mm, double width_mm) {
  DrawChangeNumber(canvas, change, left_mm + Point{3, kRowMm / 2});
  const TextBlock name{change.name, {.size_mm = 3.1, .colour = kPanelInk, .bold = true}};
  const double name_width = std::min(Measure(canvas, name).width, 0.5 * width_mm);
  const double y = left_mm.y + 0.75;
  DrawText(canvas, {name.text, name.style, name_width + 0.5}, {left_mm.x + 7, y});
  DrawText(canvas, {WordsOf(change), {.size_mm = 3.1, .colour = kPanelSoft}, width_mm - name_width - 11},
           {left_mm.x + 9 + name_width, y});
}

// What the list of all changes takes of paper of that width, millimetres; 0 when there are none.
double ChangeListHeight(const Comparison& comparison, double width_mm) {
  return comparison.change_count == 0 ? 0 : kAboveMm + kRowMm * RowCount(comparison, width_mm);
}

// Number, name and words of each, in columns; the last place says how many more there are.
void DrawChangeList(Canvas& canvas, const Comparison& comparison, const Box& box) {
  if (comparison.change_count == 0) return;
  const int columns = ColumnCount(box.width()), rows = RowCount(comparison, box.width());
  const double width = box.width() / columns;
  Rule(canvas, box.x0, box.x1, box.y0 + 0.6);
  int place = 0;
  for (const ComparisonPanel& panel : comparison.panels) {
    for (const PlanChange& change : panel.changes) {
      const Point at{box.x0 + (place / rows) * width, box.y0 + kAboveMm / 2 + 0.8 + (place % rows) * kRowMm};
      if (place + 1 == columns * rows && comparison.change_count > columns * rows) {
        DrawText(canvas,
                 {fmt::format("and {} more", comparison.change_count - place), {.size_mm = 3.1, .colour = kPanelSoft}},
                 at + Point{7, 0.75});
        return;
      }
      DrawRow(canvas, change, at, width);
      ++place;
    }
  }
}

constexpr double kCaptionMm = 15;
constexpr double kFootMm = 9;
constexpr double kGapMm = 6;
constexpr double kMarginMm = 12;

// The sheet at a scale with so many columns of panels; none when a plan does not fit its panel.
std::optional<ComparisonSheet> SheetAt(const Comparison& comparison, v1::PaperSize paper, bool portrait, int scale,
                                       int columns) {
  ComparisonSheet made;
  made.paper = EmptySheet(paper, portrait, scale);
  const Box inner = Box{0, 0, made.paper.size_mm.width, made.paper.size_mm.height}.Grown(-kMarginMm);
  const double list_mm = ChangeListHeight(comparison, inner.width());
  made.foot_mm = {inner.x0, inner.y1 - kFootMm, inner.x1, inner.y1};
  made.list_mm = {inner.x0, made.foot_mm.y0 - list_mm, inner.x1, made.foot_mm.y0};
  made.paper.plan_mm = {inner.x0, inner.y0, inner.x1, made.list_mm.y0 - kGapMm / 2};
  const int count = static_cast<int>(comparison.panels.size()), rows = (count + columns - 1) / columns;
  const double width = (inner.width() - (columns - 1) * kGapMm) / columns;
  const double height = (made.paper.plan_mm.height() - (rows - 1) * kGapMm) / rows;
  for (int i = 0; i < count; ++i) {
    Sheet panel = EmptySheet(paper, portrait, scale);
    const double x = inner.x0 + (i % columns) * (width + kGapMm), y = inner.y0 + (i / columns) * (height + kGapMm);
    panel.side_mm = {x, y, x + width, y + kCaptionMm};
    panel.plan_mm = {x, y + kCaptionMm, x + width, y + height};
    const Box needed = PaperNeeded(comparison.panels[i].plan, panel);
    if (needed.width() > panel.plan_mm.width() || needed.height() > panel.plan_mm.height()) return std::nullopt;
    const Point middle = needed.centre(), target = panel.plan_mm.centre();
    panel.origin_mm = {target.x - middle.x, target.y - middle.y};
    made.panels.push_back(panel);
  }
  return made;
}

std::optional<ComparisonSheet> BestAt(const Comparison& comparison, v1::PaperSize paper, int scale) {
  const int count = static_cast<int>(comparison.panels.size());
  // Side by side goes before one above the other, and landscape before portrait.
  for (bool portrait : {false, true}) {
    for (int columns = count; columns >= 1; --columns) {
      if (columns != count && count % columns == 1) continue;  // nobody stands alone
      if (auto sheet = SheetAt(comparison, paper, portrait, scale, columns); sheet.has_value()) return sheet;
    }
  }
  return std::nullopt;
}

// How far what is drawn steps back where something is marked.
constexpr double kPale = 0.3;

void DrawCaption(Canvas& canvas, const ComparisonPanel& panel, const Box& box) {
  DrawText(canvas, {panel.caption, {.size_mm = 5.4, .colour = kPanelInk, .serif = true}, box.width()},
           {box.x0, box.y0});
  DrawText(canvas, {panel.remark, {.size_mm = 3.1, .colour = kPanelSoft}, box.width()}, {box.x0, box.y0 + 7.6});
  Rule(canvas, box.x0, box.x1, box.y0 + 13);
}

void DrawPanel(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) {
  DrawCaption(canvas, panel, sheet.side_mm);
  canvas.Rectangle(sheet.plan_mm.Grown(2));
  canvas.Clip();
  DrawRoom(canvas, panel.plan, sheet);
  if (!panel.changes.empty() || !panel.removed.empty()) {
    std::vector<Point> floor;
    for (const Point vertex : panel.plan.floor) floor.push_back(sheet.ToSheet(vertex));
    canvas.Polygon(floor);
    canvas.Fill(kWhite, kPale);
  }
  DrawBlocked(canvas, panel.plan, sheet);
  if (panel.plan.layers.constraints) DrawConstraints(canvas, panel.plan, sheet);
  DrawMarks(canvas, panel, sheet);
  DrawNames(canvas, panel, sheet);
  canvas.Unclip();
}

void DrawFoot(Canvas& canvas, const Comparison& comparison, const ComparisonSheet& sheet) {
  const Box& box = sheet.foot_mm;
  Rule(canvas, box.x0, box.x1, box.y0 + 1);
  double x = box.x0;
  std::set<ChangeKind> kinds;
  for (const ComparisonPanel& panel : comparison.panels) {
    for (const PlanChange& change : panel.changes) kinds.insert(change.kind);
  }
  constexpr std::pair<ChangeKind, const char*> kSigns[] = {{ChangeKind::kMoved, "moved"},
                                                           {ChangeKind::kResized, "another size"},
                                                           {ChangeKind::kAdded, "added"},
                                                           {ChangeKind::kRemoved, "removed"}};
  for (const auto& [kind, words] : kSigns) {
    if (!kinds.contains(kind)) continue;
    DrawMarkSign(canvas, kind, {x + 1, box.y0 + 3.6, x + 13, box.y0 + 7});
    const TextBlock text{words, {.size_mm = 3, .colour = kPanelInk}};
    DrawText(canvas, text, {x + 15.5, box.y0 + 3.2});
    x += 15.5 + Measure(canvas, text).width + 8;
  }
  const TextBlock scale{
      fmt::format("{}1:{} at {}", comparison.title.empty() ? "" : Capital(comparison.title) + "   ·   ",
                  sheet.paper.scale, sheet.paper.paper),
      {.size_mm = 3, .colour = kPanelSoft},
      box.x1 - x,
      1,
      Align::kRight};
  DrawText(canvas, scale, {x, box.y0 + 3.2});
}

struct Made {
  Comparison comparison;
  ComparisonSheet sheet;

  void Draw(Canvas& canvas) const {
    DrawPaper(canvas, sheet.paper);
    for (size_t i = 0; i < comparison.panels.size(); ++i) DrawPanel(canvas, comparison.panels[i], sheet.panels[i]);
    DrawChangeList(canvas, comparison, sheet.list_mm);
    DrawFoot(canvas, comparison, sheet);
  }
};

absl::StatusOr<Made> Make(const v1::RenderRequest& request) {
  ASSIGN_OR_RETURN(Comparison comparison, ReadComparison(request));
  ASSIGN_OR_RETURN(ComparisonSheet sheet, ArrangeComparison(comparison, request.options()));
  RETURN_IF_ERROR(CheckFonts());
  return Made{std::move(comparison), std::move(sheet)};
}

constexpr double kSameM = 5e-4;

const v1::Object* ObjectOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.id() == id) return &object;
  }
  return nullptr;
}

std::optional<PlanObject> DrawnObject(const Plan& plan, const std::string& id) {
  const auto found = std::ranges::find(plan.objects, id, &PlanObject::id);
  return found == plan.objects.end() ? std::nullopt : std::optional<PlanObject>(*found);
}

ChangeKind KindOf(const v1::Object* before, const v1::Object* after) {
  if (before == nullptr) return ChangeKind::kAdded;
  if (after == nullptr) return ChangeKind::kRemoved;
  const bool is_resized = std::abs(before->width_m() - after->width_m()) > kSameM ||
                          std::abs(before->depth_m() - after->depth_m()) > kSameM;
  return is_resized ? ChangeKind::kResized : ChangeKind::kMoved;
}

// Whether a place in the one room means anything in the other: their extents share three quarters of both.
bool IsSameRoom(const Plan& a, const Plan& b) {
  const double shared =
      std::min(a.bounds_m.width(), b.bounds_m.width()) * std::min(a.bounds_m.height(), b.bounds_m.height());
  const auto area = [](const Box& box) { return box.width() * box.height(); };
  return shared >= 0.75 * (area(a.bounds_m) + area(b.bounds_m) - shared);
}

absl::StatusOr<PlanLayers> LayersOfComparison(const v1::RenderOptions& options) {
  absl::StatusOr<PlanLayers> layers = LayersOf(options);
  if (layers.ok()) layers->dimensions = false;
  return layers;
}

// The change at `path` between the first panel's layout and another's.
absl::StatusOr<PlanChange> ReadChange(const v1::ObjectChange& change, const std::string& path,
                                      const v1::SolvedLayout& before, const Plan& plan_before,
                                      const v1::SolvedLayout& after, const Plan& plan_after) {
  const v1::Object* was = ObjectOf(before, change.before_object_id());
  const v1::Object* is = ObjectOf(after, change.after_object_id());
  const auto missing = [&](const char* field, const std::string& id, const v1::Object* object) {
    if (id.empty() || object != nullptr) return absl::OkStatus();
    return InvalidArgument("{}.{}: \"{}\" is not an object of its layout", path, field, id);
  };
  RETURN_IF_ERROR(missing("before_object_id", change.before_object_id(), was));
  RETURN_IF_ERROR(missing("after_object_id", change.after_object_id(), is));
  if (was == nullptr && is == nullptr) {
    return absl::InvalidArgumentError(path + ": names no object; before_object_id, after_object_id or both");
  }
  PlanChange read{.kind = KindOf(was, is), .name = is != nullptr ? is->name() : was->name(), .words = change.words()};
  if (read.name.empty()) read.name = is != nullptr ? is->id() : was->id();
  if (was != nullptr) read.before = DrawnObject(plan_before, was->id());
  if (is != nullptr) read.after = DrawnObject(plan_after, is->id());
  return read;
}

}  // namespace

absl::StatusOr<ComparisonSheet> ArrangeComparison(const Comparison& comparison, const v1::RenderOptions& options) {
  const std::string_view paper = EmptySheet(options.paper(), false, 1000).paper;
  if (options.has_scale_denominator()) {
    auto sheet = BestAt(comparison, options.paper(), options.scale_denominator());
    if (sheet.has_value()) return *std::move(sheet);
    return InvalidArgument("options.scale_denominator: {} plans do not fit {} at 1:{}", comparison.panels.size(), paper,
                           options.scale_denominator());
  }
  for (const int scale : CommonScales()) {
    if (auto sheet = BestAt(comparison, options.paper(), scale); sheet.has_value()) return *std::move(sheet);
  }
  return InvalidArgument("beside: {} plans do not fit {} at any scale", comparison.panels.size(), paper);
}

absl::StatusOr<DrawnPlan> DrawComparison(const v1::RenderRequest& request) {
  ASSIGN_OR_RETURN(const Made made, Make(request));
  ASSIGN_OR_RETURN(const double px_per_mm, PixelsPerMm(made.sheet.paper, request.options()));
  ASSIGN_OR_RETURN(Pixels pixels,
                   DrawOnPixels(made.sheet.paper, px_per_mm, [&](Canvas& canvas) { made.Draw(canvas); }));
  return DrawnPlan{.pixels = std::move(pixels),
                   .title = made.comparison.title,
                   .scale = made.sheet.paper.scale,
                   .paper = made.sheet.paper.paper};
}

absl::StatusOr<std::string> DrawComparisonDocument(const v1::RenderRequest& request, const DrawingMetadata& metadata) {
  ASSIGN_OR_RETURN(const Made made, Make(request));
  return DrawInDocument(made.sheet.paper, made.comparison.title, request.options(), metadata,
                        [&](Canvas& canvas) { made.Draw(canvas); });
}

absl::StatusOr<Comparison> ReadComparison(const v1::RenderRequest& request) {
  ASSIGN_OR_RETURN(const PlanLayers layers, LayersOfComparison(request.options()));
  ASSIGN_OR_RETURN(Plan first, ReadPlan(request.solved_layout(), layers));
  Comparison comparison{.title = first.title};
  comparison.panels.push_back({std::move(first), request.caption(), request.remark(), {}, {}});
  for (int i = 0; i < request.beside_size(); ++i) {
    const v1::ComparedLayout& other = request.beside(i);
    absl::StatusOr<Plan> plan = ReadPlan(other.solved_layout(), layers);
    if (!plan.ok()) {
      return absl::Status(plan.status().code(), fmt::format("beside[{}].{}", i, std::string(plan.status().message())));
    }
    ComparisonPanel panel{*std::move(plan), other.caption(), other.remark(), {}, {}};
    for (int j = 0; j < other.changes_size(); ++j) {
      ASSIGN_OR_RETURN(PlanChange change, ReadChange(other.changes(j), fmt::format("beside[{}].changes[{}]", i, j),
                                                     request.solved_layout(), comparison.panels.front().plan,
                                                     other.solved_layout(), panel.plan));
      change.number = ++comparison.change_count;
      if (change.kind == ChangeKind::kRemoved) comparison.panels.front().removed.push_back(change);
      if (!IsSameRoom(comparison.panels.front().plan, panel.plan)) change.before.reset();
      panel.changes.push_back(std::move(change));
    }
    comparison.panels.push_back(std::move(panel));
  }
  return comparison;
}

}  // namespace flair::renderer
