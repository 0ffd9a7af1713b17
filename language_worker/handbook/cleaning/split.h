// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flair::language {

// The single statements of a sentence that says several things, in order; the sentence alone when it says one:
//   "The bed does not block doors or windows."           -> about doors; about windows
//   "The desk is against a wall and near a socket."      -> "... is against a wall."; "The desk is near a socket."
//   "The sofa faces the window and has its back to us."  -> "... faces the window."; "The sofa has its back to us."
//   "Keep the door free; leave space around the bed."    -> both
std::vector<std::string> SplitStatements(const std::string& text);

}  // namespace flair::language
