// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/service/make_studio_service.h"

#include <deque>
#include <mutex>
#include <string>

#include "flair/v1/studio_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::studio {
namespace {

using runtime::CallContext;
using session::Documents;
using v1::WatchDocumentsResponse;

// What a watcher has not taken yet; one that is further behind is told so and may ask for the documents again.
constexpr size_t kMostPending = 1000;

// One call of WatchDocuments. Events come from whoever changes a document, writes from gRPC.
class WatchStream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, WatchDocumentsResponse> {
 public:
  WatchStream(session::DocumentEvents& events, const absl::Status& admitted) : events_(events) {
    if (!admitted.ok()) {
      End(admitted);
      return;
    }
    subscription_ = events_.Subscribe([this](const WatchDocumentsResponse& event) { Add(event); });
    StartRead(&request_);
  }

 private:
  void Add(const WatchDocumentsResponse& event) {
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    pending_.push_back(event);
    if (pending_.size() > kMostPending) return EndLocked(absl::ResourceExhaustedError("the watcher is too slow"));
    WriteNext();
  }
  void WriteNext() {
    if (writing_ || ended_ || pending_.empty()) return;
    response_ = std::move(pending_.front());
    pending_.pop_front();
    writing_ = true;
    StartWrite(&response_);
  }
  void OnWriteDone(bool ok) override {
    const std::lock_guard lock(mutex_);
    writing_ = false;
    if (!ok) return EndLocked(absl::CancelledError("the watcher is gone"));
    WriteNext();
  }
  void OnCancel() override { End(absl::CancelledError("the watcher is gone")); }
  void OnDone() override {
    if (subscription_ != 0) events_.Unsubscribe(subscription_);
    delete this;
  }
  void End(const absl::Status& status) {
    const std::lock_guard lock(mutex_);
    EndLocked(status);
  }
  void EndLocked(const absl::Status& status) {
    if (std::exchange(ended_, true)) return;
    Finish(runtime::ToGrpcStatus(status));
  }

  session::DocumentEvents& events_;
  int subscription_ = 0;
  grpc::ByteBuffer request_;  // says nothing
  std::mutex mutex_;
  std::deque<WatchDocumentsResponse> pending_;
  WatchDocumentsResponse response_;
  bool writing_ = false;
  bool ended_ = false;
};

class StudioService final : public runtime::Service {
 public:
  StudioService(Documents& documents, runtime::WorkerContext& worker)
      : Service(worker, v1::StudioService::service_full_name()) {
    Unary<v1::ListDocumentsRequest>("ListDocuments", [&documents](const v1::ListDocumentsRequest& request,
                                                                  CallContext&) { return documents.List(request); });
    Unary<v1::GetDocumentRequest>("GetDocument", [&documents](const v1::GetDocumentRequest& request, CallContext&) {
      return documents.Get(request);
    });
    Unary<v1::DeleteDocumentRequest>(
        "DeleteDocument",
        [&documents](const v1::DeleteDocumentRequest& request, CallContext&) { return documents.Delete(request); });
    Unary<v1::RestoreDocumentRequest>(
        "RestoreDocument",
        [&documents](const v1::RestoreDocumentRequest& request, CallContext&) { return documents.Restore(request); });
    Unary<v1::GetModelRequest>("GetModel", [&documents](const v1::GetModelRequest&, CallContext&) {
      return absl::StatusOr<v1::GetModelResponse>(documents.GetModel());
    });
    Unary<v1::ChooseModelRequest>("ChooseModel", [&documents](const v1::ChooseModelRequest& request, CallContext&) {
      return documents.ChooseModel(request);
    });
    Add<v1::CreateDocumentRequest>("CreateDocument", documents, &Documents::Create);
    Add<v1::ActRequest>("Act", documents, &Documents::Act);
    Add<v1::FindVariantsRequest>("FindVariants", documents, &Documents::FindVariants);
    Add<v1::JudgeRequest>("Judge", documents, &Documents::Judge);
    Add<v1::ExplainRequest>("Explain", documents, &Documents::Explain);
    Add<v1::DrawDocumentRequest>("DrawDocument", documents, &Documents::Draw);
    Add<v1::ExportDocumentRequest>("ExportDocument", documents, &Documents::Export);
    Add<v1::ShareDocumentRequest>("ShareDocument", documents, &Documents::Share);
    Add<v1::ListFurnitureRequest>("ListFurniture", documents, &Documents::ListFurniture);
    ServerStream<WatchDocumentsResponse>("WatchDocuments", [this, &documents](grpc::CallbackServerContext* context) {
      CallContext call;
      return new WatchStream(documents.events(), Admit(*context, call));
    });
  }

 private:
  template <typename Request, typename Response>
  void Add(const std::string& rpc, Documents& documents,
           absl::StatusOr<Response> (Documents::*method)(const Request&, CallContext&)) {
    Unary<Request>(rpc, [&documents, method](const Request& request, CallContext& call) {
      return (documents.*method)(request, call);
    });
  }
};

}  // namespace

std::unique_ptr<grpc::Service> MakeStudioService(session::Documents& documents, runtime::WorkerContext& worker) {
  return std::make_unique<StudioService>(documents, worker);
}

}  // namespace flair::studio
