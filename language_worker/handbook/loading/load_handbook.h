// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// A sentence that the data can write about a piece, with its placeholders, and where it stands.
struct SentenceTemplate {
  std::string place;   // "my/pieces.textproto:12: furniture "kallax": relations[0]"
  std::string text;    // "The {object} is next to the {target}."
  std::string object;  // class of the piece; empty where the sentence is for many
  std::string target;  // class of the partner; empty without one
};

// What checking handbook folders found.
struct HandbookFindings {
  std::vector<std::string> faults;  // one line each: file, line, entry, field, what is wrong, what would be right
  std::vector<std::string> notes;   // the same form; no reason to refuse the data
  std::vector<SentenceTemplate> sentences;   // of the last overlay; of the base folder where there is none
  std::unique_ptr<const Handbook> handbook;  // null when there are faults
};

// Reads and merges all *.textproto files of a folder and its subfolders, in the order of their paths, lays the overlays
// over it in the order given, and checks the result. An overlay's entry replaces one of the same kind and name; its
// other entries come first, so that its words go before those of the base folder. NOT_FOUND when a folder has no such
// files.
absl::StatusOr<HandbookFindings> CheckHandbook(const std::filesystem::path& folder,
                                               const std::vector<std::filesystem::path>& overlays = {});

// The same for those who only want to use it: INVALID_ARGUMENT with the faults (the first twenty, one per line). The
// version is the first 16 hex digits of the SHA-256 over paths and contents.
absl::StatusOr<std::unique_ptr<const Handbook>> LoadHandbook(const std::filesystem::path& folder,
                                                             const std::vector<std::filesystem::path>& overlays = {});

// The folder that LoadHandbook is given when the configuration names none: share/flair/handbook beside the program's
// own folder when installed, else the source tree's data.
std::filesystem::path DefaultHandbookFolder();

}  // namespace flair::language
