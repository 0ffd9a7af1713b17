// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/library.h"

namespace flair::optimizer {

// Every type's facts, from its own file.
#define CONSTRAINT(family, Type, file) ConstraintFacts Type##Facts();
#include "optimizer_worker/constraints/constraint_list.inc"
#undef CONSTRAINT

ConstraintLibrary OurLibrary() {
  return {.program = "flair-optimizer",
          .version = "1",
          .types = {
#define CONSTRAINT(family, Type, file) Type##Facts(),
#include "optimizer_worker/constraints/constraint_list.inc"
#undef CONSTRAINT
          }};
}

}  // namespace flair::optimizer
