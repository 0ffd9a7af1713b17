// SPDX-License-Identifier: GPL-3.0-or-later
// flair protocol: the services and messages of package flair.v1.
#include "cli/protocol/protocol.h"

#include <cstdio>

#include "cli/commands/commands.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct ProtocolArguments : Options {
  using Options::Options;
  std::string& name = Text("NAME", "One of them in full: a service, call, message or enum");
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

}  // namespace

void AddProtocol(const Commands& program) {
  program.Add("protocol", "List the services and messages of the protocol.", Protocol);
}

}  // namespace flair::cli
