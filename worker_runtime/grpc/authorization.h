// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/server_context.h>

#include <optional>
#include <string_view>

namespace flair::runtime {

// The call's metadata "authorization"; nullopt when there is none or more than one. Lives as long as the context.
inline std::optional<std::string_view> AuthorizationOf(const grpc::CallbackServerContext& context) {
  const auto& metadata = context.client_metadata();
  const auto [first, end] = metadata.equal_range("authorization");
  if (first == end || std::next(first) != end) return std::nullopt;
  return std::string_view(first->second.data(), first->second.size());
}

}  // namespace flair::runtime
