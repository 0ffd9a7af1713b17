// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/command_line.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "absl/strings/numbers.h"
#include "cli/input/message_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "worker_runtime/text/read_number.h"

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
  return fmt::format("\"{}\": unexpected argument of {}; put text of several words in quotes", word, called.name);
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
        fmt::format("which command? {} --help describes them: {}", called.name, ListNames(CommandsOf(*called.app), 40));
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
    text = SubjectOf(message, ":") + ": given more than once";
  } else if (error.get_name() == "ValidationError") {
    text = message;
  }
  return absl::InvalidArgumentError(text);
}

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
    const std::optional<double> value = ReadNumber(text);
    if (value && *value >= least && *value <= most) return "";
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
