// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/options.h"

#include "cli/input/command_line.h"

namespace flair::cli {

template <typename Value>
CLI::Option* Options::Bind(const std::string& specification, Value& value, const std::string& help) {
  const size_t space = specification.find(' ');
  CLI::Option* option = command_.add_option(specification.substr(0, space), value, help)->group(group_);
  if (space != std::string::npos) option->type_name(specification.substr(space + 1));
  return option;
}
template CLI::Option* Options::Bind(const std::string&, std::string&, const std::string&);
template CLI::Option* Options::Bind(const std::string&, int&, const std::string&);
template CLI::Option* Options::Bind(const std::string&, std::vector<std::string>&, const std::string&);

void Options::Exclude(CLI::Option& option, const Names& others) {
  for (const std::string& other : others) option.excludes(command_.get_option(other));
}

std::string& Options::Text(const std::string& specification, const std::string& help, const Names& not_with) {
  auto& value = Keep(std::string());
  Exclude(*Bind(specification, value, help), not_with);
  return value;
}

std::string& Options::Required(const std::string& specification, const std::string& help) {
  auto& value = Keep(std::string());
  Bind(specification, value, help)->required();
  return value;
}

std::string& Options::Word(const std::string& specification, const Names& words, const std::string& help) {
  auto& value = Keep(words.front());
  Bind(specification, value, help)->check(OneOf(words));
  return value;
}

std::vector<std::string>& Options::List(const std::string& specification, const std::string& help) {
  auto& value = Keep(std::vector<std::string>());
  CLI::Option* const option = Bind(specification, value, help);
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

bool& Options::Flag(const std::string& names, const std::string& help, const Names& not_with) {
  auto& value = Keep(false);
  Exclude(*command_.add_flag(names, value, help)->group(group_), not_with);
  return value;
}

}  // namespace flair::cli
