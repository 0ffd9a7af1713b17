// SPDX-License-Identifier: GPL-3.0-or-later
// Servers of single stages that the user named, in place of those in this process.
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace flair::cli {

// What a stage is called on the command line and on the wire.
struct StageName {
  const char* flag;     // such as "--optimizer"
  const char* service;  // full name, such as "flair.v1.OptimizerService"
  // Asks nothing of it, which tells whether the service is there: a request without content costs no server anything.
  absl::Status (*ask_nothing)(const std::shared_ptr<grpc::Channel>& channel);
};
extern const StageName kLanguageStage;
extern const StageName kTranslatorStage;
extern const StageName kOptimizerStage;
extern const StageName kRendererStage;

// A channel to the server at `address`, which has answered. INVALID_ARGUMENT when the address has no right form or
// leads to a server of something else or of another version of the protocol, UNAVAILABLE when nobody answers; all name
// flag and address. `max_message_mib` 0: as runtime::MakeChannel.
absl::StatusOr<std::shared_ptr<grpc::Channel>> ConnectToStage(const StageName& stage, const std::string& address,
                                                              int max_message_mib = 0);

// `status` of a later call in words, when it says that the server is not there any more; itself otherwise.
absl::Status InWords(const StageName& stage, const std::string& address, const absl::Status& status);

}  // namespace flair::cli
