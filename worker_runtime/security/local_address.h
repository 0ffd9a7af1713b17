// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair::runtime {

// Whether only this machine can be meant by an address to serve on or to call: "HOST:PORT" with HOST in 127.0.0.0/8,
// ::1 or "localhost", also after "dns:///", "ipv4:" or "ipv6:", or "unix:PATH". False for anything else, also for what
// is no address.
bool IsLocalAddress(std::string_view address);

}  // namespace flair::runtime
