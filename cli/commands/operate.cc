// SPDX-License-Identifier: GPL-3.0-or-later
// flair doctor, flair health, flair token: for those who run servers.
#include <google/protobuf/stubs/common.h>
#include <google/protobuf/text_format.h>
#include <grpcpp/grpcpp.h>
#include <nlopt.h>
#include <sqlite3.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/time/clock.h"
#include "cli/commands/commands.h"
#include "cli/contract/target.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/input/options.h"
#include "cli/input/service_flags.h"
#include "cli/output/output_folder.h"
#include "cli/session/session.h"
#include "cli/session/stage_calls.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "flair/config/v1/token_list.pb.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "google/protobuf/text_format.h"
#include "llm/make_llm_client.h"
#include "nlohmann/json.hpp"
#include "orchestrator/access/access_control.h"
#include "room/conversion/conversion.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

using config::v1::LlmConfig;

constexpr absl::Duration kAnswerWithin = absl::Seconds(60);
// Models that think before they answer need some room for it.
constexpr int kMostTokens = 1000;

// Which of the forms are to be tried.
std::vector<config::v1::AnswerForm> Forms(const LlmConfig& config) {
  if (config.answer_form() != config::v1::ANSWER_FORM_UNSPECIFIED) return {config.answer_form()};
  return {config::v1::ANSWER_FORM_JSON_SCHEMA, config::v1::ANSWER_FORM_JSON_OBJECT, config::v1::ANSWER_FORM_TEXT};
}

std::string_view FormText(config::v1::AnswerForm form) {
  switch (form) {
    case config::v1::ANSWER_FORM_JSON_SCHEMA:
      return "takes JSON schemas";
    case config::v1::ANSWER_FORM_JSON_OBJECT:
      return "takes JSON mode";
    default:
      return "takes neither JSON schemas nor JSON mode: plain text";
  }
}

// Some servers take a schema and ignore it; answers are then read as text would be.
std::string_view FollowedText(const std::string& text) {
  return nlohmann::json::parse(text, nullptr, false).is_object() ? "" : " (but this answer was not JSON alone)";
}

llm::ChatRequest TinyQuestion() {
  llm::ChatRequest request;
  request.step = "doctor";
  request.messages = {{llm::Role::kUser, "Answer with the JSON object {\"ready\":true} and nothing else."}};
  request.schema =
      R"({"type":"object","properties":{"ready":{"type":"boolean"}},"required":["ready"],"additionalProperties":false})";
  request.schema_name = "doctor_answer";
  request.max_output_token_count = kMostTokens;
  return request;
}

std::string RemedyFor(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kUnauthenticated:
    case absl::StatusCode::kPermissionDenied:
      return "Check the key: api_key_env or api_key_path names where it is.";
    case absl::StatusCode::kNotFound:
      return "Check model and base_url; the latter ends before /chat/completions.";
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kDeadlineExceeded:
      return "Check base_url and proxy, and whether the server is running.";
    default:
      return "docs/models.md has a config for each kind of server.";
  }
}

absl::StatusOr<llm::ChatAnswer> AskOnce(LlmConfig config, config::v1::AnswerForm form) {
  config.clear_record_path();
  config.clear_replay_path();
  config.clear_cache_path();
  config.mutable_retry()->set_attempt_limit(1);
  config.set_answer_form(form);
  config::v1::RuntimeConfig quiet;
  quiet.set_log_level("error");
  runtime::WorkerResources resources("flair-doctor", quiet);
  ASSIGN_OR_RETURN(std::unique_ptr<llm::LlmClient> client, llm::MakeLlmClient(config, resources.context()));
  runtime::CallContext call("doctor", absl::Now() + kAnswerWithin, resources.context().clock);
  return client->Ask(TinyQuestion(), call);
}

// Asks the server of `config` once in each form of answers until one is accepted: with a JSON schema, in JSON mode, as
// text; only in the configured one if there is one. Neither records nor replays nor caches. Says who answered, in which
// form, for how many tokens; never a key.
absl::StatusOr<std::string> AskModel(const LlmConfig& config) {
  absl::Status status;
  for (const config::v1::AnswerForm form : Forms(config)) {
    const absl::StatusOr<llm::ChatAnswer> answer = AskOnce(config, form);
    if (answer.ok()) {
      const bool keyed = !config.api_key_env().empty() || !config.api_key_path().empty();
      return fmt::format("{} answers{}, {}{}; {} + {} tokens", answer->model, keyed ? ", the key is accepted" : "",
                         FormText(form), FollowedText(answer->text), answer->usage.input_token_count,
                         answer->usage.output_token_count);
    }
    status = answer.status();
    // Only what the server does not take may be taken in another form.
    if (!absl::IsInvalidArgument(status)) break;
  }
  return status;
}

absl::StatusOr<std::string> Model(const OptionalLlm& llm) {
  if (!llm.has_value()) return "none configured: the handbook designs, no key and no network needed";
  if (!llm->replay_path().empty()) return fmt::format("replayed from {}, nothing to ask", llm->replay_path());
  return AskModel(*llm);
}

std::string Libraries() {
  int major = 0, minor = 0, patch = 0;
  nlopt_version(&major, &minor, &patch);
  const int protobuf = GOOGLE_PROTOBUF_VERSION;
  return fmt::format("gRPC {}, protobuf {}.{}.{}, NLopt {}.{}.{}, SQLite {}", grpc::Version(), protobuf / 1000000,
                     protobuf / 1000 % 1000, protobuf % 1000, major, minor, patch, sqlite3_libversion());
}

absl::StatusOr<std::string> Store() {
  const std::string store = DefaultStorePath();
  if (const std::error_code error = runtime::MakePrivateFolder(store)) {
    return FileError("{}: {}", store, error.message());
  }
  RETURN_IF_ERROR(CheckOutputFolder(std::filesystem::path(store) / "probe", {}));
  return store + " can be written";
}

absl::StatusOr<std::string> Fonts() {
  if (std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")) return "DejaVu Sans";
  return absl::NotFoundError("DejaVu Sans is missing; labels will look different or be missing");
}

// Asks for the room of a brief, which reads all of the handbook.
absl::StatusOr<std::string> Handbook() {
  ASSIGN_OR_RETURN(const std::unique_ptr<EmbeddedServices> services, EmbeddedServices::StartStages());
  const auto stub = v1::LanguageService::NewStub(services->stages().language.channel);
  v1::DescribeRoomRequest request;
  request.set_request_id("doctor");
  request.mutable_brief()->set_text("A bedroom that is 4m x 5m.");
  runtime::CallContext call;
  ASSIGN_OR_RETURN(const v1::DescribeRoomResponse response,
                   runtime::UnaryRequest(*stub, &v1::LanguageService::StubInterface::DescribeRoom, request, call,
                                         absl::Now() + absl::Seconds(20)));
  return response.producer().method() + " " + response.producer().version().substr(0, 12);
}

// Draws a room with a table, which loads the image writer.
absl::StatusOr<std::string> Pictures() {
  v1::RenderRequest request;
  google::protobuf::TextFormat::ParseFromString(
      R"(request_id: "doctor" options { size_px: 256 }
         solved_layout {
           graph {
             zone_plan { zones { id: "all" name: "all" } }
             object_list { objects { id: "table" name: "table" role: OBJECT_ROLE_PRIMARY kind: OBJECT_KIND_FLOOR
                                     zone_id: "all" width_m: 1 depth_m: 1 height_m: 0.75 } }
           }
           placements { object_id: "table" x_m: 1.5 y_m: 1.5 }
         })",
      &request);
  v1::Room& room = *request.mutable_solved_layout()->mutable_graph()->mutable_room();
  room = RoomToProto(RectangularRoom(3, 3));
  room.set_room_type("room");
  ASSIGN_OR_RETURN(const std::unique_ptr<RendererClient> renderer, RendererClient::Open({}));
  ASSIGN_OR_RETURN(const v1::RenderResponse response, renderer->Render(request));
  return fmt::format("drew {} bytes of PNG", response.preview().image().size());
}

absl::StatusOr<std::string> Server(const std::string& address) {
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
  ASSIGN_OR_RETURN(const auto channel, runtime::MakeChannel(address, v1::WorkerService::service_full_name(), options));
  const auto stub = v1::WorkerService::NewStub(channel);
  runtime::CallContext call;
  const auto worker = runtime::UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(),
                                            call, absl::Now() + absl::Seconds(5));
  if (absl::IsUnimplemented(worker.status())) {
    return "a gRPC server answers, without WorkerService; see: flair contract --help";
  }
  if (!worker.ok()) return worker.status();
  if (const std::string fault = runtime::ProtocolFault(*worker); !fault.empty()) return absl::OutOfRangeError(fault);
  const std::string build = worker->build().empty() ? "unknown" : worker->build();
  return fmt::format("{} answers, build {}{}", worker->program(), build,
                     build == runtime::BuildName() ? "" : ": another one than this program");
}

std::string RemedyForServer(const absl::Status& status) {
  if (absl::IsOutOfRange(status)) return fmt::format("Start a version of it there that speaks {}.", runtime::kProtocol);
  return "Start the program there, or check host, port and connection flags.";
}

struct DoctorArguments : Options {
  using Options::Options;
  std::vector<std::string>& addresses = List("ADDRESS HOST:PORT", "Services to check, HOST:PORT");
  LlmFlags llm{command()};
};

// What is installed, reachable and configured, and what to do about the rest.
absl::Status Examine(const DoctorArguments& arguments) {
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadLlmFlags(arguments.llm));
  int problems = 0;
  const auto tell = [&](const std::string& what, const absl::StatusOr<std::string>& found, const std::string& remedy) {
    if (found.ok()) return fmt::print("  ok       {:<12} {}\n", what, *found);
    ++problems;
    fmt::print("  problem  {:<12} {}\n{:24}{}\n", what, std::string(found.status().message()), "", remedy);
  };
  tell("program", fmt::format("flair {}, build {}", FLAIR_VERSION, runtime::BuildName()), "");
  tell("libraries", Libraries(), "");
  tell("store", Store(), "Set FLAIR_HOME to a folder that you can write.");
  tell("fonts", Fonts(), "apt-get install fonts-dejavu-core");
  tell("handbook", Handbook(), "Build again in a complete checkout: ./flair build");
  const absl::StatusOr<std::string> model = Model(llm);
  tell("model", model, RemedyFor(model.status()));
  tell("pictures", Pictures(), "apt-get install libopenimageio2.4 (or libopenimageio-dev), then ./flair build");
  for (const std::string& address : arguments.addresses) {
    const absl::StatusOr<std::string> server = Server(address);
    tell(address, server, RemedyForServer(server.status()));
  }
  if (problems == 0) return absl::OkStatus();
  return absl::InternalError(Counted(problems, "problem") + " found");
}

struct HealthArguments : Options {
  using Options::Options;
  std::string& address = Required("ADDRESS", "The server, HOST:PORT or unix:PATH");
  std::string& service =
      Text("--service", "Full name of one service, such as flair.v1.OptimizerService (the whole server)");
  double& patience_s = Decimal("--patience S", 0.1, 600, 3, "Seconds to wait for an answer, 0.1 to 600 (3)");
};

absl::Status Health(const HealthArguments& arguments) {
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
  ASSIGN_OR_RETURN(const auto channel, runtime::MakeChannel(arguments.address, arguments.service, options));
  const std::string what =
      arguments.service.empty() ? arguments.address : fmt::format("{} at {}", arguments.service, arguments.address);
  const auto health = contract::HealthOf(channel, arguments.service, absl::Seconds(arguments.patience_s));
  if (absl::IsNotFound(health.status())) {
    return NotFound("{}: the server there has no such service; is this another stage's port?", what);
  }
  if (!health.ok()) return About(what, health.status());
  if (*health != "SERVING") return Unavailable("{}: {}", what, *health);
  // Of an orchestrator that lets everybody ask, also whether its stages have workers.
  std::string away;
  if (arguments.service.empty()) {
    const auto stub = v1::OrchestratorService::NewStub(channel);
    runtime::CallContext call;
    const auto cluster =
        runtime::UnaryRequest(*stub, &v1::OrchestratorService::StubInterface::GetCluster, v1::GetClusterRequest(), call,
                              absl::Now() + absl::Seconds(arguments.patience_s));
    if (cluster.ok()) away = StagesAway(*cluster);
  }
  fmt::print("{}: {}{}\n", what, *health, away.empty() ? "" : ", but " + away);
  return absl::OkStatus();
}

constexpr size_t kTokenBytes = 32;

struct TokenArguments : Options {
  using Options::Options;
  std::string& name = Required("NAME", "Name of the caller; its jobs belong to this name");
  std::string& out =
      Text("--token-out FILE", "Write the token to a new file that only you can read, instead of the terminal");
  int& open_job_limit = Whole("--open-jobs N", 0, 1000000, 0,
                              "Maximum number of jobs that may wait or run at once, 0 to 1000000 (0: no limit)");
  int& calls_per_minute_limit =
      Whole("--calls-per-minute N", 0, 1000000, 0, "Maximum number of calls per minute, 0 to 1000000 (0: no limit)");
  bool& is_operator = Flag("--operator", "Make it an operator's token, which may see and do everything");
};

absl::StatusOr<std::string> NewToken() {
  std::array<char, kTokenBytes> bytes = {};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return absl::InternalError("the system provides no random numbers");
  }
  // What begins so is found by those who look for secrets in the wrong places.
  return "flair_" + absl::WebSafeBase64Escape(absl::string_view(bytes.data(), bytes.size()));
}

// Only its owner may read it, from the first byte on.
absl::Status WriteToken(const std::string& path, const std::string& token) {
  if (std::filesystem::exists(path)) {
    return InvalidArgument("--token-out {}: already exists; a token is never overwritten", path);
  }
  const mode_t mask = ::umask(077);
  const absl::Status status = runtime::WriteFileAtomically(path, token + "\n");
  ::umask(mask);
  return status;
}

absl::Status New(const TokenArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string token, NewToken());
  config::v1::TokenList list;
  config::v1::TokenEntry& entry = *list.add_tokens();
  entry.set_name(arguments.name);
  entry.set_sha256(runtime::Sha256Hex(token));
  if (arguments.open_job_limit != 0) entry.set_open_job_limit(arguments.open_job_limit);
  if (arguments.calls_per_minute_limit != 0) entry.set_calls_per_minute_limit(arguments.calls_per_minute_limit);
  if (arguments.is_operator) entry.set_operator_(true);
  RETURN_IF_ERROR(orchestrator::CheckTokenList(list));
  if (!arguments.out.empty()) RETURN_IF_ERROR(WriteToken(arguments.out, token));
  std::string text;
  google::protobuf::TextFormat::PrintToString(list, &text);
  fmt::print("{}", text);
  std::fflush(stdout);
  if (arguments.out.empty())
    fmt::print(stderr, "\nThe token, which is shown only once and stored nowhere:\n{}\n", token);
  return absl::OkStatus();
}

}  // namespace

void AddDoctor(const Commands& program) {
  program.Add("doctor", "Check what is installed, reachable and configured, and say how to fix the rest.", Examine,
              "Asks a configured model one short question. Exits with 0 when nothing is wrong, otherwise with 1.");
}

void AddHealth(const Commands& program) {
  program.Add("health", "Check whether a server is serving, by the gRPC health protocol.", Health,
              "Exits with 0 when it serves, with 3 when it does not or cannot be reached, with 2 when it has no such "
              "service. Works with any gRPC server that has grpc.health.v1.Health.");
}

void AddToken(const Commands& program) {
  program.Group("token", "Manage tokens for callers of an orchestrator.")
      .Add("new", "Make a token, and its entry for the file in tokens_path.", New,
           "The entry goes to standard output, the token to standard error:\n"
           "  flair token new alice --token-out alice.token >> tokens.textproto\n"
           "  flair jobs --orchestrator HOST:PORT --tls --token-file alice.token\n"
           "A running orchestrator reads the file again within seconds (docs/security.md).");
}

}  // namespace flair::cli
