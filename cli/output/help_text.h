// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "CLI/CLI.hpp"

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

}  // namespace flair::cli
