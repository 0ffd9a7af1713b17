// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/listener.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <unistd.h>

#include <vector>

namespace flair::runtime {
namespace {

sockaddr_storage Four(const char* address) {
  sockaddr_storage peer = {};
  auto& four = reinterpret_cast<sockaddr_in&>(peer);
  four.sin_family = AF_INET;
  inet_pton(AF_INET, address, &four.sin_addr);
  return peer;
}

sockaddr_storage Six(const char* address) {
  sockaddr_storage peer = {};
  auto& six = reinterpret_cast<sockaddr_in6&>(peer);
  six.sin6_family = AF_INET6;
  inet_pton(AF_INET6, address, &six.sin6_addr);
  return peer;
}

class Gate : public ::testing::Test {
 protected:
  ~Gate() override {
    for (const int file : files_) ::close(file);
  }
  // Admits connections of a peer until one is refused; how many there were.
  int Fill(const sockaddr_storage& peer) {
    for (int count = 0;; ++count) {
      const int file = ::socket(AF_INET, SOCK_STREAM, 0);
      if (!gate_.Admit(file, peer, now_)) {
        ::close(file);
        return count;
      }
      files_.push_back(file);
    }
  }

  ConnectionGate gate_{256};
  absl::Duration now_ = absl::Seconds(1);
  std::vector<int> files_;
};

TEST_F(Gate, NoAddressTakesThePlacesOfAllOthers) {
  EXPECT_EQ(Fill(Four("10.0.0.1")), gate_.peer_limit());
  EXPECT_GT(Fill(Four("10.0.0.2")), 10);
}

TEST_F(Gate, SomeFilesAreKeptForOtherThings) {
  int connections = 0;
  for (const char* peer : {"10.0.0.1", "10.0.0.2", "10.0.0.3", "10.0.0.4"}) connections += Fill(Four(peer));
  EXPECT_LE(connections, 256 - 256 / 8);
  EXPECT_EQ(Fill(Four("10.0.0.5")), 0);
}

TEST_F(Gate, PlacesOfClosedConnectionsAreFreeAgainAfterAMoment) {
  ASSERT_EQ(Fill(Four("10.0.0.1")), gate_.peer_limit());
  for (int i = 0; i < 5; ++i) {
    ::close(files_.back());
    files_.pop_back();
  }
  // Somebody else's file has a number now that was a connection's.
  const int other = ::socket(AF_INET, SOCK_STREAM, 0);
  now_ += absl::Seconds(1);
  EXPECT_EQ(Fill(Four("10.0.0.1")), 5);
  ::close(other);
}

TEST_F(Gate, ANetworkOfIPv6IsOneAddress) {
  EXPECT_EQ(Fill(Six("2001:db8:1:2::1")), gate_.peer_limit());
  EXPECT_EQ(Fill(Six("2001:db8:1:2::ffff")), 0);
  EXPECT_GT(Fill(Six("2001:db8:1:3::1")), 10);
}

TEST_F(Gate, AnIPv4AddressIsTheSameInIPv6) {
  EXPECT_EQ(Fill(Six("::ffff:10.0.0.1")), gate_.peer_limit());
  EXPECT_EQ(Fill(Four("10.0.0.1")), 0);
}

// A connection over loopback, admitted to a gate.
class Talk {
 public:
  explicit Talk(ConnectionGate& gate) {
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_storage address = Four("127.0.0.1");
    socklen_t size = sizeof(sockaddr_in);
    auto* where = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(listener, where, size), 0);
    EXPECT_EQ(::listen(listener, 1), 0);
    ::getsockname(listener, where, &size);
    caller_ = ::socket(AF_INET, SOCK_STREAM, 0);
    EXPECT_EQ(::connect(caller_, where, size), 0);
    server_ = ::accept(listener, nullptr, nullptr);
    ::close(listener);
    EXPECT_TRUE(gate.Admit(server_, address, absl::ZeroDuration()));
  }
  ~Talk() {
    ::close(caller_);
    ::close(server_);
  }
  // The server takes all of it.
  void Send(size_t bytes) {
    for (std::string piece(1 << 16, 'a'); bytes > 0; bytes -= piece.size()) {
      piece.resize(std::min(bytes, piece.size()));
      ASSERT_EQ(::send(caller_, piece.data(), piece.size(), MSG_NOSIGNAL), static_cast<ssize_t>(piece.size()));
      ASSERT_EQ(::recv(server_, piece.data(), piece.size(), MSG_WAITALL), static_cast<ssize_t>(piece.size()));
    }
  }
  void Answer() {
    char byte = 'a';
    ASSERT_EQ(::send(server_, &byte, 1, MSG_NOSIGNAL), 1);
    ASSERT_EQ(::recv(caller_, &byte, 1, 0), 1);
  }
  bool is_open() const {
    char byte = 0;
    return ::recv(caller_, &byte, 1, MSG_DONTWAIT) < 0;
  }

 private:
  int caller_ = -1;
  int server_ = -1;
};

TEST(ConnectionGate, WhoIsNotAnsweredForAMinuteGoes) {
  ConnectionGate gate(256);
  Talk endless(gate), answered(gate), silent(gate);
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(endless.is_open());
    gate.Look(absl::Seconds(21 * i));
    endless.Send(1);
    answered.Send(1);
    answered.Answer();
  }
  gate.Look(absl::Seconds(84));
  EXPECT_FALSE(endless.is_open());
  EXPECT_TRUE(answered.is_open());
  EXPECT_TRUE(silent.is_open());
}

TEST(ConnectionGate, WhoIsNotAnsweredForASecondGoes) {
  ConnectionGate gate(256);
  Talk endless(gate), answered(gate), frozen(gate);
  frozen.Send(100'000);
  for (int i = 0; i < 11; ++i) {
    EXPECT_TRUE(endless.is_open()) << i;
    endless.Send(10'000);
    answered.Send(10'000);
    gate.Look(absl::Seconds(1) + i * absl::Milliseconds(100));
    if (i % 8 == 0) answered.Answer();
  }
  gate.Look(absl::Seconds(60));
  EXPECT_FALSE(endless.is_open());
  EXPECT_TRUE(answered.is_open());
  EXPECT_TRUE(frozen.is_open());
}

TEST(ConnectionGate, WhatIsNotAnsweredDoesNotPileUp) {
  ConnectionGate gate(256);
  Talk large(gate), middling(gate), small(gate);
  large.Send(20 << 20);
  middling.Send(8 << 20);
  small.Send(100);
  gate.Look(absl::Seconds(1));
  EXPECT_TRUE(large.is_open());
  middling.Send(8 << 20);
  gate.Look(absl::Seconds(2));
  EXPECT_FALSE(large.is_open());
  EXPECT_TRUE(middling.is_open());
  EXPECT_TRUE(small.is_open());
}

}  // namespace
}  // namespace flair::runtime
