// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::llm {

// A prompt that a program uses: the file NAME.txt.
struct PromptSpec {
  std::string name;
  // What the text may contain as {{placeholder}}.
  std::vector<std::string> placeholders;
  // Those of them without which the model would not know what to do; each must be in the text.
  std::vector<std::string> required;
};

using PromptValues = std::map<std::string, std::string, std::less<>>;

// The texts that models are asked with: files of an installed folder, each replaced by the file of the same name in a
// user's own folder where there is one. Lines that begin with "%%" are remarks and never sent. Immutable, thread-safe.
class PromptLibrary {
 public:
  // `overrides` may be empty. NOT_FOUND when a folder or an installed prompt is missing; INVALID_ARGUMENT with file and
  // line for a placeholder that the prompt does not have, a required one that it does not use, an empty prompt, or text
  // that is no UTF-8.
  static absl::StatusOr<PromptLibrary> Load(const std::filesystem::path& installed,
                                            const std::filesystem::path& overrides,
                                            const std::vector<PromptSpec>& specs);

  // The prompt with its placeholders replaced, each once: what a value contains is not looked at. `name` and all its
  // placeholders must be known; a missing value is a mistake of the program's and becomes empty.
  std::string Fill(std::string_view name, const PromptValues& values) const;

  // Digest of all texts in use, 16 hex digits.
  const std::string& version() const { return version_; }

 private:
  std::map<std::string, std::string, std::less<>> texts_;
  std::string version_;
};

// A text of a stranger's as data in a prompt: a JSON string in which no mark of ours can occur, so that nothing in it
// can end the quotation.
std::string QuoteData(std::string_view text);

}  // namespace flair::llm
