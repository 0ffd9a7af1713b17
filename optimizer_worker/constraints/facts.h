// SPDX-License-Identifier: GPL-3.0-or-later
// What a constraint type says about itself. Written once, beside its formula; it feeds the checks of arguments, the
// published catalogue, the prompts and docs made from that, and the battery of tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/cost.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"

namespace flair::optimizer {

// A sentence and the call it means, written "object=bed side=back" (see call_text.h).
struct SentenceExample {
  std::string sentence;
  std::string call;
};

// A layout where the call holds or does not, for the battery: a scene as room/text_format writes it, and the call.
struct LayoutExample {
  bool satisfied = false;
  std::string scene;
  std::string call;
};
inline LayoutExample Satisfied(std::string scene, std::string call) {
  return {true, std::move(scene), std::move(call)};
}
inline LayoutExample Violated(std::string scene, std::string call) {
  return {false, std::move(scene), std::move(call)};
}

struct ConstraintFacts {
  std::string name;
  std::vector<std::string> aliases = {};
  std::string family;
  // One sentence: what holds when the cost is zero.
  std::string summary;
  // What an object that keeps the call does, for `explain`: "keeps at least {min_distance_m} from {target}".
  // {PARAMETER} stands for its value, {PARAMETER|words} for the words where the call leaves it out. Empty: the summary
  // is used.
  std::string phrase = {};
  // Formula, symbols, unit, source; what the released library does otherwise and why we differ.
  std::string doc;
  std::vector<v1::ParameterSpec> parameters = {};
  std::vector<SentenceExample> sentences = {};
  std::vector<LayoutExample> layouts = {};
  // By how much a call of this type that costs something misses what it asks, in words. Null: told by the cost alone.
  std::optional<Shortfall> (*shortfall)(const PlacedCall& call) = nullptr;
  absl::StatusOr<std::unique_ptr<Cost>> (*bind)(const Arguments& arguments, const BindContext& context) = nullptr;
  // A whole-room term that the optimizer adds itself.
  bool built_in = false;
  // Empty, or why the cost is not the same in a room that is turned by a quarter.
  std::string tied_to_axes = {};
};

inline const Footprint& FootprintOf(const BindContext& context, int object) {
  return context.scene.objects[static_cast<size_t>(object)].footprint;
}

// Parameters.
v1::ParameterSpec ObjectParameter(std::string name, std::string doc);
v1::ParameterSpec ObjectsParameter(std::string name, std::string doc);
v1::ParameterSpec ZoneParameter(std::string name, std::string doc);
v1::ParameterSpec FeatureParameter(std::string name, std::string doc);
v1::ParameterSpec OptionalWall(std::string name, std::string doc);
v1::ParameterSpec OptionalObject(std::string name, std::string doc);
v1::ParameterSpec OptionalSide(std::string name, std::string doc);
v1::ParameterSpec SideParameter(std::string name, std::string doc, Side default_side);
v1::ParameterSpec SidesParameter(std::string name, std::string doc, std::vector<Side> default_sides);
v1::ParameterSpec CornerParameter(std::string name, std::string doc, Corner default_corner);
v1::ParameterSpec LengthParameter(std::string name, std::string doc, double min_m, double max_m, double default_m);
v1::ParameterSpec FlagParameter(std::string name, std::string doc, bool default_flag);

// Which constraints a program has.
struct ConstraintLibrary {
  // What the catalogue, layouts and peers call it, such as "flair-optimizer" and "1". Libraries that differ must differ
  // here: optimizers share the restarts of a solve only with those that say the same.
  std::string program;
  std::string version;
  // Names and aliases are unique.
  std::vector<ConstraintFacts> types;
};

// All that constraint_list.inc names.
ConstraintLibrary OurLibrary();

// What this program has: OurLibrary(), unless the program defines this function itself, in one of its own sources, and
// answers with more (examples/own_constraint/library.cc). The linker takes the definition beside this header only where
// there is no other. Called once.
ConstraintLibrary LibraryOfProgram();

}  // namespace flair::optimizer
