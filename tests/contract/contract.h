// SPDX-License-Identifier: GPL-3.0-or-later
// What the contract suites run against. An address in the environment (FLAIR_CONTRACT_LANGUAGE, _TRANSLATOR,
// _OPTIMIZER, _RENDERER) puts somebody else's server to the test; without one, Flair's own program is started on a free
// port.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "tests/fixtures/bedroom.h"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::testing {

// A server under test, such as "language".
class ServerUnderTest {
 public:
  explicit ServerUnderTest(const std::string& name);
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }

 private:
  TestFolder folder_;
  std::unique_ptr<ServerProgram> program_;
  std::shared_ptr<grpc::Channel> channel_;
};

// Calls with a deadline of a minute.
template <typename Stub, typename Interface, typename Request, typename Response>
absl::StatusOr<Response> Ask(Stub& stub,
                             grpc::Status (Interface::*method)(grpc::ClientContext*, const Request&, Response*),
                             const Request& request) {
  runtime::CallContext call;
  return runtime::UnaryRequest(stub, method, request, call, absl::Now() + absl::Minutes(1));
}

// A brief and a small problem that every server must cope with: a bed and a nightstand in BedroomRoom().
v1::Brief BedroomBrief();
v1::LayoutGraph BedroomGraph();

}  // namespace flair::testing
