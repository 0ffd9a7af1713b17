// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a command, each declared once, as the member that holds its value:
//
//   struct DrawOptions : Options {
//     using Options::Options;
//     std::string& house = Required("HOUSE", "What is drawn");
//     std::string& out = Required("-o,--out FILE", "Where it goes");
//     std::optional<int>& size_px = Whole("--size PX", 256, 8192, "Longer side in pixels, 256 to 8192 (800)");
//     bool& json = Flag("--json", "As JSON");
//   };
//   absl::Status Draw(const DrawOptions& options);
//   void AddDraw(const Commands& program) { program.Add("draw", "Draw a house.", Draw); }
#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "CLI/CLI.hpp"
#include "absl/status/status.h"

namespace flair::cli {

// A specification names the option, then what its value is called in --help; without dashes it is a positional
// argument. The values are set when the command line is parsed.
class Options {
 public:
  using Names = std::vector<std::string>;

  // The options appear in --help under the heading `group`.
  explicit Options(CLI::App& command, std::string group = "Options") : command_(command), group_(std::move(group)) {}
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

 protected:
  CLI::App& command() { return command_; }

  // Adds an option that sets a value kept elsewhere.
  template <typename Value>
  CLI::Option* Bind(const std::string& specification, Value& value, const std::string& help);

  // `not_with` names options, declared before, that exclude this one.
  std::string& Text(const std::string& specification, const std::string& help, const Names& not_with = {});
  std::string& Required(const std::string& specification, const std::string& help);
  // One of the words; the first of them when it is not given.
  std::string& Word(const std::string& specification, const Names& words, const std::string& help);
  // One value each time that the option is given; a positional argument takes any number.
  std::vector<std::string>& List(const std::string& specification, const std::string& help);
  // Values with commas between them.
  std::vector<std::string>& Commas(const std::string& specification, const std::string& help);
  // Whole numbers from `least` to `most`.
  std::optional<int>& Whole(const std::string& specification, int least, int most, const std::string& help);
  int& Whole(const std::string& specification, int least, int most, int initial, const std::string& help);
  double& Decimal(const std::string& specification, double least, double most, double initial, const std::string& help);
  int64_t& SeedNumber(const std::string& help);
  bool& Flag(const std::string& names, const std::string& help, const Names& not_with = {});

 private:
  template <typename Value>
  Value& Keep(Value value) {
    return std::get<Value>(values_.emplace_back(std::move(value)));
  }
  void Exclude(CLI::Option& option, const Names& others);

  CLI::App& command_;
  const std::string group_;
  // A deque leaves its elements where they are.
  std::deque<std::variant<std::string, std::vector<std::string>, std::optional<int>, int, int64_t, double, bool>>
      values_;
};

// Where commands are added, and where the one that is called says how it ended.
struct Commands {
  CLI::App& app;
  absl::Status& result;

  // A command that runs `run` with its options, unless a command below it is called; its own commands are added to what
  // is returned.
  template <typename OptionsType>
  Commands Add(const std::string& name, const std::string& description, absl::Status (*run)(OptionsType&),
               const std::string& footer = "") const {
    CLI::App* const command = app.add_subcommand(name, description);
    command->footer(footer);
    command->callback(
        [command, run, &status = result, options = std::make_shared<std::remove_const_t<OptionsType>>(*command)] {
          if (!command->get_subcommands().empty()) return;
          status = run(*options);
          std::fflush(stdout);
        });
    return {*command, result};
  }

  // A command that only holds others.
  Commands Group(const std::string& name, const std::string& description) const {
    CLI::App* const command = app.add_subcommand(name, description);
    command->require_subcommand(1);
    return {*command, result};
  }
};

}  // namespace flair::cli
