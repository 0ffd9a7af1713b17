// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"

namespace flair::runtime {

// Decides which new connections a server keeps: neither so many in all that the process runs out of files, nor so many
// of one address that there are none left for others. Not thread-safe.
class ConnectionGate {
 public:
  // `file_limit`: what the process may open. An eighth of it is kept for everything that is no connection; one address
  // (of IPv6: one network of 64 bits) gets a quarter of the rest. Unix sockets are all one address.
  explicit ConnectionGate(int file_limit);
  ~ConnectionGate();

  // Whether the connection that was just accepted as `file` from `peer` may stay. Connections that were closed since
  // are noticed by themselves, whoever closes them: of a peer that has its share, within a tenth of a second. `now`
  // never goes back (Clock::Elapsed).
  bool Admit(int file, const sockaddr_storage& peer, absl::Duration now);

  // Forgets connections that are closed, and ends those that take all and are told nothing, which only happens to
  // headers that never end: gRPC 1.51 keeps all of those and waits for more. Everything else is answered, be it by a
  // ping or by leave to send more. Ended are the largest while all together have too much unanswered, and who is not
  // answered for a second, or sends little for a minute. Does nothing when it has just looked. Returns when to look
  // again; nothing when `activity` will tell.
  absl::Duration Look(absl::Duration now);
  // To be polled: can be read when a connection was sent something.
  int activity() const { return activity_; }

  int peer_limit() const { return peer_limit_; }

 private:
  struct Connection {
    // Whether more was taken of it since the last look.
    bool Measure(int file, absl::Duration now);
    void End(int file);

    uint64_t cookie = 0;
    std::string peer;
    // Bytes that were sent to it; those that were taken of it, in all and when something was last sent to it; since
    // then, when the first was taken, and looks that found more.
    uint64_t sent = 0;
    int64_t taken = 0;
    int64_t answered = 0;
    absl::Duration answered_at = absl::ZeroDuration();
    int unanswered_looks = 0;
    bool ended = false;
  };
  void Forget(int file);

  const int file_limit_;
  const int peer_limit_;
  const int activity_;
  std::unordered_map<int, Connection> connections_;
  std::unordered_map<std::string, std::unordered_set<int>> files_of_peers_;
  absl::Duration looked_at_ = -absl::InfiniteDuration();
};

// Accepts TCP connections in place of gRPC 1.51, which stops accepting for ever when the process has once run out of
// files.
class Listener {
 public:
  // Binds "HOST:PORT", to all addresses of HOST; port 0 takes a free one. Allows the process as many files as it may
  // have. UNAVAILABLE when the address cannot be bound.
  static absl::StatusOr<std::unique_ptr<Listener>> Bind(const std::string& address);

  // As Stop.
  ~Listener();

  // With the port that was taken.
  const std::string& address() const { return address_; }

  // Calls `take` for every connection, which owns `connection` from then on, on a thread of its own.
  void Start(std::function<void(int listener, int connection)> take);

  // Accepts no more, and returns when no connection is being taken. May be called more than once.
  void Stop();

 private:
  Listener(std::string address, std::vector<int> files, int wake, int file_limit)
      : address_(std::move(address)), files_(std::move(files)), wake_(wake), gate_(file_limit) {}
  void Run(const std::function<void(int, int)>& take);
  void Watch();
  // False when the process is out of files.
  bool AcceptAll(int listener, const std::function<void(int, int)>& take);

  const std::string address_;
  const std::vector<int> files_;
  const int wake_;
  std::mutex mutex_;
  ConnectionGate gate_;
  std::thread thread_;
  std::thread watch_;
};

}  // namespace flair::runtime
