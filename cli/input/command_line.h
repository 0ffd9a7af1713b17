// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: what --help prints, what is wrong with a call, and checks of values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "absl/status/status.h"

namespace flair::cli {

// What --help prints, as wide as the terminal: what a command does, how it is called with all that it needs, its
// arguments, options by group and subcommands. In descriptions and footers, lines that begin with a space are kept as
// they are, others flow; an empty line parts paragraphs. Which options go together is said behind their descriptions.
class HelpText : public CLI::Formatter {
 public:
  // Lines of at most `width` columns.
  explicit HelpText(size_t width) : width_(width) {}

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_group(std::string title, bool is_positional, std::vector<const CLI::Option*> options) const override;
  std::string make_positionals(const CLI::App* app) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  std::string Row(const std::string& name, const std::string& text) const;

  size_t width_;
};

// What is wrong with a command line, as every other error is told: what, and what would be right. INVALID_ARGUMENT.
// `program` is the one whose parse threw `error`.
absl::Status UsageError(const CLI::App& program, const CLI::ParseError& error);

// What values of flags must be. Errors read "--seed: abc: expected a whole number, 0 to 100"; the help texts say the
// same in their own words.

// The largest seed: what JSON and double precision keep exactly.
inline constexpr int64_t kLargestSeed = (int64_t{1} << 53) - 1;

CLI::Validator WholeNumber(int64_t least, int64_t most);
CLI::Validator Number(double least, double most);
CLI::Validator OneOf(std::vector<std::string> words);

inline CLI::Validator Seed() { return WholeNumber(0, kLargestSeed); }

}  // namespace flair::cli
