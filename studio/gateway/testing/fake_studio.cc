// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/testing/fake_studio.h"

#include <grpcpp/server_builder.h>

#include <algorithm>
#include <chrono>
#include <deque>

namespace flair::studio::testing {
namespace {

constexpr int kTitleLength = 1000;

grpc::ServerUnaryReactor* Finished(grpc::CallbackServerContext* context, const grpc::Status& status) {
  grpc::ServerUnaryReactor* const reactor = context->DefaultReactor();
  reactor->Finish(status);
  return reactor;
}

}  // namespace

class FakeStudio::Waiting final : public grpc::ServerUnaryReactor {
 public:
  explicit Waiting(FakeStudio& studio) : studio_(studio) {
    const std::lock_guard lock(studio_.mutex_);
    studio_.waiting_.push_back(this);
    ++studio_.waiting_count_;
    studio_.changed_.notify_all();
  }
  void OnCancel() override {
    const std::lock_guard lock(studio_.mutex_);
    ++studio_.cancelled_count_;
    studio_.changed_.notify_all();
    if (std::erase(studio_.waiting_, this) > 0) Finish(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

 private:
  FakeStudio& studio_;
};

// Its messages wait for each other.
class FakeStudio::Stream final : public grpc::ServerWriteReactor<v1::WatchDocumentsResponse> {
 public:
  explicit Stream(FakeStudio& studio) : studio_(studio) {
    const std::lock_guard lock(studio_.mutex_);
    studio_.streams_.push_back(this);
    ++studio_.waiting_count_;
    studio_.changed_.notify_all();
  }
  // With the studio locked.
  void Say(const std::string& id) {
    queue_.emplace_back().set_deleted_document_id(id);
    if (queue_.size() == 1) StartWrite(&queue_.front());
  }
  void End(const grpc::Status& status) {
    end_ = std::make_unique<grpc::Status>(status);
    if (queue_.empty()) Finish(*end_);
  }
  void OnWriteDone(bool ok) override {
    const std::lock_guard lock(studio_.mutex_);
    queue_.pop_front();
    if (!ok) queue_.clear();
    if (!queue_.empty()) return StartWrite(&queue_.front());
    if (end_ != nullptr) Finish(*end_);
  }
  void OnCancel() override {
    const std::lock_guard lock(studio_.mutex_);
    ++studio_.cancelled_count_;
    studio_.changed_.notify_all();
    if (std::erase(studio_.streams_, this) > 0) End(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

 private:
  FakeStudio& studio_;
  std::deque<v1::WatchDocumentsResponse> queue_;
  std::unique_ptr<grpc::Status> end_;
};

FakeStudio::FakeStudio() {
  grpc::ServerBuilder builder;
  builder.SetMaxReceiveMessageSize(64 << 20);
  builder.RegisterService(this);
  server_ = builder.BuildAndStart();
}

FakeStudio::~FakeStudio() {
  AnswerWaiting();
  EndStreams(grpc::Status::OK);
  server_->Shutdown();
}

grpc::ServerUnaryReactor* FakeStudio::GetDocument(grpc::CallbackServerContext* context,
                                                  const v1::GetDocumentRequest* request,
                                                  v1::GetDocumentResponse* response) {
  const std::string& id = request->document_id();
  if (id == "wait") return new Waiting(*this);
  if (id.starts_with("error/")) {
    return Finished(context, {static_cast<grpc::StatusCode>(std::stoi(id.substr(6))), "words of " + id});
  }
  response->mutable_document()->set_id(id);
  response->mutable_document()->set_title(id);
  if (id == "deadline") {
    const auto left = context->deadline() - std::chrono::system_clock::now();
    response->mutable_document()->set_revision(std::chrono::duration_cast<std::chrono::milliseconds>(left).count());
  }
  return Finished(context, grpc::Status::OK);
}

grpc::ServerUnaryReactor* FakeStudio::ListDocuments(grpc::CallbackServerContext* context,
                                                    const v1::ListDocumentsRequest* request,
                                                    v1::ListDocumentsResponse* response) {
  for (int i = 0; i < request->page_size(); ++i) response->add_documents()->set_title(std::string(kTitleLength, 'a'));
  return Finished(context, grpc::Status::OK);
}

grpc::ServerUnaryReactor* FakeStudio::CreateDocument(grpc::CallbackServerContext* context,
                                                     const v1::CreateDocumentRequest* request,
                                                     v1::CreateDocumentResponse* response) {
  response->mutable_document()->set_title(std::to_string(request->file().size()));
  return Finished(context, grpc::Status::OK);
}

grpc::ServerWriteReactor<v1::WatchDocumentsResponse>* FakeStudio::WatchDocuments(grpc::CallbackServerContext*,
                                                                                 const v1::WatchDocumentsRequest*) {
  return new Stream(*this);
}

void FakeStudio::Await(const int& counter, int count) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return counter >= count; });
}

void FakeStudio::AwaitWaiting(int count) { Await(waiting_count_, count); }

void FakeStudio::AwaitCancelled(int count) { Await(cancelled_count_, count); }

void FakeStudio::AnswerWaiting() {
  const std::lock_guard lock(mutex_);
  for (Waiting* waiting : waiting_) waiting->Finish(grpc::Status::OK);
  waiting_.clear();
}

void FakeStudio::Say(const std::string& deleted_document_id) {
  const std::lock_guard lock(mutex_);
  for (Stream* stream : streams_) stream->Say(deleted_document_id);
}

void FakeStudio::EndStreams(const grpc::Status& status) {
  const std::lock_guard lock(mutex_);
  for (Stream* stream : streams_) stream->End(status);
  streams_.clear();
}

}  // namespace flair::studio::testing
