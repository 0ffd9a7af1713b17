// SPDX-License-Identifier: GPL-3.0-or-later
// For the module that links OpenImageIO.
#pragma once

#include <OpenImageIO/imageio.h>

#include <mutex>

namespace flair::renderer {

// Calls run on threads of their own, so the library needs none. Once for all of them: setting it changes a pool that
// another call may be using, which ends the process.
inline void SetUpLibrary() {
  static std::once_flag once;
  std::call_once(once, [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("debug", 0);
  });
}

}  // namespace flair::renderer
