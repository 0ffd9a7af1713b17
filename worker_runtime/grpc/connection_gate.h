// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "absl/time/time.h"

namespace flair::runtime {

// Decides which new connections a server keeps: neither so many in all that the process runs out of files, nor so many
// of one address that there are none left for others. Not thread-safe.
class ConnectionGate {
 public:
  // `file_limit`: what the process may open. An eighth of it is kept for everything that is no connection; one address
  // (of IPv6: one network of 64 bits) gets a quarter of the rest. Unix sockets are all one address.
  explicit ConnectionGate(int file_limit)
      : file_limit_(file_limit - file_limit / 8), peer_limit_((file_limit_ + 3) / 4) {}

  // Whether the connection that was just accepted as `file` from `peer` may stay. Connections that were closed since
  // are noticed by themselves, whoever closes them: of a peer that has its share, within a tenth of a second. `now`
  // never goes back (Clock::Elapsed).
  bool Admit(int file, const sockaddr_storage& peer, absl::Duration now);

  int peer_limit() const { return peer_limit_; }

 private:
  struct Connection {
    uint64_t cookie = 0;
    std::string peer;
  };
  void Forget(int file);
  // Forgets the peer's connections that are closed, unless that was done just now.
  void Sweep(const std::string& peer, absl::Duration now);

  const int file_limit_;
  const int peer_limit_;
  std::unordered_map<int, Connection> connections_;
  std::unordered_map<std::string, std::unordered_set<int>> files_of_peers_;
  absl::Duration swept_at_ = -absl::InfiniteDuration();
};

}  // namespace flair::runtime
