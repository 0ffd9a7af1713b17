// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/stdio.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>
#include <vector>

#include "cli/output/output_folder.h"

namespace flair::cli::mcp {
namespace {

using ::testing::ElementsAre;

struct Pipe {
  Pipe() { EXPECT_EQ(::pipe(ends), 0); }
  ~Pipe() {
    CloseIn();
    CloseOut();
  }
  void CloseIn() { Close(ends[1]); }
  void CloseOut() { Close(ends[0]); }
  static void Close(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
  int out() const { return ends[0]; }
  int in() const { return ends[1]; }
  int ends[2];
};

class LinesTest : public ::testing::Test {
 protected:
  void Read(size_t most) {
    lines_.Read(
        most, [this](std::string_view line) { seen_.emplace_back(line); }, [this] { seen_.emplace_back("too long"); });
  }
  Pipe input_, output_, stop_;
  Lines lines_{.in = input_.out(), .out = output_.in(), .stop = stop_.out()};
  std::vector<std::string> seen_;
};

TEST_F(LinesTest, LinesAreSeenWholeAndTheLastOneOnlyWithItsEnd) {
  ASSERT_EQ(WriteAll(input_.in(), "one\n\ntwo\nhalf"), 0);
  input_.CloseIn();
  Read(100);
  EXPECT_THAT(seen_, ElementsAre("one", "", "two"));
}

TEST_F(LinesTest, ALineThatIsTooLongIsToldOnceAndSkipped) {
  std::thread writer([&] {
    EXPECT_EQ(WriteAll(input_.in(), std::string(10, 'a') + "\n" + std::string(300'000, 'b') + "\nc\n"), 0);
    input_.CloseIn();
  });
  Read(10);
  writer.join();
  EXPECT_THAT(seen_, ElementsAre("aaaaaaaaaa", "too long", "c"));
}

TEST_F(LinesTest, ReadingEndsWhenToldToStop) {
  ASSERT_EQ(WriteAll(stop_.in(), "s"), 0);
  Read(100);
  EXPECT_THAT(seen_, ElementsAre());
}

TEST_F(LinesTest, LongLinesArriveWholeThroughAPipe) {
  const std::string line(1 << 20, 'x');
  std::string got;
  std::thread reader([&] {
    char chunk[5000];
    for (ssize_t count = 0; (count = ::read(output_.out(), chunk, sizeof chunk)) > 0;) got.append(chunk, count);
  });
  lines_.Write(line);
  lines_.Write("end");
  output_.CloseIn();
  reader.join();
  EXPECT_EQ(got, line + "\nend\n");
}

TEST_F(LinesTest, LongLinesArriveWholeThroughASocket) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  lines_.out = ends[0];
  const std::string line(1 << 20, 'x');
  std::string got;
  std::thread reader([&] {
    char chunk[5000];
    for (ssize_t count = 0; (count = ::read(ends[1], chunk, sizeof chunk)) > 0;) got.append(chunk, count);
  });
  lines_.Write(line);
  ::close(ends[0]);
  reader.join();
  ::close(ends[1]);
  EXPECT_EQ(got, line + "\n");
}

TEST_F(LinesTest, NobodyIsWaitedForWhoHasGone) {
  input_.CloseIn();
  lines_.Write(std::string(1 << 20, 'x'));
  lines_.Write("lost");
}

TEST_F(LinesTest, NobodyIsWaitedForOnceToldToStop) {
  ASSERT_EQ(WriteAll(stop_.in(), "s"), 0);
  lines_.Write(std::string(1 << 20, 'x'));
}

}  // namespace
}  // namespace flair::cli::mcp
