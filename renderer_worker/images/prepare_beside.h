// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <system_error>
#include <thread>

#include "renderer_worker/images/image_writer.h"

namespace flair::renderer {

// Prepares a writer on a thread of its own while something is drawn; its end waits for it. Without a thread to be had
// the first picture does it. Borrows the writer.
class PrepareBeside {
 public:
  explicit PrepareBeside(ImageWriter& writer) {
    try {
      thread_ = std::jthread([&writer] { writer.Prepare(); });
    } catch (const std::system_error&) {
    }
  }

 private:
  std::jthread thread_;
};

}  // namespace flair::renderer
