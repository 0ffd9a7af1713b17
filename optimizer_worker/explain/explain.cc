// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/explain/explain.h"

#include <algorithm>

#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/explain/scope.h"

namespace flair::optimizer {

std::string NameForPeople(const Scene& scene, int object) {
  const Object& what = scene.objects[static_cast<size_t>(object)];
  const std::string name = what.name.empty() ? what.id : what.name;
  const auto count = std::count_if(scene.objects.begin(), scene.objects.end(),
                                   [&](const Object& other) { return other.name == what.name; });
  if (count <= 1) return "the " + name;
  // The number of its id when it has one, else its place among its likes.
  const size_t number = what.id.find_last_not_of("0123456789") + 1;
  if (number < what.id.size()) return fmt::format("{} {}", name, what.id.substr(number));
  const auto before = std::count_if(scene.objects.begin(), scene.objects.begin() + object,
                                    [&](const Object& other) { return other.name == what.name; });
  return fmt::format("{} {}", name, before + 1);
}

namespace {

// "the desk and the chair", the objects that the call names.
std::string AllNamed(const v1::ConstraintEdge& edge, const Scene& scene) {
  std::string names;
  for (int object : NamedObjects(edge, scene)) {
    names += (names.empty() ? "" : " and ") + NameForPeople(scene, object);
  }
  return names.empty() ? "the room" : names;
}

}  // namespace

std::optional<Shortfall> Explain(const v1::ConstraintEdge& edge, const Furnished& where) {
  const ConstraintFacts* const facts = FindConstraint(edge.type());
  if (facts == nullptr) return std::nullopt;
  const absl::StatusOr<Arguments> arguments = Arguments::Resolve(*facts, edge, where.scene);
  if (!arguments.ok()) return std::nullopt;
  const Scope scope(edge, *arguments, where);
  const double missed = scope.CostRoot();
  if (missed == 0) return std::nullopt;
  for (const auto find : {FindPlaceExplainer, FindPairExplainer, FindTertiaryExplainer}) {
    const Explainer explainer = find(facts->name);
    if (explainer == nullptr) continue;
    if (std::optional<Shortfall> shortfall = explainer(scope)) return shortfall;
  }
  if (facts->built_in) return std::nullopt;
  // Several small misses may add up to what none of them is; and a new type has no words of its own.
  return Worst(
      {{fmt::format("what is asked of {} is missed by {:.2f} m", AllNamed(edge, where.scene), missed), missed, "m"}});
}

}  // namespace flair::optimizer
