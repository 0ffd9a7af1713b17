// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/connection_gate.h"

#include <netinet/in.h>

#include <vector>

namespace flair::runtime {
namespace {

constexpr size_t kNetworkBytes = 8;
constexpr absl::Duration kSweepEvery = absl::Milliseconds(100);

// Unique among all sockets of the machine's life; 0 when `file` is no socket any more.
uint64_t CookieOf(int file) {
  uint64_t cookie = 0;
  socklen_t size = sizeof cookie;
  return ::getsockopt(file, SOL_SOCKET, SO_COOKIE, &cookie, &size) == 0 ? cookie : 0;
}

std::string KeyOf(const sockaddr_storage& peer) {
  if (peer.ss_family == AF_INET) {
    const auto& address = reinterpret_cast<const sockaddr_in&>(peer).sin_addr;
    return std::string(reinterpret_cast<const char*>(&address), sizeof address);
  }
  if (peer.ss_family == AF_INET6) {
    const auto& address = reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr;
    if (IN6_IS_ADDR_V4MAPPED(&address)) return std::string(reinterpret_cast<const char*>(&address) + 12, 4);
    return std::string(reinterpret_cast<const char*>(&address), kNetworkBytes);
  }
  return "";
}

}  // namespace

bool ConnectionGate::Admit(int file, const sockaddr_storage& peer, absl::Duration now) {
  // Whoever had that number has closed it. New files get the lowest free number, so it says how many are open.
  Forget(file);
  if (file >= file_limit_) return false;
  const std::string key = KeyOf(peer);
  if (static_cast<int>(files_of_peers_[key].size()) >= peer_limit_) Sweep(key, now);
  std::unordered_set<int>& files = files_of_peers_[key];
  if (static_cast<int>(files.size()) >= peer_limit_) return false;
  files.insert(file);
  connections_[file] = {CookieOf(file), key};
  return true;
}

void ConnectionGate::Forget(int file) {
  const auto connection = connections_.find(file);
  if (connection == connections_.end()) return;
  const auto files = files_of_peers_.find(connection->second.peer);
  files->second.erase(file);
  if (files->second.empty()) files_of_peers_.erase(files);
  connections_.erase(connection);
}

void ConnectionGate::Sweep(const std::string& peer, absl::Duration now) {
  // It takes a while: nobody may ask for it by every connection that is refused.
  if (now - swept_at_ < kSweepEvery) return;
  swept_at_ = now;
  const std::unordered_set<int>& files = files_of_peers_[peer];
  const std::vector<int> known(files.begin(), files.end());
  for (const int file : known) {
    if (CookieOf(file) != connections_[file].cookie) Forget(file);
  }
}

}  // namespace flair::runtime
