// SPDX-License-Identifier: GPL-3.0-or-later
// flair mcp: rooms for agents.
#include <csignal>
#include <cstdio>

#include "cli/commands/commands.h"
#include "cli/input/options.h"
#include "cli/mcp/document_tools.h"
#include "cli/mcp/server.h"
#include "cli/mcp/stdio.h"
#include "cli/session/open_documents.h"
#include "fmt/format.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct McpArguments : Options {
  using Options::Options;
  std::string& root = Text("--root DIR", "Folder that the tool export may write to, and nowhere else (.)");
  DocumentFlags documents{command()};
};

absl::Status Mcp(const McpArguments& arguments) {
  ASSIGN_OR_RETURN(const mcp::RootFolder root, mcp::RootFolder::Open(arguments.root.empty() ? "." : arguments.root));
  ASSIGN_OR_RETURN(const int out, mcp::ReserveStandardOutput());
  ASSIGN_OR_RETURN(const int stop, StopDescriptor());
  std::signal(SIGPIPE, SIG_IGN);
  ASSIGN_OR_RETURN(const auto opened, OpenDocuments::Open(arguments.documents));
  mcp::DocumentTools tools(opened->documents(), root);
  mcp::Lines lines{.in = 0, .out = out, .stop = stop};
  mcp::Server server({.server_info = {{"name", "flair"}, {"title", "Flair"}, {"version", FLAIR_VERSION}},
                      .instructions = tools.Instructions(),
                      .tools = tools.Tools(),
                      .resources = tools.MakeResources()},
                     [&lines](const std::string& line) { lines.Write(line); });
  fmt::print(stderr, "flair mcp: ready; files are written below {}\n", root.path().string());
  lines.Read(
      mcp::kMostLineBytes, [&server](std::string_view line) { server.Receive(line); },
      [&server] { server.ReceiveTooLong(); });
  return absl::OkStatus();
}

}  // namespace

void AddMcp(const Commands& program) {
  program.Add("mcp", "Let agents design, edit and explain rooms (Model Context Protocol).", Mcp,
              "Speaks the protocol on standard input and output, until the input ends. Agents start it themselves:\n"
              "register this command with yours (docs/mcp.md). Rooms are those of flair studio.");
}

}  // namespace flair::cli
