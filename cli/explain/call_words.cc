// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <functional>
#include <string_view>

#include "cli/explain/in_words.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/pose.h"

namespace flair::cli {
namespace {

using optimizer::Arguments;

std::string ObjectNames(const std::vector<int>& objects, const Scene& scene) {
  std::vector<std::string> names;
  for (const int object : objects) names.push_back(NameForPeople(scene, object));
  return Joined(names);
}

std::string ValueInWords(const v1::ParameterSpec& spec, const Arguments& arguments, const Scene& scene) {
  const std::string& name = spec.name();
  switch (spec.kind()) {
    case v1::PARAMETER_KIND_OBJECT:
      return ObjectNames({arguments.Object(name)}, scene);
    case v1::PARAMETER_KIND_OBJECTS:
      return ObjectNames(arguments.Objects(name), scene);
    case v1::PARAMETER_KIND_ZONE:
      return scene.zones[static_cast<size_t>(arguments.Zone(name))].name;
    case v1::PARAMETER_KIND_FEATURE:
      return std::string(optimizer::FeatureName(arguments.Feature(name)));
    case v1::PARAMETER_KIND_WALL:
      return WallInWords(scene.room.walls[static_cast<size_t>(arguments.MaybeWall(name))]);
    case v1::PARAMETER_KIND_SIDE:
      return std::string(SideName(arguments.OneSide(name)));
    case v1::PARAMETER_KIND_SIDES: {
      std::vector<std::string> sides;
      for (const Side side : arguments.Sides(name)) sides.emplace_back(SideName(side));
      return Joined(sides);
    }
    case v1::PARAMETER_KIND_CORNER: {
      std::string corner(CornerName(arguments.OneCorner(name)));
      std::replace(corner.begin(), corner.end(), '_', ' ');
      return corner;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      return arguments.Flag(name) ? "yes" : "no";
    default:
      return spec.unit() == "rad" ? MeasureText(arguments.Number(name) * 180 / kPi, "deg")
                                  : MeasureText(arguments.Number(name), spec.unit());
  }
}

// A text with what stands between `open` and `close` replaced.
std::string WithSlots(std::string_view text, char open, char close,
                      const std::function<std::string(std::string_view)>& value) {
  std::string words;
  for (size_t start = text.find(open); start != std::string_view::npos; start = text.find(open)) {
    const size_t end = text.find(close, start + 1);
    if (end == std::string_view::npos) break;
    words += text.substr(0, start);
    words += value(text.substr(start + 1, end - start - 1));
    text.remove_prefix(end + 1);
  }
  return words + std::string(text);
}

}  // namespace

// `type` is null when the call cannot be read.
struct CallWords::Call {
  const v1::ConstraintType* type = nullptr;
  Arguments arguments = {};
};

CallWords::Call CallWords::Read(const v1::ConstraintEdge& edge) const {
  for (const v1::ConstraintType& type : catalog_.types()) {
    if (type.name() != edge.type() && std::ranges::count(type.aliases(), edge.type()) == 0) continue;
    absl::StatusOr<Arguments> arguments = Arguments::Resolve(type, edge, scene_);
    return arguments.ok() ? Call{&type, *std::move(arguments)} : Call{};
  }
  return {};
}

std::string CallWords::Filled(const std::string& words, const Call& call, const std::string& missed_by) const {
  const bool is_summary = words == call.type->summary();
  return WithSlots(words, is_summary ? '`' : '{', is_summary ? '`' : '}', [&](std::string_view slot) {
    const size_t bar = slot.find('|');
    const std::string name(slot.substr(0, bar));
    if (name == "missed_by") return missed_by;
    const auto spec = std::ranges::find(call.type->parameters(), name, &v1::ParameterSpec::name);
    if (spec != call.type->parameters().end() && call.arguments.Has(name)) {
      return ValueInWords(*spec, call.arguments, scene_);
    }
    return bar == std::string_view::npos ? name : std::string(slot.substr(bar + 1));
  });
}

std::string CallWords::Asked(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  if (call.type == nullptr) return fmt::format("meets {}", edge.type());
  if (!call.type->phrase().empty()) return Filled(call.type->phrase(), call, "");
  // A type without words of its own: "Daylight falls on `object`." becomes "is so that daylight falls on the desk".
  std::string words = Filled(call.type->summary(), call, "");
  if (words.ends_with('.')) words.pop_back();
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return "is so that " + words;
}

std::string CallWords::Missed(const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) const {
  const Call call = Read(edge);
  if (call.type == nullptr || call.type->shortfall().empty() || !outcome.has_missed_by()) return "";
  const std::string words = Filled(call.type->shortfall(), call, MeasureText(outcome.missed_by(), outcome.unit()));
  return fmt::format("{} {}", ObjectNames(Subjects(edge), scene_), words);
}

std::vector<int> CallWords::Subjects(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  if (call.type == nullptr) return {};
  for (const v1::ParameterKind kind : {v1::PARAMETER_KIND_OBJECTS, v1::PARAMETER_KIND_OBJECT}) {
    const auto spec = std::ranges::find(call.type->parameters(), kind, &v1::ParameterSpec::kind);
    if (spec != call.type->parameters().end() && call.arguments.Has(spec->name())) {
      return call.arguments.Objects(spec->name());
    }
  }
  return {};
}

std::vector<int> CallWords::Anchors(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  std::vector<int> anchors;
  if (call.type == nullptr) return anchors;
  for (const std::string& name : call.type->anchors()) {
    if (!call.arguments.Has(name)) continue;
    const std::vector<int>& objects = call.arguments.Objects(name);
    anchors.insert(anchors.end(), objects.begin(), objects.end());
  }
  return anchors;
}

std::vector<int> CallWords::Named(const v1::ConstraintEdge& edge) const { return Read(edge).arguments.AllObjects(); }

std::string MeasureText(double value, const std::string& unit) {
  if (unit == "deg") return fmt::format("{:.0f} degrees", value);
  return fmt::format("{:.2f}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string Joined(const std::vector<std::string>& items) {
  std::string text;
  for (size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
}

}  // namespace flair::cli
