// SPDX-License-Identifier: GPL-3.0-or-later
// What flair-optimizer-example understands: all that flair-optimizer does, and daylight from the side.
#include "optimizer_worker/constraints/facts.h"

namespace flair {
// The text of daylight_from_side.textproto, see CMakeLists.txt.
std::string_view OwnRecords();
}  // namespace flair

namespace flair::optimizer {

ConstraintCode DaylightFromSideCode();

ConstraintLibrary LibraryOfProgram() {
  ConstraintLibrary library = OurLibrary();
  library.program = "flair-optimizer-example";
  library.Add(OwnRecords(), {{DaylightFromSideCode()}});
  return library;
}

}  // namespace flair::optimizer
