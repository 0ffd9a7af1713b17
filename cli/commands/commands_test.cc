// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands have in common: how they explain themselves, and how they refuse.
#include "cli/commands/commands.h"

#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "cli/commands/batch_flags.h"
#include "cli/input/command_line.h"
#include "cli/output/text.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

class CommandsTest : public ::testing::Test {
 protected:
  CommandsTest() : program_("Makes rooms.", "flair"), dev_program_("Measures.", "flair-dev") {
    AddCommands({program_, result_}, FlairCommands().groups);
    AddCommands({dev_program_, result_}, DevCommands().groups);
    Collect(program_, "flair");
    Collect(dev_program_, "flair-dev");
  }

  void Collect(CLI::App& command, const std::string& name) {
    commands_.emplace_back(name, &command);
    for (CLI::App* each : command.get_subcommands(nullptr)) Collect(*each, name + " " + each->get_name());
  }

  std::string ErrorOf(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());
    try {
      program_.parse(words);
    } catch (const CLI::ParseError& error) {
      return std::string(UsageError(program_, error).message());
    }
    return "no error";
  }

  CLI::App program_;
  CLI::App dev_program_;
  absl::Status result_;
  std::vector<std::pair<std::string, CLI::App*>> commands_;
};

TEST_F(CommandsTest, EveryCommandSaysWhatItDoesInASentence) {
  for (const auto& [name, command] : commands_) {
    EXPECT_THAT(command->get_description(), MatchesRegex("[A-Z].*\\.")) << name;
  }
}

TEST_F(CommandsTest, EveryOptionSaysWhatItIsAndWhatItTakes) {
  for (const auto& [name, command] : commands_) {
    for (const CLI::Option* option : command->get_options()) {
      const std::string where = name + " " + option->get_name();
      EXPECT_THAT(option->get_description(),
                  AllOf(MatchesRegex("[A-Z0-9].*"), AnyOf(EndsWith("..."), Not(EndsWith(".")))))
          << where;
      EXPECT_THAT(option->get_type_name(), Not(AnyOf(HasSubstr("INT"), HasSubstr("FLOAT"), HasSubstr(" in "))))
          << where;
    }
  }
}

TEST_F(CommandsTest, NumbersSayTheirRange) {
  const std::regex numeric("N|PX|S|M|K|MIB|COUNT|JOBS|DEG|USD");
  for (const auto& [name, command] : commands_) {
    for (const CLI::Option* option : command->get_options()) {
      const std::string text = option->get_description();
      if (!std::regex_match(option->get_type_name(), numeric) || option->get_name() == "--seed") continue;
      EXPECT_TRUE(std::regex_search(text, std::regex("[0-9] to [0-9]|1, 3 or 5")))
          << name << " " << option->get_name() << ": " << text;
    }
  }
}

TEST_F(CommandsTest, HelpFitsATerminalOf80Columns) {
  for (const auto& [name, command] : commands_) {
    std::istringstream help(HelpText(80).make_help(command, name, CLI::AppFormatMode::Normal));
    for (std::string line; std::getline(help, line);) EXPECT_LE(ColumnsOf(line), 80u) << name << ": " << line;
  }
}

TEST_F(CommandsTest, SlipsOfThePenAreRecognized) {
  EXPECT_EQ(ErrorOf({"desing"}), "desing: flair has no such command (did you mean design?); flair --help lists them");
  EXPECT_EQ(ErrorOf({"batch", "B", "--out", "x", "--qeue", "y"}),
            "--qeue: flair batch has no such option (did you mean --queue?); flair batch --help lists them");
  EXPECT_EQ(ErrorOf({"jobs", "lst"}),
            "lst: flair jobs has no such command (did you mean list?); flair jobs --help lists them");
  EXPECT_EQ(ErrorOf({"diff", "a", "b", "--format", "jsom"}),
            "--format: jsom: expected one of text, json (did you mean json?)");
}

TEST_F(CommandsTest, WhatIsMissingOrTooMuchIsNamed) {
  EXPECT_THAT(ErrorOf({}), StartsWith("which command? flair --help describes them: design, studio, mcp, batch, "));
  EXPECT_EQ(ErrorOf({"token"}), "which command? flair token --help describes them: new");
  EXPECT_EQ(ErrorOf({"design", "A room."}), "--out: missing; flair design --help says more");
  EXPECT_EQ(ErrorOf({"render"}), "LAYOUT: missing; flair render --help says more");
  EXPECT_EQ(ErrorOf({"design", "A room.", "--out"}), "--out: its value is missing; flair design --help says more");
  EXPECT_EQ(ErrorOf({"design", "A", "room.", "--out", "x"}),
            "\"room.\": unexpected argument of flair design; put text of several words in quotes");
  EXPECT_EQ(ErrorOf({"solve", "g", "--seed", "1", "--seed", "2"}), "--seed: given more than once");
  EXPECT_EQ(ErrorOf({"design", "A.", "--out", "x", "--json", "--quiet"}), "--json: not together with --quiet");
  EXPECT_EQ(ErrorOf({"contract", "--markdown"}), "--markdown: only together with --list");
}

TEST_F(CommandsTest, ValuesOutOfRangeAreToldWithTheRange) {
  EXPECT_EQ(ErrorOf({"design", "A.", "--out", "x", "--size", "1.5"}),
            "--size: 1.5: expected a whole number, 256 to 8192");
  EXPECT_EQ(ErrorOf({"solve", "g", "--path-width", "nan"}), "--path-width: nan: expected a number, 0 to 2");
  EXPECT_EQ(ErrorOf({"jobs", "-n", "0"}), "--count: 0: expected a whole number, 1 to 100000");
}

TEST(BatchFlags, AFolderRemembersServersWithoutTheirCredentials) {
  CLI::App app;
  BatchPlaceFlags flags(app);
  flags.engine.address = "nats://user:secret@one:4222,nats://two:4222";
  BatchPlace place;
  FillPlace(flags, place);
  EXPECT_EQ(place.engine, "nats://one:4222,nats://two:4222");
  EXPECT_EQ(place.store, "") << "elsewhere";
}

}  // namespace

}  // namespace flair::cli
