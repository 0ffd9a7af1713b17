// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/server.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "cli/mcp/schema.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

constexpr int kThreads = 4;
constexpr size_t kMostCalls = 64;
constexpr int kListTtl_ms = 3600 * 1000;

constexpr char kVersionKey[] = "io.modelcontextprotocol/protocolVersion";
constexpr char kCapabilitiesKey[] = "io.modelcontextprotocol/clientCapabilities";
constexpr char kServerKey[] = "io.modelcontextprotocol/serverInfo";
constexpr char kSubscriptionKey[] = "io.modelcontextprotocol/subscriptionId";

const Json& Capabilities() {
  static const Json& all = *new Json{{"tools", Json::object()}, {"resources", Json::object()}};
  return all;
}

// The metadata of a request; empty when it has none.
Json MetaOf(const Json& params) {
  const auto meta = params.find("_meta");
  return meta != params.end() && meta->is_object() ? *meta : Json::object();
}

}  // namespace

class Server::Call : public ToolCall {
 public:
  Call(Server& server, const Message& request, bool modern)
      : server_(server),
        request_(request),
        modern_(modern),
        token_(MetaOf(request.params).value("progressToken", Json())) {}

  runtime::CallContext& context() override { return context_; }
  void Tell(double progress, double total, const std::string& message) override {
    if (token_.is_null() || context_.cancelled() || progress <= told_) return;
    told_ = progress;
    Json params = {{"progressToken", token_}, {"progress", progress}, {"message", message}};
    if (total > 0) params["total"] = total;
    server_.SendLine(NotificationLine("notifications/progress", std::move(params)));
  }

  const Message& request() const { return request_; }
  std::string key() const { return request_.id.dump(); }
  bool modern() const { return modern_; }

 private:
  Server& server_;
  const Message request_;
  const bool modern_;
  const Json token_;
  double told_ = -1;
  runtime::CallContext context_;
};

Server::Server(Offer offer, Send send) : offer_(std::move(offer)), send_(std::move(send)) {
  for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { Work(); });
}

Server::~Server() {
  std::map<std::string, std::shared_ptr<Call>> left;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    left.swap(calls_);
    queue_.clear();
  }
  waiting_.notify_all();
  for (const auto& [id, call] : left) call->context().cancellation().Cancel();
  for (std::thread& thread : threads_) thread.join();
}

void Server::SendLine(const std::string& line) {
  const std::lock_guard lock(send_mutex_);
  send_(line);
}

void Server::ReceiveTooLong() {
  SendLine(FaultLine({kInvalidRequest, fmt::format("a line is longer than {} MiB", kMostLineBytes >> 20), {}, {}}));
}

void Server::Receive(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) return;
  const auto read = ReadMessage(line);
  if (const Fault* fault = std::get_if<Fault>(&read)) return SendLine(FaultLine(*fault));
  const Message* message = std::get_if<Message>(&read);
  if (message == nullptr) return;
  if (message->id.is_null()) {
    if (message->method == "notifications/cancelled") Cancel(message->params);
    return;
  }
  Answer answer = Handle(*message);
  if (Json* result = std::get_if<Json>(&answer)) SendLine(ResultLine(message->id, std::move(*result)));
  if (Fault* fault = std::get_if<Fault>(&answer)) {
    fault->id = message->id;
    SendLine(FaultLine(*fault));
  }
}

std::variant<bool, Fault> Server::ReadRevision(const Message& request) const {
  const Json meta = MetaOf(request.params);
  const auto version = meta.find(kVersionKey);
  if (version == meta.end()) {
    if (request.method != "server/discover") return false;
    return Fault{kInvalidParams, fmt::format("_meta.{}: is missing", kVersionKey), {}, {}};
  }
  if (*version != kModernVersion) {
    const Json supported = {{"supported", Json::array({kModernVersion})}, {"requested", *version}};
    return Fault{kUnsupportedVersion, "Unsupported protocol version", supported, {}};
  }
  if (!meta.value(kCapabilitiesKey, Json()).is_object()) {
    return Fault{kInvalidParams, fmt::format("_meta.{}: must be an object", kCapabilitiesKey), {}, {}};
  }
  return true;
}

Server::Answer Server::Handle(const Message& request) {
  const auto revision = ReadRevision(request);
  if (const Fault* fault = std::get_if<Fault>(&revision)) return *fault;
  const bool modern = std::get<bool>(revision);
  const std::string& method = request.method;
  const Json token = MetaOf(request.params).value("progressToken", Json());
  if (!token.is_null() && !token.is_string() && !token.is_number_integer()) {
    return Fault{kInvalidParams, "_meta.progressToken: must be a string or a whole number", {}, {}};
  }
  if (modern) {
    if (method == "server/discover") {
      return Complete({{"supportedVersions", Json::array({kModernVersion})},
                       {"capabilities", Capabilities()},
                       {"instructions", offer_.instructions}},
                      true, kListTtl_ms);
    }
    if (method == "subscriptions/listen") return Listen(request);
  } else {
    if (method == "initialize") return Initialize(request.params);
    if (method == "ping") return Json::object();
    if (!initialized_) {
      return Fault{kInvalidRequest, "initialize comes first, or a revision of the protocol in _meta", {}, {}};
    }
  }
  if (method == "tools/list" || method == "resources/list" || method == "resources/templates/list") {
    return List(method, request.params, modern);
  }
  if (method == "tools/call" || method == "resources/read") return StartCall(request, modern);
  return Fault{kMethodNotFound, fmt::format("there is no method \"{}\" here", method.substr(0, 80)), {}, {}};
}

Server::Answer Server::Initialize(const Json& params) {
  if (initialized_) return Fault{kInvalidRequest, "initialize: has been done", {}, {}};
  const auto asked = params.find("protocolVersion");
  if (asked == params.end() || !asked->is_string()) {
    return Fault{kInvalidParams, "protocolVersion: must be a string", {}, {}};
  }
  if (!params.value("capabilities", Json()).is_object() || !params.value("clientInfo", Json()).is_object()) {
    return Fault{kInvalidParams, "capabilities, clientInfo: must be objects", {}, {}};
  }
  const bool known = std::ranges::find(kHandshakeVersions, asked->get<std::string>()) != std::end(kHandshakeVersions);
  initialized_ = true;
  return Json{{"protocolVersion", known ? asked->get<std::string>() : kHandshakeVersions[0]},
              {"capabilities", Capabilities()},
              {"serverInfo", offer_.server_info},
              {"instructions", offer_.instructions}};
}

Server::Answer Server::List(const std::string& method, const Json& params, bool modern) const {
  if (params.contains("cursor")) return Fault{kInvalidParams, "cursor: is not one of ours", {}, {}};
  if (method == "tools/list") {
    Json tools = Json::array();
    for (const Tool& tool : offer_.tools) tools.push_back(tool.listed);
    return Complete({{"tools", std::move(tools)}}, modern, kListTtl_ms);
  }
  if (method == "resources/templates/list") {
    return Complete({{"resourceTemplates", offer_.resources.templates}}, modern, kListTtl_ms);
  }
  absl::StatusOr<Json> listed = offer_.resources.list();
  if (!listed.ok()) return Fault{kInternalError, std::string(listed.status().message()), {}, {}};
  return Complete({{"resources", *std::move(listed)}}, modern, 0);
}

Server::Answer Server::StartCall(const Message& request, bool modern) {
  const Json& params = request.params;
  if (request.method == "resources/read") {
    if (!params.value("uri", Json()).is_string()) return Fault{kInvalidParams, "uri: must be a string", {}, {}};
  } else {
    const Json name = params.value("name", Json());
    if (!name.is_string()) return Fault{kInvalidParams, "name: must be a string", {}, {}};
    const auto has_name = [&](const Tool& tool) { return tool.listed.at("name") == name; };
    if (std::ranges::none_of(offer_.tools, has_name)) {
      return Fault{kInvalidParams, "Unknown tool: " + name.get<std::string>().substr(0, 80), {}, {}};
    }
    if (!params.value("arguments", Json::object()).is_object()) {
      return Fault{kInvalidParams, "arguments: must be an object", {}, {}};
    }
  }
  return Start(std::make_shared<Call>(*this, request, modern), true);
}

Server::Answer Server::Start(std::shared_ptr<Call> call, bool queued) {
  {
    const std::lock_guard lock(mutex_);
    if (calls_.size() >= kMostCalls) {
      return Fault{kInternalError, fmt::format("{} calls are running or waiting; try again later", kMostCalls), {}, {}};
    }
    if (!calls_.emplace(call->key(), call).second) {
      return Fault{kInvalidRequest, "id: a request with the same one has not been answered yet", {}, {}};
    }
    if (queued) queue_.push_back(std::move(call));
  }
  waiting_.notify_one();
  return std::monostate();
}

// Nothing of ours is told without being asked, so that the stream stays silent until the client ends it.
Server::Answer Server::Listen(const Message& request) {
  if (!request.params.value("notifications", Json()).is_object()) {
    return Fault{kInvalidParams, "notifications: must be an object", {}, {}};
  }
  Answer answer = Start(std::make_shared<Call>(*this, request, true), false);
  if (std::holds_alternative<std::monostate>(answer)) {
    SendLine(NotificationLine("notifications/subscriptions/acknowledged",
                              {{"_meta", {{kSubscriptionKey, request.id}}}, {"notifications", Json::object()}}));
  }
  return answer;
}

void Server::Cancel(const Json& params) {
  std::shared_ptr<Call> call;
  {
    const std::lock_guard lock(mutex_);
    const auto found = calls_.find(params.value("requestId", Json()).dump());
    if (found == calls_.end()) return;
    call = found->second;
    calls_.erase(found);
    std::erase(queue_, call);
  }
  call->context().cancellation().Cancel();
}

void Server::Work() {
  while (true) {
    std::shared_ptr<Call> call;
    {
      std::unique_lock lock(mutex_);
      waiting_.wait(lock, [this] { return closing_ || !queue_.empty(); });
      if (closing_) return;
      call = std::move(queue_.front());
      queue_.pop_front();
    }
    const Json& id = call->request().id;
    std::string line;
    if (call->request().method == "tools/call") {
      line = ResultLine(id, RunTool(*call));
    } else {
      std::variant<Json, Fault> read = ReadResource(*call);
      Fault* fault = std::get_if<Fault>(&read);
      if (fault != nullptr) fault->id = id;
      line = fault != nullptr ? FaultLine(*fault) : ResultLine(id, std::get<Json>(std::move(read)));
    }
    if (Finish(*call)) SendLine(line);
  }
}

bool Server::Finish(const Call& call) {
  const std::lock_guard lock(mutex_);
  const auto found = calls_.find(call.key());
  if (found == calls_.end() || found->second.get() != &call) return false;
  calls_.erase(found);
  return true;
}

Json Server::RunTool(Call& call) const {
  const Json& params = call.request().params;
  Json arguments = params.value("arguments", Json::object());
  // Models write null for what they leave out.
  std::erase_if(arguments.get_ref<Json::object_t&>(), [](const auto& member) { return member.second.is_null(); });
  const auto tool =
      std::ranges::find_if(offer_.tools, [&](const Tool& each) { return each.listed.at("name") == params.at("name"); });
  const auto run = [&]() -> absl::StatusOr<ToolResult> {
    RETURN_IF_ERROR(CheckAgainst(tool->listed.at("inputSchema"), arguments));
    return tool->run(arguments, call);
  };
  absl::StatusOr<ToolResult> result = run();
  if (!result.ok()) {
    const Json text = {{"type", "text"}, {"text", std::string(result.status().message())}};
    return Complete({{"content", Json::array({text})}, {"isError", true}}, call.modern());
  }
  if (result->content.empty()) {
    result->content.push_back(
        {{"type", "text"}, {"text", result->structured.dump(-1, ' ', false, Json::error_handler_t::replace)}});
  }
  return Complete({{"content", std::move(result->content)},
                   {"structuredContent", std::move(result->structured)},
                   {"isError", false}},
                  call.modern());
}

std::variant<Json, Fault> Server::ReadResource(Call& call) const {
  const std::string uri = call.request().params.at("uri").get<std::string>();
  absl::StatusOr<Json> read = offer_.resources.read(uri, call.context());
  if (read.ok()) return Complete({{"contents", Json::array({*std::move(read)})}}, call.modern(), 0);
  const std::string message(read.status().message());
  if (absl::IsNotFound(read.status()) || absl::IsInvalidArgument(read.status())) {
    return Fault{call.modern() ? kInvalidParams : kResourceNotFound, message, {{"uri", uri.substr(0, 200)}}, {}};
  }
  return Fault{kInternalError, message, {}, {}};
}

Json Server::Complete(Json result, bool modern, std::optional<int> ttl_ms) const {
  if (!modern) return result;
  result["resultType"] = "complete";
  result["_meta"][kServerKey] = offer_.server_info;
  if (ttl_ms.has_value()) {
    result["ttlMs"] = *ttl_ms;
    result["cacheScope"] = *ttl_ms > 0 ? "public" : "private";
  }
  return result;
}

}  // namespace flair::cli::mcp
