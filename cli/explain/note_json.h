// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/explain/layout_note.h"

namespace flair::cli {

// The note, or one object of it, as JSON: always all demands; indented, ending in a newline. docs/explain.md lists the
// fields.
std::string NoteJson(const LayoutNote& note);
std::string ObjectJson(const ObjectNote& object);

}  // namespace flair::cli
