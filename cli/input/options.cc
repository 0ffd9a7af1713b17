// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/options.h"

#include <cstdio>

#include "cli/input/command_line.h"

namespace flair::cli {

template <typename Value>
CLI::Option* Options::Bind(const std::string& specification, Value& value, const std::string& help,
                           const Names& not_with) {
  const size_t space = specification.find(' ');
  CLI::Option* option = command_.add_option(specification.substr(0, space), value, help)->group(group_);
  if (space != std::string::npos) option->type_name(specification.substr(space + 1));
  for (const std::string& other : not_with) option->excludes(command_.get_option(other));
  return option;
}
template CLI::Option* Options::Bind(const std::string&, std::string&, const std::string&, const Names&);
template CLI::Option* Options::Bind(const std::string&, int&, const std::string&, const Names&);
template CLI::Option* Options::Bind(const std::string&, std::vector<std::string>&, const std::string&, const Names&);

std::string& Options::Text(const std::string& specification, const std::string& help, const Names& not_with) {
  auto& value = Keep(std::string());
  Bind(specification, value, help, not_with);
  return value;
}

std::string& Options::Required(const std::string& specification, const std::string& help) {
  auto& value = Keep(std::string());
  Bind(specification, value, help)->required();
  return value;
}

std::string& Options::Word(const std::string& specification, const Names& words, const std::string& help,
                           const std::optional<std::string>& otherwise) {
  auto& value = Keep(otherwise.value_or(words.front()));
  Bind(specification, value, help)->check(OneOf(words));
  return value;
}

std::vector<std::string>& Options::List(const std::string& specification, const std::string& help, bool required) {
  auto& value = Keep(std::vector<std::string>());
  CLI::Option* const option = Bind(specification, value, help)->required(required);
  if (option->nonpositional()) option->allow_extra_args(false);
  return value;
}

std::vector<std::string>& Options::Commas(const std::string& specification, const std::string& help) {
  auto& value = Keep(std::vector<std::string>());
  Bind(specification, value, help)->delimiter(',')->allow_extra_args(false);
  return value;
}

std::optional<int>& Options::Whole(const std::string& specification, int least, int most, const std::string& help) {
  auto& value = Keep(std::optional<int>());
  Bind(specification, value, help)->check(WholeNumber(least, most));
  return value;
}

int& Options::Whole(const std::string& specification, int least, int most, int initial, const std::string& help) {
  auto& value = Keep(initial);
  Bind(specification, value, help)->check(WholeNumber(least, most));
  return value;
}

double& Options::Decimal(const std::string& specification, double least, double most, double initial,
                         const std::string& help) {
  auto& value = Keep(initial);
  Bind(specification, value, help)->check(Number(least, most));
  return value;
}

int64_t& Options::SeedNumber(const std::string& help) {
  auto& value = Keep(int64_t{0});
  Bind("--seed N", value, help)->check(Seed());
  return value;
}

bool& Options::Flag(const std::string& names, const std::string& help, const Names& not_with,
                    const std::string& only_with) {
  auto& value = Keep(false);
  CLI::Option* const option = command_.add_flag(names, value, help)->group(group_);
  for (const std::string& other : not_with) option->excludes(command_.get_option(other));
  if (!only_with.empty()) option->needs(command_.get_option(only_with));
  return value;
}

Commands Commands::AddRunning(const std::string& name, const std::string& description, const std::string& footer,
                              const std::function<std::function<absl::Status()>(CLI::App& command)>& declare) const {
  CLI::App* const command = app.add_subcommand(name, description);
  // Those below a command that runs itself are called instead of it, one at a time.
  if (app.get_require_subcommand_min() == 0) app.require_subcommand(0, 1);
  command->footer(footer);
  command->callback([command, run = declare(*command), &status = result] {
    if (!command->get_subcommands().empty()) return;
    status = run();
    std::fflush(stdout);
  });
  return {*command, result};
}

Commands Commands::Group(const std::string& name, const std::string& description) const {
  CLI::App* const command = app.add_subcommand(name, description);
  command->require_subcommand(1);
  return {*command, result};
}

}  // namespace flair::cli
