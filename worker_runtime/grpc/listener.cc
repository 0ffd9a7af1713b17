// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/listener.h"

#include <fmt/format.h>
// Not <netinet/tcp.h>, whose tcp_info counts no bytes.
#include <linux/tcp.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

constexpr size_t kNetworkBytes = 8;
// What is taken between two looks comes on top of kUnansweredBytes. Measuring one connection takes a microsecond.
constexpr absl::Duration kMeasureEvery = absl::Milliseconds(5);
constexpr absl::Duration kMeasureOne = absl::Microseconds(10);
constexpr int64_t kUnansweredBytes = 32 << 20;
// gRPC copies all of a header that is not whole whenever it takes more of it, and does nothing else meanwhile. Longer
// than a message is ever on its way without leave to send more, which takes no longer than a packet there and back.
constexpr absl::Duration kUnansweredFor = absl::Seconds(1);
constexpr int kUnansweredLooks = 4;
constexpr int64_t kUnansweredOfOne = 64 << 10;
constexpr absl::Duration kUnansweredAtAll = absl::Minutes(1);

// Unique among all sockets of the machine's life; 0 when `file` is no socket any more.
uint64_t CookieOf(int file) {
  uint64_t cookie = 0;
  socklen_t size = sizeof cookie;
  return ::getsockopt(file, SOL_SOCKET, SO_COOKIE, &cookie, &size) == 0 ? cookie : 0;
}

std::string KeyOf(const sockaddr_storage& peer) {
  if (peer.ss_family == AF_INET) {
    const auto& address = reinterpret_cast<const sockaddr_in&>(peer).sin_addr;
    return std::string(reinterpret_cast<const char*>(&address), sizeof address);
  }
  if (peer.ss_family == AF_INET6) {
    const auto& address = reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr;
    if (IN6_IS_ADDR_V4MAPPED(&address)) return std::string(reinterpret_cast<const char*>(&address) + 12, 4);
    return std::string(reinterpret_cast<const char*>(&address), kNetworkBytes);
  }
  return "";
}

constexpr int kBacklog = 4096;
constexpr int kAcceptedAtOnce = 256;
constexpr rlim_t kMostFiles = 65536;
// Of these for the gate: what more connections need, some 25 KiB each, would be missing to messages (LimitCallers).
constexpr int kMostConnections = 4096;
// How long to leave the others waiting when there are no files left.
constexpr int kOutOfFilesMs = 50;

// Allows the process as many files as it may have, and says how many of these the gate is to know of.
int RaiseFileLimit() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return 1024;
  const rlim_t wanted = std::min(limit.rlim_max, kMostFiles);
  if (limit.rlim_cur < wanted) {
    limit.rlim_cur = wanted;
    ::setrlimit(RLIMIT_NOFILE, &limit);
    ::getrlimit(RLIMIT_NOFILE, &limit);
  }
  return static_cast<int>(std::min<rlim_t>(limit.rlim_cur, kMostConnections));
}

// A listening socket, or -1 with errno.
int ListenOn(const sockaddr* address, socklen_t size) {
  const int file = ::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (file < 0) return -1;
  const int yes = 1;
  const int no = 0;
  ::setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  // "[::]" is every address, of IPv4 too.
  if (address->sa_family == AF_INET6) ::setsockopt(file, IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof no);
  if (::bind(file, address, size) == 0 && ::listen(file, kBacklog) == 0) return file;
  const int error = errno;
  ::close(file);
  errno = error;
  return -1;
}

in_port_t& PortIn(sockaddr* address) {
  return address->sa_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(address)->sin6_port
                                        : reinterpret_cast<sockaddr_in*>(address)->sin_port;
}

// Listens at all addresses of a name, at one port: that of the first where it is free to choose.
std::vector<int> ListenOnAll(addrinfo* first, in_port_t& port) {
  std::vector<int> files;
  for (addrinfo* one = first; one != nullptr; one = one->ai_next) {
    if (one->ai_family != AF_INET && one->ai_family != AF_INET6) continue;
    PortIn(one->ai_addr) = port;
    const int file = ListenOn(one->ai_addr, one->ai_addrlen);
    if (file < 0) continue;
    files.push_back(file);
    sockaddr_storage bound = {};
    socklen_t size = sizeof bound;
    ::getsockname(file, reinterpret_cast<sockaddr*>(&bound), &size);
    port = PortIn(reinterpret_cast<sockaddr*>(&bound));
  }
  return files;
}

}  // namespace

ConnectionGate::ConnectionGate(int file_limit)
    : file_limit_(file_limit - file_limit / 8),
      peer_limit_((file_limit_ + 3) / 4),
      activity_(::epoll_create1(EPOLL_CLOEXEC)) {}

ConnectionGate::~ConnectionGate() { ::close(activity_); }

bool ConnectionGate::Admit(int file, const sockaddr_storage& peer, absl::Duration now) {
  // Whoever had that number has closed it. New files get the lowest free number, so it says how many are open.
  Forget(file);
  if (file >= file_limit_) return false;
  const std::string key = KeyOf(peer);
  if (static_cast<int>(files_of_peers_[key].size()) >= peer_limit_) Look(now);
  std::unordered_set<int>& files = files_of_peers_[key];
  if (static_cast<int>(files.size()) >= peer_limit_) return false;
  files.insert(file);
  connections_[file] = {CookieOf(file), key};
  epoll_event event = {.events = EPOLLIN | EPOLLET, .data = {.fd = file}};
  ::epoll_ctl(activity_, EPOLL_CTL_ADD, file, &event);
  return true;
}

void ConnectionGate::Forget(int file) {
  const auto connection = connections_.find(file);
  if (connection == connections_.end()) return;
  const auto files = files_of_peers_.find(connection->second.peer);
  files->second.erase(file);
  if (files->second.empty()) files_of_peers_.erase(files);
  connections_.erase(connection);
}

bool ConnectionGate::Connection::Measure(int file, absl::Duration now) {
  tcp_info info = {};
  socklen_t size = sizeof info;
  int unread = 0;
  if (ended || ::ioctl(file, FIONREAD, &unread) != 0 || ::getsockopt(file, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) {
    return false;
  }
  const int64_t before = std::exchange(taken, static_cast<int64_t>(info.tcpi_bytes_received) - unread);
  if (before == answered) answered_at = now;
  if (info.tcpi_bytes_sent != std::exchange(sent, info.tcpi_bytes_sent)) {
    answered = taken;
    unanswered_looks = 0;
  }
  if (taken > before) ++unanswered_looks;
  return taken > before;
}

void ConnectionGate::Connection::End(int file) {
  ::shutdown(file, SHUT_RDWR);
  ended = true;
  answered = taken;
}

absl::Duration ConnectionGate::Look(absl::Duration now) {
  const absl::Duration rest = std::max(kMeasureEvery, kMeasureOne * static_cast<int64_t>(connections_.size()));
  if (now - looked_at_ < rest) return rest;
  looked_at_ = now;
  std::array<epoll_event, 256> seen;
  (void)::epoll_wait(activity_, seen.data(), seen.size(), 0);
  bool active = false;
  std::vector<int> gone;
  std::vector<std::pair<int64_t, int>> unanswered;
  int64_t all_unanswered = 0;
  for (auto& [file, connection] : connections_) {
    if (CookieOf(file) != connection.cookie) {
      gone.push_back(file);
      continue;
    }
    active |= connection.Measure(file, now);
    const int64_t bytes = connection.taken - connection.answered;
    const absl::Duration limit = bytes > kUnansweredOfOne ? kUnansweredFor : kUnansweredAtAll;
    if (connection.unanswered_looks >= kUnansweredLooks && now - connection.answered_at >= limit) connection.End(file);
    unanswered.emplace_back(connection.taken - connection.answered, file);
    all_unanswered += connection.taken - connection.answered;
  }
  std::ranges::sort(unanswered, std::greater());
  for (auto largest = unanswered.begin(); all_unanswered > kUnansweredBytes; ++largest) {
    connections_[largest->second].End(largest->second);
    all_unanswered -= largest->first;
  }
  for (const int file : gone) Forget(file);
  return active ? rest : absl::ZeroDuration();
}

absl::StatusOr<std::unique_ptr<Listener>> Listener::Bind(const std::string& address) {
  const size_t colon = address.rfind(':');
  const std::string shown_host = address.substr(0, colon);
  std::string host = shown_host;
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  addrinfo hints = {};
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  in_port_t port = htons(static_cast<in_port_t>(std::atoi(address.c_str() + colon + 1)));
  std::vector<int> files;
  if (::getaddrinfo(host.c_str(), nullptr, &hints, &found) == 0) {
    files = ListenOnAll(found, port);
    ::freeaddrinfo(found);
  }
  if (files.empty()) {
    return Unavailable("cannot listen on {}: the address is in use, not of this machine, or not permitted", address);
  }
  const int wake = ::eventfd(0, EFD_CLOEXEC);
  return std::unique_ptr<Listener>(
      new Listener(fmt::format("{}:{}", shown_host, ntohs(port)), std::move(files), wake, RaiseFileLimit()));
}

Listener::~Listener() {
  Stop();
  for (const int file : files_) ::close(file);
  ::close(wake_);
}

void Listener::Start(std::function<void(int, int)> take) {
  thread_ = std::thread([this, take = std::move(take)] { Run(take); });
  watch_ = std::thread([this] { Watch(); });
}

void Listener::Stop() {
  if (!thread_.joinable()) return;
  const uint64_t one = 1;
  while (::write(wake_, &one, sizeof one) < 0 && errno == EINTR) {
  }
  thread_.join();
  watch_.join();
  // What waits to be accepted is refused at once, and another program may have the port.
  for (const int file : files_) ::shutdown(file, SHUT_RDWR);
}

// Not on the thread that accepts: gRPC reads a new connection on that one, for as long as there is something to read.
void Listener::Watch() {
  pollfd polled[] = {{wake_, POLLIN, 0}, {-1, POLLIN, 0}};
  while (polled[0].revents == 0) {
    std::unique_lock lock(mutex_);
    const absl::Duration rest = gate_.Look(SystemClock().Elapsed());
    lock.unlock();
    const bool rests = rest > absl::ZeroDuration();
    polled[1].fd = rests ? -1 : gate_.activity();
    ::poll(polled, 2, rests ? static_cast<int>(absl::ToInt64Milliseconds(rest)) : -1);
  }
}

void Listener::Run(const std::function<void(int, int)>& take) {
  std::vector<pollfd> polled = {{wake_, POLLIN, 0}};
  for (const int file : files_) polled.push_back({file, POLLIN, 0});
  bool out_of_files = false;
  while (true) {
    // Without files, the waiting ones are left alone for a moment: only the wake is looked at.
    if (::poll(polled.data(), out_of_files ? 1 : polled.size(), out_of_files ? kOutOfFilesMs : -1) < 0) continue;
    if (polled[0].revents != 0) return;
    const bool all = out_of_files;
    out_of_files = false;
    for (size_t i = 1; i < polled.size(); ++i) {
      if ((all || polled[i].revents != 0) && !AcceptAll(polled[i].fd, take)) out_of_files = true;
    }
  }
}

bool Listener::AcceptAll(int listener, const std::function<void(int, int)>& take) {
  // Not for ever, however many come: somebody may want to stop.
  for (int i = 0; i < kAcceptedAtOnce; ++i) {
    sockaddr_storage peer = {};
    socklen_t size = sizeof peer;
    const int connection = ::accept4(listener, reinterpret_cast<sockaddr*>(&peer), &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (connection < 0 && (errno == EINTR || errno == ECONNABORTED)) continue;
    if (connection < 0) return errno != EMFILE && errno != ENFILE && errno != ENOBUFS && errno != ENOMEM;
    std::unique_lock lock(mutex_);
    const bool admitted = gate_.Admit(connection, peer, SystemClock().Elapsed());
    lock.unlock();
    if (!admitted) {
      ::close(connection);
      continue;
    }
    const int yes = 1;
    ::setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    take(listener, connection);
  }
  return true;
}

}  // namespace flair::runtime
