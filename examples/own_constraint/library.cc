// SPDX-License-Identifier: GPL-3.0-or-later
// What flair-optimizer-example understands: all that flair-optimizer does, and daylight from the side.
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

ConstraintFacts DaylightFromSideFacts();

ConstraintLibrary LibraryOfProgram() {
  ConstraintLibrary library = OurLibrary();
  library.program = "flair-optimizer-example";
  library.types.push_back(DaylightFromSideFacts());
  return library;
}

}  // namespace flair::optimizer
