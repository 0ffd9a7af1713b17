// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "absl/status/statusor.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Reads, merges and checks all *.textproto files of a folder and its subfolders, in the order of their paths. NOT_FOUND
// when there are none; INVALID_ARGUMENT with file and line, or with file and entry, for the first things that are wrong
// (up to twenty, one per line). The version is the first 16 hex digits of the SHA-256 over paths and contents.
absl::StatusOr<std::unique_ptr<const Handbook>> LoadHandbook(const std::filesystem::path& folder);

// The folder that LoadHandbook is given when the configuration names none: share/flair/handbook beside the program's
// own folder when installed, else the source tree's data.
std::filesystem::path DefaultHandbookFolder();

}  // namespace flair::language
