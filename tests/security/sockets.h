// SPDX-License-Identifier: GPL-3.0-or-later
// Connections of somebody who means no good.
#pragma once

#include <string>
#include <vector>

namespace flair::testing {

// Sockets to one address; closed at the end.
class Sockets {
 public:
  ~Sockets();
  // Connects one more to "HOST:PORT" of this machine, from `source` (such as "127.0.0.2"); false when it is refused.
  bool Connect(const std::string& address, const std::string& source = "127.0.0.1");
  // Sends to the one that was connected last; whether it took it.
  bool SendToLast(const std::string& bytes);
  // Sends to all that are open; how many took it.
  int SendToAll(const std::string& bytes);
  // Waits until the other side has closed all of them, at most so long; how many are still open.
  int WaitForClose(int seconds);
  // How many are open now.
  int CountOpen();
  int count() const { return static_cast<int>(files_.size()); }

 private:
  std::vector<int> files_;
};

// Allows this process as many files as it may have; how many.
int RaiseFileLimit();

}  // namespace flair::testing
