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

}  // namespace
}  // namespace flair::runtime
