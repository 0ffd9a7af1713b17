// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/client_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "flair/v1/worker_service.pb.h"

namespace flair::runtime {
namespace {

// gRPC's sentence holds `sign`; {0} in `words` is the address.
struct Trouble {
  std::string_view sign;
  std::string_view words;
};

// Of connections: the first whose sign is there.
constexpr std::array kTroubles = {
    Trouble{"Connection refused", "connection refused, nothing listens on {0}"},
    Trouble{"No such file or directory", "there is no socket {0}"},
    Trouble{"Permission denied", "permission denied for {0}"},
    Trouble{"No route to host", "no route to {0}"},
    Trouble{"Network is unreachable", "the network of {0} cannot be reached"},
    Trouble{"wrong version number", "TLS was tried, but {0} does not speak it"},
    Trouble{"certificate verify failed",
            "{0} shows a certificate that is not of an authority that we believe, or has expired"},
    Trouble{"Hostname Verification Check failed", "{0} shows a certificate for another name than the one called"},
    Trouble{"Failed parsing HTTP/2", "{0} is no gRPC server"},
    Trouble{"timed out before receiving SETTINGS",
            "{0} takes connections but says nothing; is it a gRPC server, and does it expect TLS?"},
    Trouble{"Handshake read failed", "{0} takes connections but says nothing; is it a gRPC server with TLS?"},
    Trouble{"Timeout occurred", "{0} does not answer"},
    Trouble{"Connection timed out", "{0} does not answer"},
    Trouble{"Socket closed", "{0} closed the connection at once; does it expect TLS, or another certificate?"},
    Trouble{"Connection reset by peer",
            "{0} closed the connection at once; does it expect TLS, or another certificate?"},
};

// Whole messages that say nothing of where.
constexpr std::array kBrief = {
    Trouble{"Deadline Exceeded", "no answer in time"},
    Trouble{"Socket closed", "the connection was closed during the call"},
};

// Signs of names; {0} is the name with its port.
constexpr std::array kNameTroubles = {
    Trouble{"Domain name not found", "no machine of the name {0} is known"},
    Trouble{"DNS server returned answer with no data", "the name {0} has no address"},
    Trouble{"Could not contact DNS servers", "the address of {0} is not known, since no DNS server answers"},
    Trouble{"Timeout while contacting DNS servers", "the address of {0} is not known, since no DNS server answers"},
};

bool Holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::string After(std::string_view text, std::string_view start) { return std::string(text.substr(start.size())); }

// "ipv4:127.0.0.1:5" as "127.0.0.1:5", "ipv6:%5B::1%5D:5" as "[::1]:5", "unix:/a" as it is.
std::string PlainAddress(std::string_view address) {
  if (address.starts_with("ipv4:")) return After(address, "ipv4:");
  if (!address.starts_with("ipv6:%5B")) return std::string(address);
  std::string plain = "[" + After(address, "ipv6:%5B");
  if (const size_t end = plain.find("%5D"); end != std::string::npos) plain.replace(end, 3, "]");
  return plain;
}

// `reason` is "UNKNOWN: ADDRESS: what happened", where an address has colons but no spaces.
std::string ConnectionWords(std::string_view message, std::string_view reason) {
  const size_t start = reason.find(": ");
  const size_t end = start == std::string_view::npos ? start : reason.find(": ", start + 2);
  if (end == std::string_view::npos) return std::string(message);
  const std::string address = PlainAddress(reason.substr(start + 2, end - start - 2));
  const std::string_view what = reason.substr(end + 2);
  for (const Trouble& trouble : kTroubles) {
    if (Holds(what, trouble.sign)) return fmt::format(fmt::runtime(trouble.words), address);
  }
  return fmt::format("no connection to {}: {}", address, what);
}

std::string NameWords(std::string_view message, std::string_view rest) {
  const std::string_view name = rest.substr(0, rest.find(": "));
  for (const Trouble& trouble : kNameTroubles) {
    if (Holds(rest, trouble.sign)) return fmt::format(fmt::runtime(trouble.words), name);
  }
  return std::string(message);
}

}  // namespace

std::string InPlainWords(std::string_view message) {
  for (const std::string_view start :
       {"failed to connect to all addresses; last error: ", "connections to all backends failing; last error: "}) {
    if (message.starts_with(start)) return ConnectionWords(message, message.substr(start.size()));
  }
  constexpr std::string_view kNameStart = "DNS resolution failed for ";
  if (message.starts_with(kNameStart)) return NameWords(message, message.substr(kNameStart.size()));
  constexpr std::string_view kWebStart = "Received http2 header with status: ";
  if (message.starts_with(kWebStart)) {
    return fmt::format("a web server or proxy answers there (status {}), no gRPC server", After(message, kWebStart));
  }
  for (const Trouble& trouble : kBrief) {
    if (message == trouble.sign) return std::string(trouble.words);
  }
  return std::string(message);
}

bool SaidNoHello(const absl::Status& status) {
  const std::string_view message(status.message().data(), status.message().size());
  return absl::IsUnavailable(status) && Holds(message, " takes connections but says nothing; ");
}

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  return grpc::Status(static_cast<grpc::StatusCode>(status.code()), std::string(status.message()));
}

absl::Status FromGrpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  return absl::Status(static_cast<absl::StatusCode>(status.error_code()), InPlainWords(status.error_message()));
}

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
