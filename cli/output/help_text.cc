// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/help_text.h"

#include <sstream>

#include "cli/output/wrapped_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr size_t kTextColumn = 26;

bool MayBeRepeated(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

// "-o, --out DIR", "--lambda NAME=VALUE ...".
std::string HelpNameOf(const CLI::Option& option) {
  std::string name;
  for (const std::string& letter : option.get_snames()) name += fmt::format("{}-{}", name.empty() ? "" : ", ", letter);
  for (const std::string& word : option.get_lnames()) name += fmt::format("{}--{}", name.empty() ? "" : ", ", word);
  if (option.get_type_size() != 0 && !option.get_type_name().empty()) name += " " + option.get_type_name();
  if (MayBeRepeated(option) && option.get_delimiter() == '\0') name += " ...";
  return name;
}

std::string HelpUsageOf(const CLI::Option& option) {
  if (!option.get_positional()) return fmt::format("--{} {}", option.get_lnames().front(), option.get_type_name());
  const std::string name = option.get_name(true, false) + (MayBeRepeated(option) ? "..." : "");
  return option.get_required() ? name : "[" + name + "]";
}

// Sorted: the set is ordered by address.
std::string SortedNames(const std::set<CLI::Option*>& options) {
  std::set<std::string> names;
  for (const CLI::Option* option : options) names.insert(option->get_name());
  return fmt::format("{}", fmt::join(names, " or "));
}

std::string Flowing(const std::string& text, size_t width) {
  std::string lines, paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) lines += Wrapped(paragraph, width, "") + "\n";
    paragraph.clear();
  };
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == ' ') {
      end_paragraph();
      lines += line + "\n";
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  end_paragraph();
  return lines;
}

}  // namespace

std::string HelpText::Row(const std::string& name, const std::string& text) const {
  const std::string indent(kTextColumn, ' ');
  std::string row = "  " + name;
  if (text.empty()) return row + "\n";
  row += ColumnsOf(row) + 2 > kTextColumn ? "\n" + indent : std::string(kTextColumn - ColumnsOf(row), ' ');
  return row + Wrapped(text, width_, indent, kTextColumn) + "\n";
}

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  std::string text = option->get_description();
  if (!option->get_envname().empty()) text += fmt::format("; otherwise ${}", option->get_envname());
  if (!option->get_needs().empty()) text += fmt::format("; only with {}", SortedNames(option->get_needs()));
  if (!option->get_excludes().empty()) text += fmt::format("; not with {}", SortedNames(option->get_excludes()));
  return Row(is_positional ? option->get_name(true, false) : HelpNameOf(*option), text);
}

std::string HelpText::make_group(std::string title, bool is_positional, std::vector<const CLI::Option*> options) const {
  std::string text = "\n" + title + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return text;
}

std::string HelpText::make_positionals(const CLI::App* app) const {
  const auto positionals = app->get_options([](const CLI::Option* option) { return option->get_positional(); });
  return positionals.empty() ? "" : make_group("Arguments", true, positionals);
}

std::string HelpText::make_subcommand(const CLI::App* command) const {
  return Row(command->get_name(), command->get_description());
}

std::string HelpText::make_usage(const CLI::App* app, std::string name) const {
  std::string usage = "Usage: " + name;
  for (const CLI::Option* option : app->get_options()) {
    if (option->get_positional()) usage += " " + HelpUsageOf(*option);
  }
  for (const CLI::Option* option : app->get_options()) {
    if (option->get_required() && !option->get_positional()) usage += " " + HelpUsageOf(*option);
  }
  const bool has_commands = !app->get_subcommands([](const CLI::App*) { return true; }).empty();
  if (has_commands && app->get_require_subcommand_min() > 0) return usage + " COMMAND ...\n";
  usage += " [OPTIONS]\n";
  return has_commands ? usage + "       " + name + " COMMAND ...\n" : usage;
}

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = Flowing(app->get_description(), width_) + "\n" + make_usage(app, name);
  // The commands come first where there are any: they are what one looks for.
  text += make_subcommands(app, mode) + make_positionals(app);
  for (const std::string& group : app->get_groups()) {
    const auto options = app->get_options([&](const CLI::Option* option) {
      return option->get_group() == group && option->nonpositional() && !group.empty();
    });
    if (!options.empty()) text += make_group(group, false, options);
  }
  if (!app->get_footer().empty()) text += "\n" + Flowing(app->get_footer(), width_);
  return text;
}

}  // namespace flair::cli
