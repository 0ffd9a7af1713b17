// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/testing/browser.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "fmt/format.h"

namespace flair::studio::testing {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr size_t kEnvelopeHeader = 5;

Answer ParseHead(const std::string& head) {
  Answer answer;
  const std::vector<std::string> lines = absl::StrSplit(head, "\r\n");
  if (lines[0].size() < 12) return answer;
  answer.status = std::stoi(lines[0].substr(9, 3));
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::pair<std::string, std::string> parts = absl::StrSplit(lines[i], absl::MaxSplits(": ", 1));
    answer.headers[absl::AsciiStrToLower(parts.first)] = parts.second;
  }
  return answer;
}

}  // namespace

std::string TestToken() { return std::string(64, '7'); }

Browser::Browser(int port) : port_(port) {
  error_code error;
  socket_.connect(tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<uint16_t>(port)), error);
}

std::string Browser::Request(const std::string& line, Headers headers, const Headers& changes,
                             const std::string& body) const {
  headers["Host"] = fmt::format("127.0.0.1:{}", port_);
  headers["Cookie"] = fmt::format("other=1; flair_studio_{}={}", port_, TestToken());
  headers["Sec-Fetch-Site"] = "same-origin";
  for (const auto& [name, value] : changes) headers[name] = value;
  std::string text = line + " HTTP/1.1\r\n";
  for (const auto& [name, value] : headers) {
    if (!value.empty()) text += fmt::format("{}: {}\r\n", name, value);
  }
  return text + "\r\n" + body;
}

std::string Browser::Get(const std::string& path, const Headers& changes) const {
  return Request("GET " + path, {}, changes, "");
}

std::string Browser::Post(const std::string& path, const std::string& body, const Headers& changes) const {
  return Request("POST " + path,
                 {{"Origin", fmt::format("http://127.0.0.1:{}", port_)},
                  {"Content-Type", "application/json"},
                  {"Connect-Protocol-Version", "1"},
                  {"Content-Length", std::to_string(body.size())}},
                 changes, body);
}

std::string Browser::PostStream(const std::string& path, const std::string& message, const Headers& changes) const {
  std::string envelope(1, '\0');
  for (int shift = 24; shift >= 0; shift -= 8) envelope += static_cast<char>(message.size() >> shift & 0xff);
  Headers all = {{"Content-Type", "application/connect+json"}};
  for (const auto& [name, value] : changes) all[name] = value;
  return Post(path, envelope + message, all);
}

bool Browser::Say(std::string_view bytes) {
  error_code error;
  asio::write(socket_, asio::buffer(bytes), error);
  return !error;
}

void Browser::FinishSaying() {
  error_code ignored;
  socket_.shutdown(tcp::socket::shutdown_send, ignored);
}

bool Browser::ReadUntil(std::string_view end) {
  error_code error;
  asio::read_until(socket_, asio::dynamic_buffer(buffer_), end, error);
  return !error;
}

bool Browser::ReadSize(size_t size) {
  error_code error;
  if (buffer_.size() < size) {
    asio::read(socket_, asio::dynamic_buffer(buffer_), asio::transfer_exactly(size - buffer_.size()), error);
  }
  return !error;
}

std::string Browser::Take(size_t size) {
  std::string taken = buffer_.substr(0, size);
  buffer_.erase(0, size);
  return taken;
}

Answer Browser::ReadStreamHead() {
  if (!ReadUntil("\r\n\r\n")) return {};
  const std::string head = Take(buffer_.find("\r\n\r\n") + 4);
  return ParseHead(head.substr(0, head.size() - 4));
}

Answer Browser::Read(bool head_only) {
  Answer answer = ReadStreamHead();
  if (head_only || !answer.headers.contains("content-length")) return answer;
  const size_t size = std::stoul(answer.headers["content-length"]);
  if (!ReadSize(size)) return {};
  answer.body = Take(size);
  return answer;
}

std::optional<Message> Browser::ReadMessage() {
  if (!ReadUntil("\r\n")) return std::nullopt;
  const size_t size = std::stoul(Take(buffer_.find("\r\n") + 2), nullptr, 16);
  if (!ReadSize(size + 2)) return std::nullopt;
  const std::string chunk = Take(size + 2);
  if (size < kEnvelopeHeader) return std::nullopt;
  return Message{.last = chunk[0] == 2, .json = chunk.substr(kEnvelopeHeader, size - kEnvelopeHeader)};
}

std::string Browser::ReadAll() {
  error_code error;
  asio::read(socket_, asio::dynamic_buffer(buffer_), asio::transfer_all(), error);
  return Take(buffer_.size());
}

void Browser::Leave() {
  error_code ignored;
  socket_.close(ignored);
}

}  // namespace flair::studio::testing
