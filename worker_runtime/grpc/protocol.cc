// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/protocol.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair::runtime {
namespace {

constexpr int kProtocolsNamed = 4;
constexpr size_t kNameLength = 60;

// Another program's words go into our messages and to people's terminals.
std::string Printable(const std::string& text) {
  std::string shown = text.substr(0, kNameLength);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return shown;
}

}  // namespace

std::string ProtocolFault(const v1::GetWorkerResponse& worker) {
  const auto& protocols = worker.protocols();
  if (protocols.empty() || std::ranges::find(protocols, kProtocol) != protocols.end()) return "";
  std::string spoken;
  for (int i = 0; i < std::min(protocols.size(), kProtocolsNamed); ++i) {
    spoken += (i > 0 ? ", " : "") + Printable(protocols[i]);
  }
  if (protocols.size() > kProtocolsNamed) spoken += ", ...";
  const std::string program = worker.program().empty() ? "the server" : Printable(worker.program());
  return fmt::format("{} speaks {}, this program {}", program, spoken, kProtocol);
}

}  // namespace flair::runtime
