// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/value_checks.h"

#include <algorithm>
#include <utility>

#include "absl/strings/numbers.h"
#include "cli/input/message_words.h"
#include "cli/output/printable.h"
#include "fmt/format.h"

namespace flair::cli {

CLI::Validator WholeNumber(int64_t least, int64_t most) {
  const auto check = [least, most](const std::string& text) -> std::string {
    int64_t value = 0;
    if (absl::SimpleAtoi(text, &value) && value >= least && value <= most) return "";
    return fmt::format("{}: expected a whole number, {} to {}", Printable(text), least, most);
  };
  return CLI::Validator(check, "");
}

CLI::Validator Number(double least, double most) {
  const auto check = [least, most](const std::string& text) -> std::string {
    double value = 0;
    if (absl::SimpleAtod(text, &value) && value >= least && value <= most) return "";
    return fmt::format("{}: expected a number, {:g} to {:g}", Printable(text), least, most);
  };
  return CLI::Validator(check, "");
}

CLI::Validator OneOf(std::vector<std::string> words) {
  const auto check = [words = std::move(words)](const std::string& text) -> std::string {
    if (std::ranges::find(words, text) != words.end()) return "";
    return fmt::format("{}: expected one of {}{}", Printable(text), fmt::join(words, ", "), DidYouMean(text, words));
  };
  return CLI::Validator(check, "");
}

}  // namespace flair::cli
