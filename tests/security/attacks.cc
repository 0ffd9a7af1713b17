// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/security/attacks.h"

#include <arpa/inet.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::testing {
namespace {

sockaddr_in AddressOf(const std::string& host, int port) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  inet_pton(AF_INET, host.c_str(), &address.sin_addr);
  return address;
}

// Reads what is there; whether the other side has closed.
bool HasClosed(int file) {
  std::array<char, 4096> buffer;
  while (true) {
    const ssize_t count = ::recv(file, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0) continue;
    return count == 0 || (errno != EAGAIN && errno != EINTR);
  }
}

bool SendTo(int file, const std::string& bytes) {
  return ::send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) == static_cast<ssize_t>(bytes.size());
}

constexpr int kMostConnections = 10000;
// For everything else that this process has open.
constexpr int kOtherFiles = 500;
constexpr int kSlowCallers = 200;
constexpr size_t kLargeMib = 64;

std::string SourceOf(int caller) { return caller % 2 == 0 ? "127.0.0.2" : "127.0.0.3"; }

}  // namespace

Sockets::~Sockets() {
  for (const int file : files_) ::close(file);
}

bool Sockets::Connect(const std::string& address, const std::string& source) {
  const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (file < 0) return false;
  const size_t colon = address.rfind(':');
  const sockaddr_in from = AddressOf(source, 0);
  const sockaddr_in to = AddressOf(address.substr(0, colon), std::stoi(address.substr(colon + 1)));
  const int yes = 1;
  // Otherwise the kernel looks for a port that nobody has at all.
  ::setsockopt(file, IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &yes, sizeof yes);
  if (::bind(file, reinterpret_cast<const sockaddr*>(&from), sizeof from) != 0 ||
      ::connect(file, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) {
    ::close(file);
    return false;
  }
  files_.push_back(file);
  return true;
}

bool Sockets::SendToLast(const std::string& bytes) { return !files_.empty() && SendTo(files_.back(), bytes); }

bool Sockets::SendAllToLast(const std::string& bytes) {
  const timeval limit = {.tv_sec = 5, .tv_usec = 0};
  ::setsockopt(files_.back(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
  return ::send(files_.back(), bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

int Sockets::SendToAll(const std::string& bytes) {
  int sent = 0;
  for (const int file : files_) sent += SendTo(file, bytes) ? 1 : 0;
  return sent;
}

int Sockets::CountOpen() {
  int open = 0;
  for (const int file : files_) open += HasClosed(file) ? 0 : 1;
  return open;
}

int Sockets::WaitForClose(int seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  for (const int file : files_) {
    while (!HasClosed(file)) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      pollfd polled = {file, POLLIN, 0};
      if (left.count() <= 0 || ::poll(&polled, 1, static_cast<int>(left.count())) == 0) return CountOpen();
    }
  }
  return 0;
}

int RaiseFileLimit() {
  rlimit limit = {};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
  ::getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 1 << 20));
}

const std::string kPreface = std::string("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n") + std::string("\0\0\0\4\0\0\0\0\0", 9);
const std::string kEndlessHeaders = std::string("\0\0\1\1\0\0\0\0\1\x82", 10);
const std::string kMoreHeaders = std::string("\0\0\1\x09\0\0\0\0\1\x82", 10);

grpc::Status SendMessage(const std::string& address, const std::string& method, size_t mib, const std::string& unit,
                         const std::string& token) {
  const auto channel =
      runtime::MakeChannel(address, "", {.max_message_mib = static_cast<int>(mib) + 1, .token = token});
  if (!channel.ok()) return runtime::ToGrpcStatus(channel.status());
  grpc::GenericStub stub(*channel);
  // One piece of memory, many times.
  std::string bytes;
  while (bytes.size() + unit.size() <= 1 << 20) bytes += unit;
  const grpc::Slice piece(bytes);
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
