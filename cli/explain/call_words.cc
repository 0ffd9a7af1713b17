// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/call_words.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <string_view>

#include "cli/explain/standing.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"

namespace flair::cli {
namespace {

using optimizer::Arguments;
using optimizer::ConstraintFacts;

std::string SpacedOut(std::string_view words) {
  std::string text(words);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string ObjectNames(const std::vector<int>& objects, const Scene& scene) {
  std::vector<std::string> names;
  for (const int object : objects) names.push_back(optimizer::NameForPeople(scene, object));
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
    case v1::PARAMETER_KIND_CORNER:
      return SpacedOut(CornerName(arguments.OneCorner(name)));
    default:
      return fmt::format("{:.2f} m", arguments.Number(name));
  }
}

// One {...} of a template.
std::string Filled(std::string_view slot, const ConstraintFacts& facts, const Arguments& arguments,
                   const Scene& scene) {
  const size_t bar = slot.find('|');
  const std::string_view name = slot.substr(0, bar);
  const auto spec = std::find_if(facts.type.parameters().begin(), facts.type.parameters().end(),
                                 [&](const v1::ParameterSpec& parameter) { return parameter.name() == name; });
  if (spec != facts.type.parameters().end() && arguments.Has(name)) return ValueInWords(*spec, arguments, scene);
  return std::string(bar == std::string_view::npos ? name : slot.substr(bar + 1));
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

struct ReadCall {
  const ConstraintFacts& facts;
  Arguments arguments;
};

std::optional<ReadCall> Read(const v1::ConstraintEdge& edge, const Scene& scene) {
  const ConstraintFacts* const facts = optimizer::FindConstraint(edge.type());
  if (facts == nullptr) return std::nullopt;
  absl::StatusOr<Arguments> arguments = Arguments::Resolve(*facts, edge, scene);
  if (!arguments.ok()) return std::nullopt;
  return ReadCall{*facts, *std::move(arguments)};
}

}  // namespace

std::string CallInWords(const v1::ConstraintEdge& edge, const Scene& scene) {
  const std::optional<ReadCall> call = Read(edge, scene);
  if (!call) return fmt::format("meets {}", edge.type());
  const auto value = [&](std::string_view slot) { return Filled(slot, call->facts, call->arguments, scene); };
  if (!call->facts.phrase.empty()) return WithSlots(call->facts.phrase, '{', '}', value);
  // A type without words of its own: "Daylight falls on `object`." becomes "is so that daylight falls on the desk".
  std::string words = WithSlots(call->facts.type.summary(), '`', '`', value);
  if (words.ends_with('.')) words.pop_back();
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return "is so that " + words;
}

std::vector<int> SubjectsOf(const v1::ConstraintEdge& edge, const Scene& scene) {
  const std::optional<ReadCall> call = Read(edge, scene);
  if (!call) return {};
  for (const v1::ParameterSpec& spec : call->facts.type.parameters()) {
    if (spec.kind() == v1::PARAMETER_KIND_OBJECTS) return call->arguments.Objects(spec.name());
  }
  for (const v1::ParameterSpec& spec : call->facts.type.parameters()) {
    if (spec.kind() == v1::PARAMETER_KIND_OBJECT) return {call->arguments.Object(spec.name())};
  }
  return {};
}

std::vector<int> AllNamedIn(const v1::ConstraintEdge& edge, const Scene& scene) {
  const std::optional<ReadCall> call = Read(edge, scene);
  return call ? call->arguments.AllObjects() : std::vector<int>{};
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
