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
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"

// CLI11, which costs every file that includes it seconds, is in the .cc files that need more than a reference.
namespace CLI {
class App;
class Option;
}  // namespace CLI

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

  // `not_with` names options, declared before, that exclude this one.

  // Adds an option that sets a value kept elsewhere.
  template <typename Value>
  CLI::Option* Bind(const std::string& specification, Value& value, const std::string& help,
                    const Names& not_with = {});
  std::string& Text(const std::string& specification, const std::string& help, const Names& not_with = {});
  std::string& Required(const std::string& specification, const std::string& help);
  // One of the words; the first of them when it is not given, or `otherwise`.
  std::string& Word(const std::string& specification, const Names& words, const std::string& help,
                    const std::optional<std::string>& otherwise = {});
  // One value each time that the option is given; a positional argument takes any number.
  std::vector<std::string>& List(const std::string& specification, const std::string& help, bool required = false);
  // Values with commas between them.
  std::vector<std::string>& Commas(const std::string& specification, const std::string& help);
  // Whole numbers from `least` to `most`.
  std::optional<int>& Whole(const std::string& specification, int least, int most, const std::string& help);
  int& Whole(const std::string& specification, int least, int most, int initial, const std::string& help);
  double& Decimal(const std::string& specification, double least, double most, double initial, const std::string& help);
  int64_t& SeedNumber(const std::string& help);
  // `only_with` names an option, declared before, without which this one is refused.
  bool& Flag(const std::string& names, const std::string& help, const Names& not_with = {},
             const std::string& only_with = "");

 private:
  template <typename Value>
  Value& Keep(Value value) {
    return std::get<Value>(values_.emplace_back(std::move(value)));
  }
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

  // A command that runs `run` with its options, unless a command below it is called instead; its own commands are added
  // to what is returned.
  template <typename OptionsType>
  Commands Add(const std::string& name, const std::string& description, absl::Status (*run)(OptionsType&),
               const std::string& footer = "") const {
    return AddRunning(name, description, footer, [run](CLI::App& command) -> std::function<absl::Status()> {
      return [run, options = std::make_shared<std::remove_const_t<OptionsType>>(command)] { return run(*options); };
    });
  }

  // A command that only holds others.
  Commands Group(const std::string& name, const std::string& description) const;

 private:
  // `declare` adds the command's options and returns what is called once they are set.
  Commands AddRunning(const std::string& name, const std::string& description, const std::string& footer,
                      const std::function<std::function<absl::Status()>(CLI::App& command)>& declare) const;
};

}  // namespace flair::cli
