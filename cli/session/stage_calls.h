// SPDX-License-Identifier: GPL-3.0-or-later
// Single stages called alone, in this process or at an address: the renderer, the optimizer.
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cli/input/options.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::cli {

// Which renderer draws: the one at `address`, or one in this process.
struct RendererChoice {
  std::string address;
  std::string asset_folder;  // of the one in this process; empty: none
  int thread_count = 0;      // of the one in this process, for a ray-traced view; 0: all cores
};

struct RendererFlags : Options, RendererChoice {
  explicit RendererFlags(CLI::App& command);
};

class ContactSheetCall;

// A renderer to call. Waits for hours: a view of many samples takes its time.
class RendererClient {
 public:
  static absl::StatusOr<std::unique_ptr<RendererClient>> Open(const RendererChoice& choice);

  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request);
  absl::StatusOr<v1::ExportSceneResponse> ExportScene(const v1::ExportSceneRequest& request);
  // A contact sheet; the client must outlive it.
  std::unique_ptr<ContactSheetCall> ComposeContactSheet(const v1::ContactSheetOptions& options);

 private:
  friend class ContactSheetCall;
  explicit RendererClient(std::string address) : address_(std::move(address)) {}
  absl::Status Explain(const absl::Status& status) const;
  using Stub = v1::RendererService::StubInterface;
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                               const Request& request);

  const std::string address_;
  std::unique_ptr<runtime::InProcessServer> server_;
  std::unique_ptr<v1::RendererService::Stub> stub_;
};

// One contact sheet: tiles one by one, then the answer.
class ContactSheetCall {
 public:
  ContactSheetCall(RendererClient& client, const v1::ContactSheetOptions& options);
  // False when the renderer wants no more; Finish says why.
  bool Add(v1::ContactSheetTile tile);
  absl::StatusOr<v1::ComposeContactSheetResponse> Finish();

 private:
  RendererClient& client_;
  grpc::ClientContext context_;
  v1::ComposeContactSheetResponse response_;
  std::unique_ptr<grpc::ClientWriterInterface<v1::ComposeContactSheetRequest>> writer_;
};

// Single stages, each run from its input artifact: in this process, or at an address.

// `address` empty: a worker in this process.
absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address);
// The catalogue of that worker; of ours without asking.
absl::StatusOr<v1::ConstraintCatalog> CallListConstraintTypes(const std::string& address);
absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address);

}  // namespace flair::cli
