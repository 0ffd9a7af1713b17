// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing else may be in this file, or programs could not replace it; see facts.h.
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

ConstraintLibrary LibraryOfProgram() { return OurLibrary(); }

}  // namespace flair::optimizer
