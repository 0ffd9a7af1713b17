// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>

#include "cli/output/output_folder.h"
#include "orchestrator/testing/temporary_folder.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

class Files : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.path() + "/" + name; }
  void ExpectRefused(const std::string& path, absl::StatusCode code, const std::string& words) const {
    const absl::StatusOr<std::string> content = ReadFile(path);
    EXPECT_EQ(content.status().code(), code) << content.status();
    EXPECT_THAT(std::string(content.status().message()), ::testing::AllOf(HasSubstr(path), HasSubstr(words)));
  }

  const orchestrator::TemporaryFolder folder_;
};

TEST_F(Files, WhatWasWrittenIsRead) {
  for (const size_t size : {0, 1, 4095, 4096, 100000}) {
    const std::string bytes(size, '\0');
    std::ofstream(Path("file"), std::ios::binary) << bytes;
    EXPECT_EQ(ReadFile(Path("file")).value(), bytes);
  }
}

TEST_F(Files, LinksAreFollowedToAFile) {
  std::ofstream(Path("file")) << "content";
  ::symlink(Path("file").c_str(), Path("first").c_str());
  ::symlink("first", Path("second").c_str());
  EXPECT_EQ(ReadFile(Path("second")).value(), "content");
  ::symlink("nowhere", Path("broken").c_str());
  ExpectRefused(Path("broken"), absl::StatusCode::kNotFound, "a link to nowhere, which does not exist");
  ::symlink("itself", Path("itself").c_str());
  ExpectRefused(Path("itself"), absl::StatusCode::kFailedPrecondition, "leads back to itself");
  ::symlink("/dev/zero", Path("device").c_str());
  ExpectRefused(Path("device"), absl::StatusCode::kFailedPrecondition, "is a device");
}

TEST_F(Files, WhatIsNoFileIsRefusedAtOnce) {
  ::mkfifo(Path("pipe").c_str(), 0600);
  ExpectRefused(Path("pipe"), absl::StatusCode::kFailedPrecondition, "is a pipe; save its output to a file");
  ExpectRefused(folder_.path(), absl::StatusCode::kFailedPrecondition, "is a folder");
  ExpectRefused("/dev/null", absl::StatusCode::kFailedPrecondition, "is a device");
  ExpectRefused(Path("none"), absl::StatusCode::kNotFound, "no such file");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  Path("socket").copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ExpectRefused(Path("socket"), absl::StatusCode::kFailedPrecondition, "is a socket");
  ::close(socket);
}

TEST_F(Files, OneThatIsTooLargeIsNotEvenOpened) {
  std::ofstream(Path("large")) << "x";
  ASSERT_EQ(::truncate(Path("large").c_str(), int64_t{1} << 40), 0);
  ExpectRefused(Path("large"), absl::StatusCode::kInvalidArgument, "has 1048576 MiB; at most 256");
}

TEST_F(Files, OneThatSaysItIsEmptyIsReadToItsEnd) {
  EXPECT_THAT(ReadFile("/proc/self/status").value(), HasSubstr("VmPeak"));  // sizes in /proc are 0
}

}  // namespace
}  // namespace flair::cli
