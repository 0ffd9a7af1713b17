// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/read_pacer.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <string>
#include <utility>

#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

TEST(ReadPause, IsHalfOfTheTimeSoFarThenATwentieth) {
  EXPECT_EQ(ReadPause(absl::ZeroDuration()), absl::Milliseconds(32));
  EXPECT_EQ(ReadPause(absl::Milliseconds(90)), absl::Milliseconds(45));
  EXPECT_EQ(ReadPause(absl::Seconds(1)), absl::Milliseconds(250));
  EXPECT_EQ(ReadPause(absl::Seconds(5)), absl::Milliseconds(250));
  EXPECT_EQ(ReadPause(absl::Seconds(20)), absl::Seconds(1));
  EXPECT_EQ(ReadPause(absl::Hours(1)), absl::Seconds(2));
}

// Counted as the client would: a read, then the next as soon as allowed.
int ReadCount(absl::Duration first, absl::Duration last) {
  int read_count = 0;
  for (absl::Duration now = first; now < last; now += ReadPause(now)) ++read_count;
  return read_count;
}

TEST(ReadPause, FewReadsAreEnoughForALongAnswer) {
  EXPECT_LE(ReadCount(absl::Milliseconds(1), absl::Seconds(1)), 10);
  EXPECT_LE(ReadCount(absl::Milliseconds(500), absl::Seconds(20)), 55);
}

TEST(PauseEnd, IsUpToAnEighthEarlier) {
  for (const int milliseconds : {1, 8, 32, 45, 250, 1999}) {
    const absl::Duration pause = absl::Milliseconds(milliseconds);
    for (int i = 0; i < 1000; ++i) {
      const absl::Duration now = absl::Seconds(1000) + i * absl::Microseconds(1370);
      const absl::Duration rest = PauseEnd(now, pause) - now;
      ASSERT_LE(rest, pause);
      ASSERT_GE(rest, std::min(pause * 7 / 8, pause - absl::Milliseconds(1))) << milliseconds << " ms at " << now;
    }
  }
}

TEST(PauseEnd, PausesOfManySocketsEndTogether) {
  std::set<absl::Duration> ends;
  for (int i = 0; i < 500; ++i)
    ends.insert(PauseEnd(absl::Seconds(9) + i * absl::Milliseconds(1), ReadPause(absl::Seconds(9))));
  // Half a second of beginnings, ends every 32 ms.
  EXPECT_LE(ends.size(), 34u);
}

// A pair of sockets, one of them read by a pacer in pieces of up to 16 KiB until a piece ends in '.'.
class PacedSocket {
 public:
  explicit PacedSocket(ReadPacer::PauseRule pause, bool brings_answer = true)
      : brings_answer_(brings_answer),
        pacer_(
            loop_, [this](int fd) { return Read(fd); }, std::move(pause)) {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, fds_), 0);
  }
  ~PacedSocket() {
    loop_.Stop();
    close(fds_[0]);
    close(fds_[1]);
  }

  void Watch(bool readable, bool writable) {
    loop_.Post([this, readable, writable] { pacer_.Watch(fds_[0], readable, writable); });
  }
  void Send(const std::string& bytes) {
    ASSERT_EQ(write(fds_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void ReadResting() {
    loop_.Post([this] { pacer_.ReadResting(); });
  }
  // Until the loop has looked at its sockets once more.
  void WaitForLoop() {
    for (int i = 0; i < 3; ++i) {
      runtime::TestGate came;
      loop_.Post([&] { came.Open(); });
      came.Wait();
    }
  }
  // What came, after the end came.
  std::string WaitForAll() {
    all_read_.Wait();
    return received_;
  }
  void WaitForFirst() { first_read_.Wait(); }
  int read_count() const { return read_count_; }

 private:
  int64_t Read(int fd) {
    std::string bytes(16384, ' ');
    const ssize_t size = read(fd, bytes.data(), bytes.size());
    if (size <= 0) return 0;
    ++read_count_;
    received_ += bytes.substr(0, static_cast<size_t>(size));
    if (received_.ends_with('.')) {
      pacer_.Watch(fd, false, false);
      all_read_.Open();
    }
    first_read_.Open();
    return brings_answer_ ? size : 0;
  }

  const bool brings_answer_;
  std::string received_;
  std::atomic<int> read_count_ = 0;
  runtime::TestGate first_read_;
  runtime::TestGate all_read_;
  int fds_[2] = {-1, -1};
  EventLoop loop_{[this](int fd, bool readable, bool) {
    if (readable) pacer_.OnReadable(fd);
  }};
  ReadPacer pacer_;
};

absl::Duration Short(absl::Duration) { return absl::Milliseconds(1); }
// No test lives to see its end.
absl::Duration Endless(absl::Duration) { return absl::Hours(10); }

TEST(ReadPacer, ASocketIsReadToItsEndInSpiteOfThePauses) {
  PacedSocket socket(Short);
  socket.Watch(true, false);
  std::string sent;
  for (int i = 0; i < 60; ++i) {
    const std::string piece = i == 59 ? "." : "piece ";
    sent += piece;
    socket.Send(piece);
    // The others come in a pause, or after one.
    if (i == 0) socket.WaitForFirst();
    socket.WaitForLoop();
  }
  EXPECT_EQ(socket.WaitForAll(), sent);
}

TEST(ReadPacer, TheFirstPieceIsReadAtOnceAndTheNextAfterAPauseThatWritingEnds) {
  PacedSocket socket(Endless);
  socket.Watch(true, false);
  socket.Send("one");
  socket.WaitForFirst();
  socket.Send("two.");
  socket.WaitForLoop();
  EXPECT_EQ(socket.read_count(), 1);
  socket.Watch(true, true);
  EXPECT_EQ(socket.WaitForAll(), "onetwo.");
}

TEST(ReadPacer, ASocketThatRestsIsReadWhenItIsAskedFor) {
  PacedSocket socket(Endless);
  socket.Watch(true, false);
  socket.Send("one");
  socket.WaitForFirst();
  socket.Send("two.");
  socket.ReadResting();
  EXPECT_EQ(socket.WaitForAll(), "onetwo.");
}

TEST(ReadPacer, WhatLiesReadyIsNotWaitedFor) {
  PacedSocket socket(Endless);
  const std::string sent = std::string(100000, 'x') + ".";
  socket.Send(sent);
  socket.Watch(true, false);
  EXPECT_EQ(socket.WaitForAll(), sent);
}

TEST(ReadPacer, WhatIsNoAnswerIsNotFollowedByAPause) {
  PacedSocket socket(Endless, false);
  socket.Watch(true, false);
  socket.Send("hand");
  socket.WaitForFirst();
  socket.Send("shake.");
  EXPECT_EQ(socket.WaitForAll(), "handshake.");
}

}  // namespace
}  // namespace flair::llm
