// SPDX-License-Identifier: GPL-3.0-or-later
// flair prompts: what models are asked with, to start own prompts from.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/files.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "language_worker/model/model_tools.h"
#include "translator_worker/model/model_translator.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

struct PromptsArguments {
  std::string out;
};

// The prompts of one worker's folder. Both have a "repair", which is the same.
absl::Status AddFolder(const fs::path& folder, std::vector<OutputFile>& files) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".txt") continue;
    absl::StatusOr<std::string> text = ReadFile(entry.path());
    if (!text.ok()) return text.status();
    const std::string name = entry.path().filename().string();
    const auto same =
        std::find_if(files.begin(), files.end(), [&](const OutputFile& file) { return file.name == name; });
    if (same == files.end()) {
      files.push_back({name, *std::move(text)});
    } else if (same->content != *text) {
      return absl::InternalError(fmt::format("{}: two workers' prompts of this name differ", entry.path().string()));
    }
  }
  if (error) return FileError(fmt::format("{}: {}; build again: ./flair build", folder.string(), error.message()));
  return absl::OkStatus();
}

absl::Status WritePrompts(const PromptsArguments& arguments) {
  std::vector<OutputFile> files;
  for (const fs::path& folder : {language::DefaultPromptsFolder(), translator::DefaultPromptFolder()}) {
    if (absl::Status status = AddFolder(folder, files); !status.ok()) return status;
  }
  std::sort(files.begin(), files.end(), [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  std::vector<std::string> names;
  for (const OutputFile& file : files) {
    names.push_back(file.name);
    std::error_code error;
    if (!fs::exists(fs::path(arguments.out) / file.name, error)) continue;
    return FileError(
        fmt::format("{}/{}: is there already and may be your own; choose another folder", arguments.out, file.name));
  }
  if (absl::Status status = CheckOutputFolder(arguments.out, names); !status.ok()) return status;
  if (absl::Status status = WriteOutputFolder(arguments.out, files); !status.ok()) return status;
  for (const std::string& name : names) fmt::print(stderr, "{}/{}\n", arguments.out, name);
  fmt::print(stderr, "next       flair design TEXT --out DIR --llm FILE --prompts {}\n", arguments.out);
  return absl::OkStatus();
}

}  // namespace

void AddPrompts(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<PromptsArguments>();
  CLI::App* command = program.add_subcommand("prompts", "Write the prompts for language models, to change them.");
  command->add_option("-o,--out", arguments->out, "Folder to write them to")->required()->type_name("DIR");
  command->footer(
      "Keep the files that you change and remove the rest: the installed ones serve then, also those of "
      "later versions.");
  command->callback([arguments, &result] { result = WritePrompts(*arguments); });
}

}  // namespace flair::cli
