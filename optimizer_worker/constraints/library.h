// SPDX-License-Identifier: GPL-3.0-or-later
// Which constraints a program has.
#pragma once

#include <string>
#include <vector>

#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

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
