// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/method_table.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>

#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

using google::protobuf::DescriptorPool;
using google::protobuf::MethodDescriptor;
using google::protobuf::ServiceDescriptor;

std::vector<std::string> NamesOf(const ServiceDescriptor& service) {
  std::vector<std::string> names;
  for (int i = 0; i < service.method_count(); ++i) {
    if (!service.method(i)->client_streaming()) names.push_back(service.method(i)->name());
  }
  return names;
}

absl::StatusOr<const MethodDescriptor*> FindMethod(const ServiceDescriptor& service, const std::string& name) {
  const MethodDescriptor* method = service.FindMethodByName(name);
  if (method == nullptr) return InvalidArgument("{} has no method {}", service.full_name(), name);
  if (method->client_streaming()) {
    return InvalidArgument("{}: its caller streams, which browsers cannot", method->full_name());
  }
  return method;
}

}  // namespace

absl::StatusOr<MethodTable> MethodTable::Make(const std::vector<ExposedService>& services,
                                              const GatewayLimits& limits) {
  MethodTable table;
  for (const ExposedService& exposed : services) {
    const ServiceDescriptor* service = DescriptorPool::generated_pool()->FindServiceByName(exposed.full_name);
    if (service == nullptr) return InvalidArgument("this program knows no service {}", exposed.full_name);
    if (exposed.channel == nullptr) return InvalidArgument("{}: there is no channel to it", exposed.full_name);
    const std::vector<std::string> names = exposed.methods.empty() ? NamesOf(*service) : exposed.methods;
    for (const std::string& upload : exposed.upload_methods) {
      if (std::ranges::find(names, upload) == names.end()) {
        return InvalidArgument("{} exposes no method {} for uploads", exposed.full_name, upload);
      }
    }
    const auto stub = std::make_shared<grpc::GenericStub>(exposed.channel);
    for (const std::string& name : names) {
      ASSIGN_OR_RETURN(const MethodDescriptor* method, FindMethod(*service, name));
      const bool uploads = std::ranges::find(exposed.upload_methods, name) != exposed.upload_methods.end();
      Method entry = {.path = fmt::format("/{}/{}", exposed.full_name, name),
                      .request_type = method->input_type()->full_name(),
                      .response_type = method->output_type()->full_name(),
                      .streams = method->server_streaming(),
                      .body_limit = uploads ? limits.upload_bytes : limits.body_bytes,
                      .stub = stub};
      const std::string path = entry.path;
      table.methods_.emplace(path, std::move(entry));
    }
  }
  return table;
}

}  // namespace flair::studio
