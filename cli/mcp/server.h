// SPDX-License-Identifier: GPL-3.0-or-later
// The Model Context Protocol, free of what the tools do: versions, lists, calls, progress and cancellation.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/mcp/message.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli::mcp {

// What a tool knows of the call that it answers.
class ToolCall {
 public:
  virtual ~ToolCall() = default;
  // Cancelled when the caller gives up.
  virtual runtime::CallContext& context() = 0;
  // Tells a caller who asked for it how far the work is; `progress` must grow from call to call. Thread-safe.
  virtual void Tell(double progress, double total, const std::string& message) = 0;
};

// What a tool answers.
struct ToolResult {
  // Blocks of content, such as {"type": "text", "text": ...}; the structured one as text when empty.
  Json content = Json::array();
  // As the tool's outputSchema says.
  Json structured = Json::object();
};

struct Tool {
  // As in tools/list: name, title, description, inputSchema, outputSchema, annotations.
  Json listed;
  // Called with arguments that fit the schema. Faults go to the caller as a result with isError.
  std::function<absl::StatusOr<ToolResult>(const Json& arguments, ToolCall& call)> run;
};

// What is offered beside tools.
struct Resources {
  // As in resources/list and resources/templates/list.
  std::function<absl::StatusOr<Json>()> list;
  Json templates = Json::array();
  // One item of `contents`; NOT_FOUND when there is no such thing.
  std::function<absl::StatusOr<Json>(const std::string& uri, runtime::CallContext& call)> read;
};

struct Offer {
  // name, title, version.
  Json server_info;
  // For models, how to use the tools.
  std::string instructions;
  std::vector<Tool> tools;
  Resources resources;
};

// Revisions that are spoken: those with a handshake, newest first, and the one where each request names its own.
inline constexpr const char* kHandshakeVersions[] = {"2025-11-25", "2025-06-18"};
inline constexpr const char* kModernVersion = "2026-07-28";

// One conversation. Calls of tools and reads of resources run at the same time, a few at once; their answers come in
// any order. Receive is for one thread.
class Server {
 public:
  // Sends a line, one at a time; it must not call the server.
  using Send = std::function<void(const std::string& line)>;

  Server(Offer offer, Send send);
  // Cancels what runs and waits for it. Nothing is sent afterwards.
  ~Server();

  // One line of the client's.
  void Receive(std::string_view line);
  // A line was longer than kMostLineBytes.
  void ReceiveTooLong();

 private:
  class Call;
  // What a request is answered with at once; nothing when its answer comes later.
  using Answer = std::variant<std::monostate, Json, Fault>;

  Answer Handle(const Message& request);
  // Whether a request names its revision itself, which must be kModernVersion.
  std::variant<bool, Fault> ReadRevision(const Message& request) const;
  Answer Initialize(const Json& params);
  Answer List(const std::string& method, const Json& params, bool modern) const;
  Answer StartCall(const Message& request, bool modern);
  Answer Start(std::shared_ptr<Call> call, bool queued);
  Answer Listen(const Message& request);
  void Cancel(const Json& params);

  void Work();
  Json RunTool(Call& call) const;
  std::variant<Json, Fault> ReadResource(Call& call) const;
  // Forgets a call; whether anybody still waits for its answer.
  bool Finish(const Call& call);
  // Marks a result as its revision wants it. `ttl_ms` is set where it may be kept for so long.
  Json Complete(Json result, bool modern, std::optional<int> ttl_ms = std::nullopt) const;
  void SendLine(const std::string& line);

  const Offer offer_;
  const Send send_;
  bool initialized_ = false;

  std::mutex send_mutex_;
  std::mutex mutex_;  // of all below
  std::condition_variable waiting_;
  std::map<std::string, std::shared_ptr<Call>> calls_;  // by id as JSON, until answered or cancelled
  std::deque<std::shared_ptr<Call>> queue_;
  bool closing_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace flair::cli::mcp
