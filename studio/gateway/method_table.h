// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/generic/generic_stub.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "studio/gateway/gateway.h"

namespace flair::studio {

// A method that the page may call.
struct Method {
  // As it is called, here and there: "/flair.v1.StudioService/Act".
  std::string path;
  // Full names of messages.
  std::string request_type;
  std::string response_type;
  bool streams = false;
  // Of a request's body.
  int64_t body_limit = 0;
  std::shared_ptr<grpc::GenericStub> stub;
};

// All of them. Immutable.
class MethodTable {
 public:
  // Finds the methods by the descriptors that are linked into the program. INVALID_ARGUMENT names what there is not,
  // and methods that stream from the caller.
  static absl::StatusOr<MethodTable> Make(const std::vector<ExposedService>& services, const GatewayLimits& limits);

  // nullptr when the page may not call that.
  const Method* Find(std::string_view path) const {
    const auto found = methods_.find(path);
    return found == methods_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::string, Method, std::less<>> methods_;
};

}  // namespace flair::studio
