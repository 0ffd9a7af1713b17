// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_workers.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

WorkerPoolOptions PoolOptions(const char* stage, const StageChannel& where, const StageWorkersOptions& all) {
  const config::v1::StageCallConfig& calls = all.calls;
  WorkerPoolOptions options = {
      .stage = stage, .setting = where.setting, .log = all.log, .outage_limit = all.outage_limit};
  if (calls.in_flight_limit() > 0) options.in_flight_limit = calls.in_flight_limit();
  if (calls.failure_limit() > 0) options.failure_limit = calls.failure_limit();
  if (calls.has_recovery_seconds()) options.recovery = absl::Seconds(calls.recovery_seconds());
  if (calls.has_hedge_seconds()) options.patience = absl::Seconds(calls.hedge_seconds());
  return options;
}

using std::chrono::seconds;
using std::chrono::system_clock;

// GetWorker answers at once, also when the worker is busy.
constexpr seconds kAnswerWithin{10};
// Between questions that were not answered, while the connection stands.
constexpr seconds kAskAgainAfter{1};
// A watch of a state that stays is renewed after this.
constexpr std::chrono::minutes kWatchFor{10};

// All that decides its answers. A revision alone does not do: two servers may call theirs "1".
std::optional<std::string> RevisionOf(const v1::GetWorkerResponse& worker) {
  if (worker.revision().empty()) return std::nullopt;
  v1::GetWorkerResponse key;
  key.set_program(worker.program());
  key.set_revision(worker.revision());
  key.set_configuration_digest(worker.configuration_digest());
  return runtime::CanonicalBytes(key);
}

}  // namespace

WorkersOfStage::WorkersOfStage(const char* stage, StageChannel where, const StageWorkersOptions& options,
                               Connections& connections, const runtime::Clock& clock)
    : options_(PoolOptions(stage, where, options)),
      where_(std::move(where)),
      lookup_(options.lookup),
      connections_(connections),
      pool_(options_, clock) {
  if (where_.connect == nullptr) {
    const WorkerId id = pool_.Add(where_.address);
    open_[id] = connections_.Open({pool_, id, options_.stage, where_.address, options_.setting}, where_.channel, false);
  } else if (absl::StatusOr<StageAddresses> addresses = ParseStageAddresses(where_.address); addresses.ok()) {
    addresses_ = *std::move(addresses);
    for (const std::string& address : addresses_.workers) Add({address, ""});
  }
  if (!has_names()) pool_.SetFound(absl::OkStatus());
}

std::shared_ptr<Connection> WorkersOfStage::ConnectionTo(WorkerId id) const {
  std::lock_guard lock(mutex_);
  const auto found = open_.find(id);
  return found == open_.end() ? nullptr : found->second;
}

void WorkersOfStage::Add(const Listed& worker) {
  const WorkerId id = pool_.Add(worker.address);
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel = where_.connect(worker.address, worker.server_name);
  std::lock_guard lock(mutex_);
  if (!worker.server_name.empty()) found_[worker] = id;
  if (!channel.ok()) {
    pool_.SetGone(id, absl::UnavailableError(channel.status().message()));
    return;
  }
  open_[id] =
      connections_.Open({pool_, id, options_.stage, worker.address, options_.setting}, *std::move(channel), true);
}

void WorkersOfStage::LookUp() {
  std::set<Listed> listed;
  absl::Status status;
  for (const StageAddresses::Name& name : addresses_.names) {
    const absl::StatusOr<std::vector<std::string>> hosts = lookup_(name.host);
    if (!hosts.ok()) {
      status = hosts.status();
      continue;
    }
    for (const std::string& host : *hosts) listed.insert({JoinHostPort(host, name.port), name.host});
  }
  std::set<Listed> added = listed;
  std::map<WorkerId, std::shared_ptr<Connection>> removed;
  {
    std::lock_guard lock(mutex_);
    for (auto it = found_.begin(); it != found_.end();) {
      added.erase(it->first);
      if (!status.ok() || listed.contains(it->first)) {
        ++it;
        continue;
      }
      removed[it->second] = std::move(open_[it->second]);
      open_.erase(it->second);
      pool_.Remove(it->second);
      it = found_.erase(it);
    }
  }
  for (const Listed& worker : added) Add(worker);
  pool_.SetFound(status);
}

StageWorkers::StageWorkers(const StageChannels& channels, StageWorkersOptions options, const runtime::Clock& clock)
    : options_(std::move(options)),
      language_("language", channels.language, options_, connections_, clock),
      translator_("translator", channels.translator, options_, connections_, clock),
      optimizer_("optimizer", channels.optimizer, options_, connections_, clock),
      renderer_("renderer", channels.renderer, options_, connections_, clock),
      clients_(MakeGrpcStageClients({language_, translator_, optimizer_, renderer_})) {
  if (std::ranges::none_of(All(), &WorkersOfStage::has_names)) return;
  lookups_.emplace([this] {
    for (WorkersOfStage* workers : All()) {
      if (workers->has_names()) workers->LookUp();
    }
    return options_.lookup_interval;
  });
}

std::vector<v1::WorkerStatus> StageWorkers::Status() const {
  std::vector<v1::WorkerStatus> all;
  for (const WorkersOfStage* workers : {&language_, &translator_, &optimizer_, &renderer_}) {
    std::vector<v1::WorkerStatus> some = workers->pool().Status();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<WorkersOfStage*> StageWorkers::All() { return {&language_, &translator_, &optimizer_, &renderer_}; }

Connection::Connection(Connections& connections, Connections::Worker worker, std::shared_ptr<grpc::Channel> channel,
                       bool watched)
    : connections_(connections),
      worker_(std::move(worker)),
      channel_(std::move(channel)),
      watched_(watched),
      stub_(v1::WorkerService::NewStub(channel_)) {}

Connection::~Connection() {
  if (question_ != nullptr) question_->context.TryCancel();
}

void Connection::Open() {
  if (watched_) {
    Watch();
  } else {
    Ask();
  }
}

void Connection::Watch() {
  const grpc_connectivity_state state = channel_->GetState(true);
  OnState(state);
  const auto again = [weak = weak_from_this()](bool) {
    if (const std::shared_ptr<Connection> self = weak.lock()) self->Watch();
  };
  connections_.Start(again, [&](grpc::CompletionQueue& events, void* tag) {
    channel_->NotifyOnStateChange(state, system_clock::now() + kWatchFor, &events, tag);
  });
}

void Connection::OnState(grpc_connectivity_state state) {
  if (state == GRPC_CHANNEL_READY) {
    if (std::lock_guard lock(mutex_); ready_) return;
    Ask();
    return;
  }
  bool was_ready;
  {
    std::lock_guard lock(mutex_);
    was_ready = std::exchange(ready_, false);
    question_ = nullptr;
  }
  if (was_ready) worker_.pool.SetConnecting(worker_.id);
  // A call tells why; the state does not.
  if (state == GRPC_CHANNEL_TRANSIENT_FAILURE) Ask();
}

void Connection::Ask() {
  const auto question = std::make_shared<Question>();
  question->context.set_deadline(system_clock::now() + kAnswerWithin);
  {
    std::lock_guard lock(mutex_);
    question_ = question;
  }
  const auto answered = [weak = weak_from_this(), question](bool) {
    if (const std::shared_ptr<Connection> self = weak.lock()) self->OnAnswer(*question);
  };
  connections_.Start(answered, [&](grpc::CompletionQueue& events, void* tag) {
    question->reader = stub_->AsyncGetWorker(&question->context, v1::GetWorkerRequest(), &events);
    question->reader->Finish(&question->answer, &question->status, tag);
  });
}

void Connection::OnAnswer(const Question& question) {
  {
    std::lock_guard lock(mutex_);
    if (question_.get() != &question) return;
    question_ = nullptr;
    const bool told = question.status.ok() || question.status.error_code() == grpc::StatusCode::UNIMPLEMENTED;
    ready_ = told && runtime::ProtocolFault(question.answer).empty();
  }
  const absl::Status status = runtime::FromGrpcStatus(question.status);
  if (absl::IsUnimplemented(status)) {
    worker_.pool.SetReady(worker_.id, std::nullopt);
  } else if (!status.ok()) {
    worker_.pool.SetGone(worker_.id, absl::UnavailableError(status.message()));
    AskLater();
  } else if (const std::string fault = runtime::ProtocolFault(question.answer); !fault.empty()) {
    worker_.pool.SetGone(worker_.id, Unimplemented("{} worker at {}: {}; start a version of it that does or fix {}",
                                                   worker_.stage, worker_.address, fault, worker_.setting));
  } else {
    worker_.pool.SetReady(worker_.id, RevisionOf(question.answer));
  }
}

// Where the connection stands but the worker did not answer, nothing will tell that it does again.
void Connection::AskLater() {
  if (watched_ && channel_->GetState(false) != GRPC_CHANNEL_READY) return;
  std::lock_guard lock(mutex_);
  alarm_ = std::make_unique<grpc::Alarm>();
  const auto ask = [weak = weak_from_this()](bool ok) {
    if (const std::shared_ptr<Connection> self = ok ? weak.lock() : nullptr) self->AskAgain();
  };
  connections_.Start(ask, [&](grpc::CompletionQueue& events, void* tag) {
    alarm_->Set(&events, system_clock::now() + kAskAgainAfter, tag);
  });
}

void Connection::AskAgain() {
  if (!watched_ || channel_->GetState(false) == GRPC_CHANNEL_READY) Ask();
}

Connections::Connections() : thread_([this] { Run(); }) {}

Connections::~Connections() {
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
    events_.Shutdown();
  }
  thread_.join();
}

std::shared_ptr<Connection> Connections::Open(Worker worker, std::shared_ptr<grpc::Channel> channel, bool watched) {
  const auto connection = std::make_shared<Connection>(*this, std::move(worker), std::move(channel), watched);
  connection->Open();
  return connection;
}

void Connections::Start(Step step, const std::function<void(grpc::CompletionQueue&, void* tag)>& begin) {
  std::lock_guard lock(mutex_);
  if (!stopped_) begin(events_, new Step(std::move(step)));
}

void Connections::Run() {
  void* tag = nullptr;
  bool ok = false;
  while (events_.Next(&tag, &ok)) {
    const std::unique_ptr<Step> step(static_cast<Step*>(tag));
    (*step)(ok);
  }
}

}  // namespace flair::orchestrator
