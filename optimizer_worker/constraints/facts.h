// SPDX-License-Identifier: GPL-3.0-or-later
// A constraint type: its record, which is data (types/*.textproto, flair.constraints.v1.ConstraintRecord), and its
// code. The record feeds the checks of arguments, the published catalogue, the prompts and docs made from that, and the
// battery of tests.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"

namespace flair::optimizer {

using BoundCost = absl::StatusOr<std::unique_ptr<Cost>>;

// The functions of a type.
struct ConstraintCode {
  std::string_view name;
  // The cost of a call whose arguments are checked. Refuses only what this room cannot have.
  BoundCost (*bind)(const Arguments& arguments, const BindContext& context);
  // By how much a call that costs something misses what it asks, in words. Null: told by the cost alone.
  std::optional<Shortfall> (*shortfall)(const PlacedCall& call) = nullptr;
  // Where its object belongs, when the root of the cost is how far it is from there: "the middle of the room".
  const char* place = nullptr;
};

// A layout where the call holds or does not, for the battery: a scene as room/text_format writes it, and the call
// (arguments.h).
struct LayoutExample {
  bool satisfied = false;
  std::string scene;
  std::string call;
};

struct ConstraintFacts {
  // As published.
  v1::ConstraintType type = {};
  std::vector<LayoutExample> layouts = {};
  // Empty, or why the cost is not the same in a room that is turned by a quarter.
  std::string tied_to_axes = {};
  ConstraintCode code = {};

  const std::string& name() const { return type.name(); }
};

inline const Footprint& FootprintOf(const BindContext& context, int object) {
  return context.scene.objects[static_cast<size_t>(object)].footprint;
}

// Which constraints a program has.
struct ConstraintLibrary {
  // What the catalogue, layouts and peers call it, such as "flair-optimizer" and "1". Libraries that differ must differ
  // here: optimizers share the restarts of a solve only with those that say the same.
  std::string program;
  std::string version;
  // Names and aliases are unique.
  std::vector<ConstraintFacts> types = {};

  // Adds the types of a ConstraintRecords message in text form. Ends the program when the text cannot be read, or when
  // a record has no code or code no record: both are part of the program.
  void Add(std::string_view records, std::span<const ConstraintCode> code);
};

// All of types/.
ConstraintLibrary OurLibrary();

// What this program has: OurLibrary(), unless the program defines this function itself, in one of its own sources, and
// answers with more (examples/own_constraint/library.cc). The linker takes the definition beside this header only where
// there is no other. Called once.
ConstraintLibrary LibraryOfProgram();

}  // namespace flair::optimizer
