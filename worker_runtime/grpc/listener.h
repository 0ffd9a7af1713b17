// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "worker_runtime/grpc/connection_gate.h"

namespace flair::runtime {

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
  // False when the process is out of files.
  bool AcceptAll(int listener, const std::function<void(int, int)>& take);

  const std::string address_;
  const std::vector<int> files_;
  const int wake_;
  ConnectionGate gate_;
  std::thread thread_;
};

}  // namespace flair::runtime
