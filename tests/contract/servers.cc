// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/servers.h"

#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <utility>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::testing {
namespace {

// Takes what is larger than it should be, so that only the good one refuses it.
constexpr int kMaxBytes = 256 * 1024 * 1024;

std::unique_ptr<grpc::Server> Listen(grpc::ServerBuilder& builder, std::string& address) {
  int port = 0;
  builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
  builder.SetMaxReceiveMessageSize(kMaxBytes);
  std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  address = fmt::format("127.0.0.1:{}", port);
  return server;
}

class Optimizer final : public v1::OptimizerService::Service {
 public:
  Optimizer(const std::string& good, const Fault& fault)
      : good_(v1::OptimizerService::NewStub(*runtime::MakeChannel(good, ""))), fault_(fault) {}

  grpc::Status Solve(grpc::ServerContext* context, const v1::SolveRequest* request,
                     v1::SolveResponse* response) override {
    if (fault_.on_solve) fault_.on_solve(*request);
    const auto asked = grpc::ClientContext::FromServerContext(*context);
    const grpc::Status status = good_->Solve(asked.get(), *request, response);
    if (status.ok() && fault_.spoil_solve) fault_.spoil_solve(*response);
    if (!fault_.spoil_code) return status;
    return {static_cast<grpc::StatusCode>(fault_.spoil_code(status.error_code())), status.error_message()};
  }
  grpc::Status ListConstraintTypes(grpc::ServerContext* context, const v1::ListConstraintTypesRequest* request,
                                   v1::ListConstraintTypesResponse* response) override {
    const auto asked = grpc::ClientContext::FromServerContext(*context);
    const grpc::Status status = good_->ListConstraintTypes(asked.get(), *request, response);
    if (fault_.spoil_catalogue) fault_.spoil_catalogue(*response);
    return status;
  }
  grpc::Status Evaluate(grpc::ServerContext* context, const v1::EvaluateRequest* request,
                        v1::EvaluateResponse* response) override {
    const auto asked = grpc::ClientContext::FromServerContext(*context);
    const grpc::Status status = good_->Evaluate(asked.get(), *request, response);
    if (fault_.spoil_evaluate) fault_.spoil_evaluate(*response);
    return status;
  }

 private:
  const std::unique_ptr<v1::OptimizerService::Stub> good_;
  const Fault& fault_;
};

class Worker final : public v1::WorkerService::Service {
 public:
  explicit Worker(const Fault& fault) : fault_(fault) {}
  grpc::Status GetWorker(grpc::ServerContext*, const v1::GetWorkerRequest*, v1::GetWorkerResponse* response) override {
    *response = *fault_.worker;
    return grpc::Status::OK;
  }

 private:
  const Fault& fault_;
};

// Answers one call with fixed bytes, or waits until the caller has gone.
class AnyCall final : public grpc::ServerGenericBidiReactor {
 public:
  AnyCall(const std::string& bytes, bool silent) : silent_(silent) {
    const grpc::Slice slice(bytes);
    answer_ = grpc::ByteBuffer(&slice, 1);
    StartRead(&request_);
  }

 private:
  void OnReadDone(bool) override {
    if (!silent_) StartWriteAndFinish(&answer_, {}, grpc::Status::OK);
  }
  void OnCancel() override {
    if (silent_) Finish(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

  const bool silent_;
  grpc::ByteBuffer request_;
  grpc::ByteBuffer answer_;
};

}  // namespace

struct SpoiltOptimizer::Services {
  Services(const std::string& good, Fault with) : fault(std::move(with)), optimizer(good, fault), worker(fault) {}
  const Fault fault;
  Optimizer optimizer;
  Worker worker;
};

SpoiltOptimizer::SpoiltOptimizer(const std::string& good, Fault fault)
    : services_(std::make_unique<Services>(good, std::move(fault))) {
  grpc::ServerBuilder builder;
  builder.RegisterService(&services_->optimizer);
  if (services_->fault.worker) builder.RegisterService(&services_->worker);
  server_ = Listen(builder, address_);
}

SpoiltOptimizer::~SpoiltOptimizer() { Stop(); }

void SpoiltOptimizer::Stop() { server_->Shutdown(std::chrono::system_clock::now()); }

struct AnyServer::Service final : public grpc::CallbackGenericService {
  Service(std::string bytes, bool silent) : bytes_(std::move(bytes)), silent_(silent) {}
  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new AnyCall(bytes_, silent_);
  }

 private:
  const std::string bytes_;
  const bool silent_;
};

AnyServer::AnyServer(std::string bytes, bool silent) : service_(std::make_unique<Service>(std::move(bytes), silent)) {
  grpc::ServerBuilder builder;
  builder.RegisterCallbackGenericService(service_.get());
  server_ = Listen(builder, address_);
}

AnyServer::~AnyServer() { server_->Shutdown(std::chrono::system_clock::now()); }

StageProgram::StageProgram(const contract::Stage& stage) {
  const std::string name = stage.name;
  if (name == "orchestrator") {
    all_ = std::make_unique<AllPrograms>(folder_.path());
    address_ = all_->orchestrator();
    return;
  }
  worker_ = std::make_unique<ServerProgram>(
      "flair-" + name, "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" worker_thread_count: 1 }",
      folder_.path());
  address_ = worker_->address();
}

std::unique_ptr<contract::Target> ConnectTo(const contract::Stage& stage, const std::string& address,
                                            absl::Duration patience) {
  auto target = contract::Target::Connect({.address = address, .service = stage.service, .patience = patience});
  EXPECT_TRUE(target.ok()) << target.status();
  return target.ok() ? *std::move(target) : nullptr;
}

std::string FindingText(const contract::Finding& finding) {
  return fmt::format("sent {}\n got {}\n right is {}\n reason {}", finding.sent, finding.got, finding.right,
                     finding.reason);
}

}  // namespace flair::testing
