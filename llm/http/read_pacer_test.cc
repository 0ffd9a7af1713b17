// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/read_pacer.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "worker_runtime/executor/test_gate.h"

namespace flair::llm {
namespace {

TEST(ReadPause, IsATwentiethOfTheTimeSoFar) {
  EXPECT_EQ(ReadPause(absl::ZeroDuration()), absl::ZeroDuration());
  EXPECT_EQ(ReadPause(absl::Milliseconds(19)), absl::ZeroDuration());
  EXPECT_EQ(ReadPause(absl::Milliseconds(20)), absl::Milliseconds(1));
  EXPECT_EQ(ReadPause(absl::Seconds(2)), absl::Milliseconds(100));
  EXPECT_EQ(ReadPause(absl::Hours(1)), absl::Milliseconds(250));
}

// Counted as the client would: a read, then the next as soon as allowed.
TEST(ReadPause, AHundredReadsAreEnoughForALongAnswer) {
  int read_count = 0;
  for (absl::Duration now = absl::Milliseconds(500); now < absl::Seconds(20); ++read_count) {
    now += std::max(ReadPause(now), absl::Milliseconds(5));
  }
  EXPECT_LT(read_count, 120);
}

TEST(ReadPacer, ASocketIsReadToItsEndInSpiteOfThePauses) {
  int fds[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, fds), 0);
  std::string received;
  runtime::TestGate all_read;
  ReadPacer* pacer = nullptr;
  EventLoop loop([&](int fd, bool readable, bool) {
    char byte = 0;
    ASSERT_TRUE(readable);
    ASSERT_EQ(read(fd, &byte, 1), 1);
    received += byte;
    if (received.size() == 60) {
      pacer->Watch(fd, false, false);
      all_read.Open();
    } else {
      pacer->OnRead(fd);
    }
  });
  ReadPacer the_pacer(loop);
  pacer = &the_pacer;
  loop.Post([&] { pacer->Watch(fds[0], true, false); });
  const std::string sent(60, 'x');
  ASSERT_EQ(write(fds[1], sent.data(), sent.size()), 60);
  all_read.Wait();
  EXPECT_EQ(received, sent);
  loop.Stop();
  close(fds[0]);
  close(fds[1]);
}

}  // namespace
}  // namespace flair::llm
