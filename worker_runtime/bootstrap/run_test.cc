// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a real program and looks at what it says and how it ends.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// A program whose standard output and error come back as one stream of lines.
class Program {
 public:
  explicit Program(const std::string& argument) {
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::dup2(ends[1], STDERR_FILENO);
      ::close(ends[0]);
      ::close(ends[1]);
      const std::string path = FLAIR_BINARY_DIR "/test_bin/worker_runtime_run_test_program";
      ::execl(path.c_str(), path.c_str(), argument.empty() ? nullptr : argument.c_str(), nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ::fdopen(ends[0], "r");
  }
  ~Program() { std::fclose(output_); }

  std::string ReadLine() {
    char buffer[1024];
    return std::fgets(buffer, sizeof buffer, output_) == nullptr ? "" : buffer;
  }
  std::string ReadAll() {
    std::string all;
    for (std::string line = ReadLine(); !line.empty(); line = ReadLine()) all += line;
    return all;
  }
  void Signal(int number) { ::kill(pid_, number); }
  // The exit code, or minus the signal that ended it.
  int Wait() {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t pid_;
  std::FILE* output_;
};

std::string WriteConfig(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

TEST(Run, ServesSaysWhereAndStopsWhenTold) {
  for (const int signal_number : {SIGTERM, SIGINT}) {
    Program program(WriteConfig("flair_run_test_good.textproto", "runtime { log_level: \"error\" }"));
    const std::string line = program.ReadLine();
    ASSERT_THAT(line, StartsWith("listening on 127.0.0.1:"));
    const std::string address = line.substr(13, line.size() - 14);
    const auto stub = v1::WorkerService::NewStub(*MakeChannel(address, v1::WorkerService::service_full_name()));
    CallContext call;
    const auto answer = UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call);
    ASSERT_TRUE(answer.ok()) << answer.status();
    EXPECT_EQ(answer->program(), "flair-test");
    program.Signal(signal_number);
    EXPECT_EQ(program.Wait(), 0);
    EXPECT_EQ(program.ReadAll(), "");
  }
}

TEST(Run, ExplainsItself) {
  Program program("--help");
  EXPECT_THAT(program.ReadAll(), HasSubstr("Usage: flair-test CONFIG"));
  EXPECT_EQ(program.Wait(), 0);
}

TEST(Run, RefusesToRunWithoutAConfig) {
  for (const std::string argument : {"", "--frobnicate"}) {
    Program program(argument);
    EXPECT_THAT(program.ReadAll(), HasSubstr("Usage: flair-test CONFIG"));
    EXPECT_EQ(program.Wait(), 2);
  }
}

TEST(Run, NamesWhatIsWrongInTheConfig) {
  const std::string path = WriteConfig("flair_run_test_bad.textproto", "runtime {\n  queue_limit: -1\n}\n");
  Program program(path);
  EXPECT_THAT(program.ReadAll(), HasSubstr(path + ":2: runtime.queue_limit: -1 is out of range [1, 100000]"));
  EXPECT_EQ(program.Wait(), 2);
}

TEST(Run, SaysThatItCannotListen) {
  Program first(WriteConfig("flair_run_test_first.textproto", "runtime { log_level: \"error\" }"));
  const std::string line = first.ReadLine();
  const std::string address = line.substr(13, line.size() - 14);
  Program second(WriteConfig("flair_run_test_second.textproto",
                             "runtime { log_level: \"error\" listen_address: \"" + address + "\" }"));
  EXPECT_EQ(second.ReadAll(), "flair-test: cannot listen on " + address +
                                  ": the address is in use, not of this machine, or not permitted\n");
  EXPECT_EQ(second.Wait(), 1);
  first.Signal(SIGTERM);
  EXPECT_EQ(first.Wait(), 0);
}

TEST(Run, SaysWhereItsFiguresAreAndThatItCannotServeThemThere) {
  const std::string quiet = "runtime { log_level: \"error\" metrics_address: \"";
  Program first(WriteConfig("flair_run_test_figures.textproto", quiet + "127.0.0.1:0\" }"));
  EXPECT_THAT(first.ReadLine(), StartsWith("listening on 127.0.0.1:"));
  const std::string line = first.ReadLine();
  ASSERT_THAT(line, StartsWith("metrics on 127.0.0.1:"));
  const std::string address = line.substr(11, line.size() - 12);
  Program second(WriteConfig("flair_run_test_same_figures.textproto", quiet + address + "\" }"));
  EXPECT_EQ(second.ReadAll(),
            "flair-test: metrics_address " + address +
                ": cannot listen there: the address is in use, not of this machine, or not permitted\n");
  EXPECT_EQ(second.Wait(), 1);
  first.Signal(SIGTERM);
  EXPECT_EQ(first.Wait(), 0);
}

}  // namespace
}  // namespace flair::runtime
