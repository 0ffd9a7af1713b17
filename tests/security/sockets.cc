// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/security/sockets.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

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

}  // namespace flair::testing
