// SPDX-License-Identifier: GPL-3.0-or-later

#include <google/protobuf/stubs/common.h>
#include <grpcpp/grpcpp.h>
#include <nlopt.h>
#include <sqlite3.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "CLI/CLI.hpp"
#include "absl/time/clock.h"
#include "cli/commands/commands.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/input/llm_flags.h"
#include "cli/input/service_flags.h"
#include "cli/output/output_folder.h"
#include "cli/session/stage_calls.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "llm/make_llm_client.h"
#include "nlohmann/json.hpp"
#include "room/conversion/conversion.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// What one small question to the model showed.
struct ModelFindings {
  // OK when it answered.
  absl::Status status;
  // For people: who answered, in which form, for how many tokens. Never a key.
  std::string answer;
  // What to do when it did not answer.
  std::string remedy;
};

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

// Some servers take a schema and heed it not; answers are then read as text would be.
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
// text; only in the configured one if there is one. Neither records nor replays nor caches.
ModelFindings AskModel(const LlmConfig& config) {
  ModelFindings findings;
  for (const config::v1::AnswerForm form : Forms(config)) {
    const absl::StatusOr<llm::ChatAnswer> answer = AskOnce(config, form);
    findings.status = answer.status();
    if (answer.ok()) {
      const bool keyed = !config.api_key_env().empty() || !config.api_key_path().empty();
      findings.answer = fmt::format("{} answers{}, {}{}; {} + {} tokens", answer->model,
                                    keyed ? ", the key is accepted" : "", FormText(form), FollowedText(answer->text),
                                    answer->usage.input_token_count, answer->usage.output_token_count);
      return findings;
    }
    // Only what the server does not take may be taken in another form.
    if (!absl::IsInvalidArgument(answer.status())) break;
  }
  findings.remedy = RemedyFor(findings.status);
  return findings;
}

// flair doctor: what is installed, reachable and configured, and what to do about the rest.

struct DoctorArguments {
  std::vector<std::string> addresses;
  LlmFlags llm;
};

// What was looked at, and how it is.
class Findings {
 public:
  void Good(const std::string& what, const std::string& how) { fmt::print("  ok       {:<12} {}\n", what, how); }
  void Bad(const std::string& what, const std::string& how, const std::string& remedy) {
    fmt::print("  problem  {:<12} {}\n{:24}{}\n", what, how, "", remedy);
    ++problems_;
  }
  int problems() const { return problems_; }

 private:
  int problems_ = 0;
};

void LookAtLibraries(Findings& findings) {
  int major = 0, minor = 0, patch = 0;
  nlopt_version(&major, &minor, &patch);
  const int protobuf = GOOGLE_PROTOBUF_VERSION;
  findings.Good("program", fmt::format("flair {}, build {}", FLAIR_VERSION, runtime::BuildName()));
  findings.Good("libraries", fmt::format("gRPC {}, protobuf {}.{}.{}, NLopt {}.{}.{}, SQLite {}", grpc::Version(),
                                         protobuf / 1000000, protobuf / 1000 % 1000, protobuf % 1000, major, minor,
                                         patch, sqlite3_libversion()));
}

void LookAtStore(Findings& findings) {
  const std::string store = DefaultStorePath();
  const std::string remedy = "Set FLAIR_HOME to a folder that you can write.";
  std::error_code error;
  std::filesystem::create_directories(store, error);
  if (error) return findings.Bad("store", fmt::format("{}: {}", store, error.message()), remedy);
  const absl::Status status = CheckOutputFolder(std::filesystem::path(store) / "probe", {});
  if (!status.ok()) return findings.Bad("store", std::string(status.message()), remedy);
  findings.Good("store", store + " can be written");
}

void LookAtFonts(Findings& findings) {
  constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (std::filesystem::exists(kFont)) return findings.Good("fonts", "DejaVu Sans");
  findings.Bad("fonts", "DejaVu Sans is missing; labels will look different or not be there",
               "apt-get install fonts-dejavu-core");
}

// A design of nothing: asks for the room of a brief, which reads all of the handbook.
absl::Status TryHandbook(const EmbeddedServices& services, std::string& version) {
  const auto stub = v1::LanguageService::NewStub(services.stages().language.channel);
  v1::DescribeRoomRequest request;
  request.set_request_id("doctor");
  request.mutable_brief()->set_text("A bedroom that is 4m x 5m.");
  runtime::CallContext call;
  const auto response = runtime::UnaryRequest(*stub, &v1::LanguageService::StubInterface::DescribeRoom, request, call,
                                              absl::Now() + absl::Seconds(20));
  if (response.ok()) version = response->producer().method() + " " + response->producer().version().substr(0, 12);
  return response.status();
}

void LookAtLanguage(Findings& findings) {
  const auto services = EmbeddedServices::StartStages();
  std::string version;
  const absl::Status status = services.ok() ? TryHandbook(**services, version) : services.status();
  if (!status.ok()) {
    return findings.Bad("handbook", std::string(status.message()), "Build again in a complete checkout: ./flair build");
  }
  findings.Good("handbook", version);
}

void LookAtModel(const OptionalLlm& llm, Findings& findings) {
  if (!llm.has_value()) {
    return findings.Good("model", "none configured: the handbook designs, no key and no network needed");
  }
  if (!llm->replay_path().empty()) {
    return findings.Good("model", fmt::format("replayed from {}, nothing to ask", llm->replay_path()));
  }
  const ModelFindings found = AskModel(*llm);
  if (!found.status.ok()) return findings.Bad("model", std::string(found.status.message()), found.remedy);
  findings.Good("model", found.answer);
}

// Draws an empty room, which loads the image writer.
void LookAtPictures(Findings& findings) {
  v1::RenderRequest request;
  request.set_request_id("doctor");
  v1::LayoutGraph& graph = *request.mutable_solved_layout()->mutable_graph();
  *graph.mutable_room() = RoomToProto(RectangularRoom(3, 3));
  graph.mutable_room()->set_room_type("room");
  v1::Zone& zone = *graph.mutable_zone_plan()->add_zones();
  zone.set_id("all");
  zone.set_name("all");
  v1::Object& object = *graph.mutable_object_list()->add_objects();
  object.set_id("table");
  object.set_name("table");
  object.set_role(v1::OBJECT_ROLE_PRIMARY);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_zone_id("all");
  object.set_width_m(1);
  object.set_depth_m(1);
  object.set_height_m(0.75);
  v1::Placement& placement = *request.mutable_solved_layout()->add_placements();
  placement.set_object_id("table");
  placement.set_x_m(1.5);
  placement.set_y_m(1.5);
  request.mutable_options()->set_size_px(256);
  absl::StatusOr<std::unique_ptr<RendererClient>> renderer = RendererClient::Open({});
  if (!renderer.ok()) return findings.Bad("pictures", std::string(renderer.status().message()), "./flair build");
  const absl::StatusOr<v1::RenderResponse> response = (*renderer)->Render(request);
  if (!response.ok()) {
    return findings.Bad("pictures", std::string(response.status().message()),
                        "apt-get install libopenimageio2.4 (or libopenimageio-dev), then ./flair build");
  }
  findings.Good("pictures", fmt::format("drew {} bytes of PNG", response->preview().image().size()));
}

void LookAtAddress(const std::string& address, Findings& findings) {
  const std::string remedy = "Start the program there, or check host and port.";
  const absl::StatusOr<runtime::ChannelOptions> options = StageConnection();
  if (!options.ok()) return findings.Bad(address, std::string(options.status().message()), "Correct the flag.");
  const auto channel = runtime::MakeChannel(address, v1::WorkerService::service_full_name(), *options);
  if (!channel.ok()) return findings.Bad(address, std::string(channel.status().message()), remedy);
  const auto stub = v1::WorkerService::NewStub(*channel);
  runtime::CallContext call;
  const auto worker = runtime::UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(),
                                            call, absl::Now() + absl::Seconds(5));
  if (worker.ok()) {
    if (const std::string fault = runtime::ProtocolFault(*worker); !fault.empty()) {
      return findings.Bad(address, fault,
                          fmt::format("Start a version of it there that speaks {}.", runtime::kProtocol));
    }
    const std::string build = worker->build().empty() ? "unknown" : worker->build();
    return findings.Good(address, fmt::format("{} answers, build {}{}", worker->program(), build,
                                              build == runtime::BuildName() ? "" : ": another one than this program"));
  }
  if (worker.status().code() == absl::StatusCode::kUnimplemented) {
    return findings.Good(address, "a gRPC server that does not say what it is answers; see: flair contract --help");
  }
  findings.Bad(address, std::string(worker.status().message()), remedy);
}

absl::Status Examine(const DoctorArguments& arguments) {
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadLlmFlags(arguments.llm));
  Findings findings;
  LookAtLibraries(findings);
  LookAtStore(findings);
  LookAtFonts(findings);
  LookAtLanguage(findings);
  LookAtModel(llm, findings);
  LookAtPictures(findings);
  for (const std::string& address : arguments.addresses) LookAtAddress(address, findings);
  std::fflush(stdout);
  if (findings.problems() == 0) return absl::OkStatus();
  return absl::InternalError(Counted(findings.problems(), "problem") + " found");
}

}  // namespace

void AddDoctor(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command = program.add_subcommand(
      "doctor", "Check what is installed, reachable and configured, and say how to fix the rest.");
  command->add_option("ADDRESS", arguments->addresses, "Services to look for, HOST:PORT")->type_name("HOST:PORT");
  AddLlmFlags(*command, arguments->llm);
  command->footer("Asks a configured model one tiny question. Ends with 0 when nothing is wrong, else with 1.");
  command->callback([arguments, &result] { result = Examine(*arguments); });
}

}  // namespace flair::cli
