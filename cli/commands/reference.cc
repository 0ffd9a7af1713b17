// SPDX-License-Identifier: GPL-3.0-or-later
// flair catalog, flair protocol, flair prompts: what those who put stages of their own in the place of ours read.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/message_text.h"
#include "cli/input/options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/protocol/protocol.h"
#include "fmt/format.h"
#include "language_worker/model/model_tools.h"
#include "optimizer_worker/constraints/facts.h"
#include "translator_worker/model/model_translator.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace {

struct CatalogArguments : Options {
  using Options::Options;
  std::string& type = Text("TYPE", "One type in full, by name or alias");
  bool& json = Flag("--json", "As JSON");
  bool& markdown = Flag("--markdown", "All of them in full, as docs/constraints.md", {"--json"});
};

absl::Status Catalog(const CatalogArguments& arguments) {
  const v1::ConstraintCatalog& catalog = optimizer::MakeCatalog();
  if (!arguments.type.empty()) {
    const optimizer::ConstraintFacts* const facts = optimizer::FindConstraint(arguments.type);
    if (facts == nullptr) {
      std::vector<std::string> names;
      for (const v1::ConstraintType& type : catalog.types()) names.push_back(type.name());
      return absl::NotFoundError(fmt::format("\"{}\" is not a constraint{}; flair catalog lists them", arguments.type,
                                             DidYouMean(arguments.type, names)));
    }
    for (const v1::ConstraintType& type : catalog.types()) {
      if (type.name() == facts->name()) fmt::print("{}", arguments.json ? ToJson(type) : TypeText(type));
    }
    return absl::OkStatus();
  }
  fmt::print("{}", arguments.json       ? ToJson(catalog)
                   : arguments.markdown ? CatalogMarkdown(catalog)
                                        : CatalogOverview(catalog));
  return absl::OkStatus();
}

struct ProtocolArguments : Options {
  using Options::Options;
  std::string& name = Text("NAME", "One entry in full: a service, call, message or enum");
  bool& markdown = Flag("--markdown", "All of them in full, as docs/protocol.md", {"NAME"});
};

absl::Status Protocol(const ProtocolArguments& arguments) {
  if (arguments.name.empty()) {
    fmt::print("{}", arguments.markdown ? ProtocolMarkdown() : ProtocolOverview());
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(const std::string entry, ProtocolEntryText(arguments.name));
  fmt::print("{}", entry);
  return absl::OkStatus();
}

namespace fs = std::filesystem;

struct PromptsArguments : Options {
  using Options::Options;
  std::string& out = Required("-o,--out DIR", "Folder to write them to");
};

// The prompts of one worker's folder. Both have a "repair", which is the same.
absl::Status AddFolder(const fs::path& folder, std::vector<OutputFile>& files) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".txt") continue;
    ASSIGN_OR_RETURN(std::string text, ReadFile(entry.path()));
    const std::string name = entry.path().filename().string();
    const auto same =
        std::find_if(files.begin(), files.end(), [&](const OutputFile& file) { return file.name == name; });
    if (same == files.end()) {
      files.push_back({name, std::move(text)});
    } else if (same->content != text) {
      return absl::InternalError(fmt::format("{}: two workers' prompts of this name differ", entry.path().string()));
    }
  }
  if (error) return FileError(fmt::format("{}: {}; build again: ./flair build", folder.string(), error.message()));
  return absl::OkStatus();
}

absl::Status WritePrompts(const PromptsArguments& arguments) {
  std::vector<OutputFile> files;
  for (const fs::path& folder : {language::DefaultPromptsFolder(), translator::DefaultPromptFolder()}) {
    RETURN_IF_ERROR(AddFolder(folder, files));
  }
  std::sort(files.begin(), files.end(), [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  std::vector<std::string> names;
  for (const OutputFile& file : files) {
    names.push_back(file.name);
    std::error_code error;
    if (!fs::exists(fs::path(arguments.out) / file.name, error)) continue;
    return FileError(
        fmt::format("{}/{}: already exists and may be your own; choose another folder", arguments.out, file.name));
  }
  RETURN_IF_ERROR(CheckOutputFolder(arguments.out, names));
  RETURN_IF_ERROR(WriteOutputFolder(arguments.out, files));
  for (const std::string& name : names) fmt::print(stderr, "{}/{}\n", arguments.out, name);
  fmt::print(stderr, "next       flair design TEXT --out DIR --llm FILE --prompts {}\n", arguments.out);
  return absl::OkStatus();
}

}  // namespace

void AddCatalog(const Commands& program) {
  program.Add("catalog", "List the constraints that the optimizer understands.", Catalog);
}

void AddProtocol(const Commands& program) {
  program.Add("protocol", "List the services and messages of the protocol.", Protocol);
}

void AddPrompts(const Commands& program) {
  program.Add("prompts", "Write the prompts for language models to files, for you to change.", WritePrompts,
              "Keep the files that you change and delete the others, so that those of the installed version are used.");
}

}  // namespace flair::cli
