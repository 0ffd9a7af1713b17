// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of a work queue, as the contract meets them: each can be opened any number of times, as if by as many
// processes.
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/work_queue.h"
#include "tests/fixtures/nats_server.h"

namespace flair::testing {

// One queue, empty at first.
class QueueForm {
 public:
  virtual ~QueueForm() = default;
  virtual absl::StatusOr<std::unique_ptr<orchestrator::WorkQueue>> Open() = 0;
  virtual absl::StatusOr<std::unique_ptr<orchestrator::ArtifactStore>> OpenArtifacts() = 0;
  // Those that keep it; null when none do.
  virtual NatsServers* servers() { return nullptr; }
  // Arguments with which flair_queue_child opens it in another process.
  virtual std::vector<std::string> ChildArguments() const = 0;
};

struct NamedForm {
  std::string name;
  std::function<std::unique_ptr<QueueForm>()> make;
};
inline std::ostream& operator<<(std::ostream& out, const NamedForm& form) { return out << form.name; }

// In a folder; the same with artifacts as those of several machines would share them; on one server with a lease of a
// second; on three of them.
NamedForm FolderForm();
NamedForm SharedFolderForm();
NamedForm JetStreamForm(int server_count);

}  // namespace flair::testing
