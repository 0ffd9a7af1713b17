// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/llm_server_process.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace flair::testing {
namespace {

[[noreturn]] void ServeLlm(const Script& script, const std::optional<TestCertificate>& certificate, int gate_count,
                           int read_fd, int write_fd) {
  ScriptedServer server(script, certificate);
  const int port = server.port();
  char byte = 'a';
  if (write(write_fd, &port, sizeof(port)) != sizeof(port)) _exit(1);
  if (gate_count > 0) {
    server.WaitForRequests(gate_count);
    if (write(write_fd, &byte, 1) != 1 || read(read_fd, &byte, 1) != 1) _exit(1);
    server.OpenGate("all came");
  }
  // Until the benchmark closes its end.
  while (read(read_fd, &byte, 1) > 0) {
  }
  _exit(0);
}

// A socket for this port of 127.0.0.1, any when 0; or one that is connected to it; -1 when there is none.
int LoopbackSocket(int& port, bool connected) {
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  const int failed = connected ? connect(fd, generic, size) : bind(fd, generic, size);
  if (failed != 0) {
    close(fd);
    return -1;
  }
  if (!connected && getsockname(fd, generic, &size) == 0) port = ntohs(address.sin_port);
  return fd;
}

int FreePort() {
  int port = 0;
  close(LoopbackSocket(port, false));
  return port;
}

bool Listens(int port) {
  const int fd = LoopbackSocket(port, true);
  if (fd >= 0) close(fd);
  return fd >= 0;
}

// Of FLAIR_NGHTTPX, else of the system; empty when there is none.
std::string FindNghttpx() {
  if (const char* const path = std::getenv("FLAIR_NGHTTPX")) return path;
  for (const char* path : {"/usr/sbin/nghttpx", "/usr/bin/nghttpx", "/usr/local/bin/nghttpx"}) {
    if (access(path, X_OK) == 0) return path;
  }
  return "";
}

}  // namespace

LlmServerProcess::LlmServerProcess(const Script& script, std::optional<TestCertificate> certificate, int gate_count) {
  int from_child[2], to_child[2];
  if (pipe(from_child) != 0 || pipe(to_child) != 0) std::abort();
  if (fork() == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close(from_child[0]);
    close(to_child[1]);
    ServeLlm(script, certificate, gate_count, to_child[0], from_child[1]);
  }
  close(from_child[1]);
  close(to_child[0]);
  read_fd_ = from_child[0];
  write_fd_ = to_child[1];
  Read(&port_, sizeof(port_));
  base_url_ = fmt::format("{}://127.0.0.1:{}/v1", certificate ? "https" : "http", port_);
}

LlmServerProcess::~LlmServerProcess() {
  close(read_fd_);
  close(write_fd_);
}

void LlmServerProcess::WaitForAll() const {
  char byte = 0;
  Read(&byte, 1);
}

void LlmServerProcess::OpenGate() const {
  if (write(write_fd_, "o", 1) != 1) std::abort();
}

void LlmServerProcess::Read(void* data, size_t size) const {
  if (read(read_fd_, data, size) != static_cast<ssize_t>(size)) std::abort();
}

std::unique_ptr<Http2Proxy> Http2Proxy::Start(const LlmServerProcess& server, const TestCertificate& certificate) {
  const std::string program = FindNghttpx();
  if (program.empty()) return nullptr;
  std::unique_ptr<Http2Proxy> proxy(new Http2Proxy());
  proxy->folder_ = fmt::format("{}/flair_http2_{}", std::filesystem::temp_directory_path().string(), getpid());
  std::filesystem::create_directories(proxy->folder_);
  const std::string key = proxy->folder_ + "/key.pem", chain = proxy->folder_ + "/certificate.pem";
  std::ofstream(key) << certificate.key_pem;
  std::ofstream(chain) << certificate.certificate_pem;
  const int port = FreePort();
  proxy->base_url_ = fmt::format("https://127.0.0.1:{}/v1", port);
  proxy->process_ = std::make_unique<Process>(
      program,
      std::vector<std::string>{"--conf=/dev/null", fmt::format("--frontend=127.0.0.1,{}", port),
                               fmt::format("--backend=127.0.0.1,{}", server.port()), "--workers=1",
                               "--frontend-http2-max-concurrent-streams=1000", "--log-level=FATAL", key, chain});
  while (proxy->process_->Running() && !Listens(port)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return proxy;
}

Http2Proxy::~Http2Proxy() {
  process_.reset();
  std::filesystem::remove_all(folder_);
}

std::string LongText(size_t byte_count) {
  const std::string sentence = "The bed stands with its head against the north wall, away from the door. ";
  std::string text;
  while (text.size() < byte_count) text += sentence;
  return text;
}

Script LongAnswers() {
  Script script = AlwaysAnswers(LongText(4000));
  // A token a piece.
  script.exchanges.front().answer["delta_bytes"] = {4};
  return script;
}

llm::ChatRequest LongQuestion() {
  return {.step = "objects",
          .messages = {{llm::Role::kSystem, LongText(10000)}, {llm::Role::kUser, LongText(8000)}},
          .schema = R"({"type":"object","properties":{"objects":{"type":"array","items":{"type":"string"}}}})",
          .schema_name = "objects"};
}

llm::OpenAiOptions OptionsFor(const std::string& base_url, bool stream) {
  llm::OpenAiOptions options;
  options.base_url = base_url;
  options.model = "some-model";
  options.stream = stream;
  return options;
}

Trust::Trust(const std::optional<TestCertificate>& certificate) {
  if (!certificate.has_value()) return;
  options_.ca_path = fmt::format("{}/flair_ca_{}.pem", std::filesystem::temp_directory_path().string(), getpid());
  std::ofstream(options_.ca_path) << certificate->certificate_pem;
}

Trust::~Trust() {
  if (!options_.ca_path.empty()) unlink(options_.ca_path.c_str());
}

double OwnStatus(const std::string& field) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double value = 0;
    if (word == field + ":" && status >> value) return field == "Threads" ? value : value / 1024;
  }
  return 0;
}

}  // namespace flair::testing
