// SPDX-License-Identifier: GPL-3.0-or-later
// An optimizer that is good but for one fault, on a real port: it asks a good one and spoils the answer.
#pragma once

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/worker_service.pb.h"

namespace grpc {
class Server;
}

namespace flair::testing {

// What is spoilt; whatever is unset is as it should be.
struct Fault {
  std::function<void(v1::SolveResponse&)> spoil_solve = {};
  // Instead of the good one's status.
  std::function<int(int code)> spoil_code = {};
  // Called with every Solve before anything else; may wait.
  std::function<void(const v1::SolveRequest&)> on_solve = {};
  std::function<void(v1::ListConstraintTypesResponse&)> spoil_catalogue = {};
  std::function<void(v1::EvaluateResponse&)> spoil_evaluate = {};
  // What it says of itself; nothing to have no WorkerService.
  std::optional<v1::GetWorkerResponse> worker = v1::GetWorkerResponse();
};

class SpoiltOptimizer {
 public:
  // `good` is the address of the one that is asked.
  SpoiltOptimizer(const std::string& good, Fault fault);
  ~SpoiltOptimizer();
  const std::string& address() const { return address_; }
  // Breaks all connections and takes no new ones.
  void Stop();

 private:
  struct Services;
  std::unique_ptr<Services> services_;
  std::unique_ptr<grpc::Server> server_;
  std::string address_;
};

// A server that answers every call of every service with these bytes; with none at all when `silent`.
class AnyServer {
 public:
  AnyServer(std::string bytes, bool silent);
  ~AnyServer();
  const std::string& address() const { return address_; }

 private:
  struct Service;
  std::unique_ptr<Service> service_;
  std::unique_ptr<grpc::Server> server_;
  std::string address_;
};

}  // namespace flair::testing
