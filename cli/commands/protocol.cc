// SPDX-License-Identifier: GPL-3.0-or-later
// flair protocol: the services and messages of package flair.v1.
#include "cli/protocol/protocol.h"

#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct ProtocolArguments {
  std::string name;
  bool markdown = false;
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

}  // namespace

void AddProtocol(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ProtocolArguments>();
  CLI::App* command = program.add_subcommand("protocol", "List the services and messages of the protocol.");
  CLI::Option* const name =
      command->add_option("NAME", arguments->name, "One of them in full: a service, call, message or enum");
  command->add_flag("--markdown", arguments->markdown, "All of them in full, as docs/protocol.md")->excludes(name);
  command->callback([arguments, &result] { result = Protocol(*arguments); });
}

}  // namespace flair::cli
