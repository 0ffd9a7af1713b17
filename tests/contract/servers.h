// SPDX-License-Identifier: GPL-3.0-or-later
// Servers on real ports for the checks of `flair contract`: our own programs, an optimizer that is good but for one
// fault, and one that is no server of ours.
#pragma once

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/contract/check.h"
#include "cli/contract/target.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "tests/fixtures/programs.h"

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

// It asks a good one and spoils the answer.
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

// Flair's own program of a stage on a free port; of the orchestrator all five. Workers have one thread each: they
// answer only when they have let go of what came before.
class StageProgram {
 public:
  explicit StageProgram(const contract::Stage& stage);
  const std::string& address() const { return address_; }

 private:
  TestFolder folder_;
  std::unique_ptr<ServerProgram> worker_;
  std::unique_ptr<AllPrograms> all_;
  std::string address_;
};

// A connection to the server at the address; fails the test when there is none.
std::unique_ptr<contract::Target> ConnectTo(const contract::Stage& stage, const std::string& address,
                                            absl::Duration patience = absl::Seconds(60));

// What came back and what would be right, for messages of tests.
std::string FindingText(const contract::Finding& finding);

}  // namespace flair::testing
