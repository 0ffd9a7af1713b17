// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "absl/time/time.h"

namespace flair::runtime {

struct Page {
  // Such as "/metrics".
  std::string path;
  std::string content_type;
  // Called for every request, on the server's thread.
  std::function<std::string()> text;
};

// An HTTP server with one page and one thread. Takes a few connections at a time, each for one request of a few
// kilobytes, so that callers of whatever kind cannot take files, memory or threads from the program.
class OnePageServer {
 public:
  // Port "0" takes a free one. A caller has `patience` to send the request and to take the answer. Null when it cannot
  // listen there.
  static std::unique_ptr<OnePageServer> Start(const std::string& host, const std::string& port, Page page,
                                              absl::Duration patience);
  // Closes all connections.
  ~OnePageServer();

  int port() const { return port_; }

 private:
  class Form;
  OnePageServer(std::unique_ptr<Form> form, int port);

  const std::unique_ptr<Form> form_;
  const int port_;
};

}  // namespace flair::runtime
