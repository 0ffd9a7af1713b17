// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/usage_error.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/input/message_words.h"
#include "cli/output/printable.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// The command that was called, and its whole name.
struct CalledCommand {
  const CLI::App* app;
  std::string name;
};

CalledCommand CalledOf(const CLI::App& program) {
  CalledCommand called{&program, program.get_name()};
  while (!called.app->get_subcommands().empty()) {
    called.app = called.app->get_subcommands().front();
    called.name += " " + called.app->get_name();
  }
  return called;
}

std::vector<std::string> CommandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> OptionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

bool IsOption(std::string_view word) { return word.size() > 1 && word.front() == '-'; }

// Of the words that nothing takes, what is most likely wrong.
std::string UnexpectedWord(const CalledCommand& called, const std::vector<std::string>& words) {
  const auto option = std::ranges::find_if(words, IsOption);
  if (option != words.end()) {
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("{}: {} has no such option{}; {} --help lists them", Printable(name), called.name,
                       DidYouMean(name, OptionsOf(*called.app)), called.name);
  }
  const std::string word = Printable(words.front());
  if (const std::vector<std::string> commands = CommandsOf(*called.app); !commands.empty()) {
    return fmt::format("{}: {} has no such command{}; {} --help lists them", word, called.name,
                       DidYouMean(word, commands), called.name);
  }
  return fmt::format("\"{}\": is more than {} takes; a text of several words stands between quotes", word, called.name);
}

// The part of CLI11's message before `words`, with which it goes on.
std::string SubjectOf(const std::string& message, std::string_view words) {
  return message.substr(0, message.find(words));
}

std::string WordsAfter(const std::string& message, std::string_view words) {
  const size_t at = message.find(words);
  return at == std::string::npos ? "" : message.substr(at + words.size());
}

}  // namespace

absl::Status UsageError(const CLI::App& program, const CLI::ParseError& error) {
  const CalledCommand called = CalledOf(program);
  const std::string message = error.what();
  const std::string more = fmt::format("; {} --help says more", called.name);
  const std::vector<std::string> unexpected = program.remaining(true);
  const bool lacks_command = called.app->get_require_subcommand_min() > 0;
  std::string text = message + more;
  // Its name is that of the command, unlike other errors' names.
  const bool extras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  if (!unexpected.empty() && (lacks_command || extras)) {
    text = UnexpectedWord(called, unexpected);
  } else if (lacks_command) {
    text =
        fmt::format("which command? {} --help tells of them: {}", called.name, ListNames(CommandsOf(*called.app), 40));
  } else if (error.get_name() == "RequiredError") {
    text = SubjectOf(message, " is required") + ": missing" + more;
  } else if (error.get_name() == "ExcludesError") {
    text = fmt::format("{}: not together with {}", SubjectOf(message, " excludes "), WordsAfter(message, " excludes "));
  } else if (error.get_name() == "RequiresError") {
    text =
        fmt::format("{}: only together with {}", SubjectOf(message, " requires "), WordsAfter(message, " requires "));
  } else if (error.get_name() == "ArgumentMismatch" && message.find(" missing") != std::string::npos) {
    text = SubjectOf(message, ":") + ": its value is missing" + more;
  } else if (error.get_name() == "ArgumentMismatch" && message.find(" received ") != std::string::npos) {
    text = SubjectOf(message, ":") + ": given more than once; once is right";
  } else if (error.get_name() == "ValidationError") {
    text = message;
  }
  return absl::InvalidArgumentError(text);
}

}  // namespace flair::cli
