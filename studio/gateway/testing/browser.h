// SPDX-License-Identifier: GPL-3.0-or-later
// One connection of a browser, or of somebody who says what he likes. Waits for what it reads.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "studio/gateway/gateway.h"

namespace flair::studio::testing {

// 64 digits, for GatewayOptions::token.
std::string TestToken();

struct Answer {
  // 0: there was none.
  int status = 0;
  // By their names in lower case.
  std::map<std::string, std::string> headers;
  std::string body;
};

// Of a stream.
struct Message {
  bool last = false;
  std::string json;
};

// Headers that are added to, or replace, those that a page of the gateway sends; an empty value takes one away.
using Headers = std::map<std::string, std::string>;

class Browser {
 public:
  explicit Browser(int port);
  explicit Browser(const Gateway& gateway) : Browser(gateway.port()) {}

  // The text of a request, with the cookie.
  std::string Get(const std::string& path, const Headers& changes = {}) const;
  std::string Post(const std::string& path, const std::string& body, const Headers& changes = {}) const;
  // The same of a call that streams.
  std::string PostStream(const std::string& path, const std::string& message, const Headers& changes = {}) const;

  // False when the other side has closed.
  bool Say(std::string_view bytes);
  // Nothing more will be said.
  void FinishSaying();
  // The next answer.
  Answer Read(bool head_only = false);
  Answer Ask(std::string_view request) { return Say(request) ? Read() : Answer{}; }
  // After the head of a stream: its next message; nothing when the stream is cut off or has ended.
  Answer ReadStreamHead();
  std::optional<Message> ReadMessage();
  // All until the other side closes.
  std::string ReadAll();
  // Closes.
  void Leave();

 private:
  std::string Request(const std::string& line, Headers headers, const Headers& changes, const std::string& body) const;
  bool ReadUntil(std::string_view end);
  bool ReadSize(size_t size);
  std::string Take(size_t size);

  const int port_;
  boost::asio::io_context context_;
  boost::asio::ip::tcp::socket socket_{context_};
  std::string buffer_;
};

}  // namespace flair::studio::testing
