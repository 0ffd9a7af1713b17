// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/client_call.h"

#include <fmt/format.h>

#include <array>

#include "absl/strings/cord.h"
#include "flair/v1/worker_service.pb.h"

namespace flair::runtime {
namespace {

// If gRPC's message contains `sign`, ours is `words`, where {0} is the address.
struct Translation {
  std::string_view sign;
  std::string_view words;
};

// Errors of connections; the first match counts.
constexpr std::array kConnectionErrors = {
    Translation{"Connection refused", "connection refused, nothing listens on {0}"},
    Translation{"No such file or directory", "there is no socket {0}"},
    Translation{"Permission denied", "permission denied for {0}"},
    Translation{"No route to host", "no route to {0}"},
    Translation{"Network is unreachable", "the network of {0} is unreachable"},
    Translation{"wrong version number", "{0} does not use TLS"},
    Translation{"certificate verify failed",
                "the certificate of {0} has expired, or no trusted authority has signed it"},
    Translation{"Hostname Verification Check failed", "the certificate of {0} is for another name"},
    Translation{"Failed parsing HTTP/2", "{0} is not a gRPC server"},
    Translation{"timed out before receiving SETTINGS",
                "{0} accepts connections but does not respond; is it a gRPC server, and does it expect TLS?"},
    Translation{"Handshake read failed", "{0} accepts connections but does not respond; is it a gRPC server with TLS?"},
    Translation{"Timeout occurred", "{0} does not answer"},
    Translation{"Connection timed out", "{0} does not answer"},
    Translation{"Socket closed", "{0} closed the connection at once; does it expect TLS, or another certificate?"},
    Translation{"Connection reset by peer",
                "{0} closed the connection at once; does it expect TLS, or another certificate?"},
};

// Of a server that is sent more large messages than it has room for, and of one that stops.
constexpr std::array kTurnedAway = {kNoRoom, "the server closed the connection before it took the call; try again"};

// Whole messages without an address.
constexpr std::array kWholeMessages = {
    Translation{"Deadline Exceeded", "no answer in time"},
    Translation{"Socket closed", "the connection was closed during the call"},
    Translation{"Received RST_STREAM with error code 11", kTurnedAway[0]},
    Translation{"GOAWAY received", kTurnedAway[1]},
};

// Errors of name resolution; {0} is the name with its port.
constexpr std::array kNameErrors = {
    Translation{"Domain name not found", "the host name {0} is unknown"},
    Translation{"DNS server returned answer with no data", "the name {0} has no address"},
    Translation{"Could not contact DNS servers", "{0} cannot be resolved: no DNS server answers"},
    Translation{"Timeout while contacting DNS servers", "{0} cannot be resolved: no DNS server answers"},
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
  for (const Translation& error : kConnectionErrors) {
    if (Holds(what, error.sign)) return fmt::format(fmt::runtime(error.words), address);
  }
  return fmt::format("no connection to {}: {}", address, what);
}

std::string NameWords(std::string_view message, std::string_view rest) {
  const std::string_view name = rest.substr(0, rest.find(": "));
  for (const Translation& error : kNameErrors) {
    if (Holds(rest, error.sign)) return fmt::format(fmt::runtime(error.words), name);
  }
  return std::string(message);
}

constexpr char kOfConnection[] = "flair/of-connection";
constexpr int kProtocolsNamed = 4;
constexpr size_t kNameLength = 60;

// Text from another program, cut and made safe for our messages and for terminals.
std::string Printable(const std::string& text) {
  std::string shown = text.substr(0, kNameLength);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return shown;
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
    return fmt::format("a web server or proxy answers there (status {}), not a gRPC server", After(message, kWebStart));
  }
  for (const Translation& error : kWholeMessages) {
    if (message == error.sign) return std::string(error.words);
  }
  return std::string(message);
}

bool TurnedAway(const absl::Status& status) {
  return std::ranges::find(kTurnedAway, status.message()) != kTurnedAway.end();
}

bool HandshakeTimedOut(const absl::Status& status) {
  const std::string_view message(status.message().data(), status.message().size());
  return absl::IsUnavailable(status) && Holds(message, " accepts connections but does not respond; ");
}

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  return grpc::Status(static_cast<grpc::StatusCode>(status.code()), std::string(status.message()));
}

absl::Status FromGrpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  return absl::Status(static_cast<absl::StatusCode>(status.error_code()), InPlainWords(status.error_message()));
}

absl::Status FromGrpcStatus(const grpc::Status& status, const grpc::ClientContext& context) {
  absl::Status made = FromGrpcStatus(status);
  // What gRPC notes of every status that came over the wire.
  if (!Holds(context.debug_error_string(), "Error received from peer")) made.SetPayload(kOfConnection, absl::Cord());
  return made;
}

bool IsOfConnection(const absl::Status& status) { return status.GetPayload(kOfConnection).has_value(); }

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
