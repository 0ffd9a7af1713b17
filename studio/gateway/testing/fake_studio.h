// SPDX-License-Identifier: GPL-3.0-or-later
// A StudioService that does as it is asked by the ids of documents, and one stream that the test speaks.
#pragma once

#include <grpcpp/server.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "flair/v1/studio_service.grpc.pb.h"

namespace flair::studio::testing {

inline constexpr char kService[] = "flair.v1.StudioService";
inline constexpr char kGetDocument[] = "/flair.v1.StudioService/GetDocument";
inline constexpr char kListDocuments[] = "/flair.v1.StudioService/ListDocuments";
inline constexpr char kCreateDocument[] = "/flair.v1.StudioService/CreateDocument";
inline constexpr char kWatchDocuments[] = "/flair.v1.StudioService/WatchDocuments";

class FakeStudio final : public v1::StudioService::CallbackService {
 public:
  FakeStudio();
  ~FakeStudio() override;

  std::shared_ptr<grpc::Channel> channel() { return server_->InProcessChannel({}); }

  // "error/5" fails with code 5; "wait" answers after Answer or Cancel, "deadline/ID" with the milliseconds that are
  // left; any other id is the title too.
  grpc::ServerUnaryReactor* GetDocument(grpc::CallbackServerContext* context, const v1::GetDocumentRequest* request,
                                        v1::GetDocumentResponse* response) override;
  // As many documents as the page has places, each with a long title.
  grpc::ServerUnaryReactor* ListDocuments(grpc::CallbackServerContext* context, const v1::ListDocumentsRequest* request,
                                          v1::ListDocumentsResponse* response) override;
  // A document whose title is the size of the file.
  grpc::ServerUnaryReactor* CreateDocument(grpc::CallbackServerContext* context,
                                           const v1::CreateDocumentRequest* request,
                                           v1::CreateDocumentResponse* response) override;
  grpc::ServerWriteReactor<v1::WatchDocumentsResponse>* WatchDocuments(
      grpc::CallbackServerContext* context, const v1::WatchDocumentsRequest* request) override;

  // Wait until so many calls have come to wait, streams included, or were cancelled.
  void AwaitWaiting(int count);
  void AwaitCancelled(int count);
  // Answers all that wait.
  void AnswerWaiting();
  // Of all streams.
  void Say(const std::string& deleted_document_id);
  void EndStreams(const grpc::Status& status);

 private:
  class Waiting;
  class Stream;

  void Await(const int& counter, int count);

  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_count_ = 0;
  int cancelled_count_ = 0;
  std::vector<Waiting*> waiting_;
  std::vector<Stream*> streams_;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace flair::studio::testing
