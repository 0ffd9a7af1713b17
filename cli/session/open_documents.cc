// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/open_documents.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <vector>

#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "cli/embedded/embedded_services.h"
#include "cli/explain/layout_note.h"
#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/session/furniture_offers.h"
#include "cli/session/session.h"
#include "fmt/format.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "llm/config/check_llm_config.h"
#include "session/sentences/designer_sentences.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

absl::StatusOr<v1::Artifact> ReadUpload(const std::string& bytes) {
  // Its ending is not known: the bytes say what it is.
  ASSIGN_OR_RETURN(ArtifactFile file, ParseArtifactFile("file", bytes));
  RETURN_IF_ERROR(file.whole);
  RETURN_IF_ERROR(file.good);
  return std::move(file.artifact);
}

absl::StatusOr<session::DocumentParts> Parts(const StageChoice& stages) {
  session::DocumentParts parts;
  const std::vector<std::filesystem::path> overlays(stages.handbooks.begin(), stages.handbooks.end());
  ASSIGN_OR_RETURN(std::shared_ptr<const language::Handbook> handbook,
                   language::LoadHandbook(language::DefaultHandbookFolder(), overlays));
  ASSIGN_OR_RETURN(parts.furniture, FurnitureOffers(stages.asset_folder, *handbook));
  parts.furniture_words = FurnitureWords(*handbook, parts.furniture);
  parts.sentences_of = session::SentencesOfHandbook(std::move(handbook));
  parts.read_file = ReadUpload;
  parts.not_as_asked = NotAsAsked;
  parts.note_json = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteJson(note);
  };
  parts.note_text = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteText(note, {.all = true, .ids = false});
  };
  return parts;
}

// Jobs of one orchestrator mean nothing to another.
std::string FolderFor(const std::string& address) {
  if (address.empty()) return DefaultStorePath() + "/documents";
  return DefaultStorePath() + "/documents_at_" + absl::StrReplaceAll(address, {{"/", "_"}});
}

// A file of this process's memory that holds a secret, for those who read keys from files; open until the process ends.
absl::StatusOr<std::string> InMemory(const std::string& secret) {
  const int file = ::memfd_create("flair-key", MFD_CLOEXEC);
  if (file < 0 || WriteAll(file, secret) != 0) return absl::InternalError("no memory for the key");
  return fmt::format("/proc/self/fd/{}", file);
}

// "http://127.0.0.1:11434/v1" leads to "127.0.0.1:11434".
std::string HostOf(std::string_view url) {
  const size_t scheme = url.find("://");
  url.remove_prefix(scheme == std::string_view::npos ? 0 : scheme + 3);
  url = url.substr(0, url.find_first_of("/?#"));
  return std::string(url.substr(url.rfind('@') + 1));
}

// How the model is asked. A page may name servers of this machine, and the one that the program was started with: what
// it shows may come from others.
absl::StatusOr<config::v1::LlmConfig> ModelConfig(const v1::ModelChoice& choice, const OptionalLlm& first) {
  config::v1::LlmConfig config;
  const std::string host = HostOf(choice.base_url());
  if (first.has_value() && HostOf(first->base_url()) == host) {
    config = *first;
  } else if (const bool has_port = host.rfind(':') != std::string::npos && !host.ends_with(']');
             !runtime::IsLocalAddress(has_port ? host : host + ":80")) {
    return InvalidArgument(
        "model.base_url: {} is on another machine; start the studio with --base-url {} to allow that",
        choice.base_url(), choice.base_url());
  }
  config.set_base_url(choice.base_url());
  config.set_model(choice.model());
  if (!choice.api_key().empty()) {
    config.clear_api_key_env();
    ASSIGN_OR_RETURN(*config.mutable_api_key_path(), InMemory(choice.api_key()));
  }
  std::vector<std::string> problems;
  llm::CheckLlmConfig(config, [&problems](std::string_view field, std::string_view problem) {
    problems.push_back(fmt::format("model.{}: {}", field, problem));
  });
  if (!problems.empty()) return absl::InvalidArgumentError(absl::StrJoin(problems, "; "));
  return config;
}

int stop_pipe[2] = {-1, -1};
void OnStop(int) {
  const ssize_t ignored = ::write(stop_pipe[1], "s", 1);
  (void)ignored;
}

}  // namespace

OpenDocuments::OpenDocuments(const OptionalLlm& llm, const StageChoice& stages) : first_llm_(llm), stages_(stages) {}
OpenDocuments::~OpenDocuments() = default;

absl::StatusOr<session::Channels> OpenDocuments::StartServices(const OptionalLlm& llm) {
  ASSIGN_OR_RETURN(std::unique_ptr<EmbeddedServices> services,
                   EmbeddedServices::Start(DefaultStorePath(), llm, stages_));
  const orchestrator::StageChannels& own = services->stages();
  session::Channels channels = {.orchestrator = services->orchestrator(),
                                .translator = own.translator.channel,
                                .optimizer = own.optimizer.channel,
                                .renderer = own.renderer.channel};
  const std::lock_guard lock(mutex_);
  embedded_.push_back(std::move(services));
  return channels;
}

absl::StatusOr<session::Channels> OpenDocuments::ChooseModel(const v1::ModelChoice& choice) {
  constexpr size_t kMostChoices = 32;
  {
    const std::lock_guard lock(mutex_);
    if (embedded_.size() >= kMostChoices) {
      return absl::ResourceExhaustedError("models have been changed too often; start the program again");
    }
  }
  if (choice.base_url().empty()) return StartServices(std::nullopt);
  ASSIGN_OR_RETURN(const config::v1::LlmConfig config, ModelConfig(choice, first_llm_));
  return StartServices(config);
}

DocumentFlags::DocumentFlags(CLI::App& command) : Options(command) {
  Bind("--assets DIR", stages.asset_folder,
       "Folder of 3D models with a manifest (docs/assets.md), to furnish with and for furniture that one of them fits");
}

absl::StatusOr<std::unique_ptr<OpenDocuments>> OpenDocuments::Open(const DocumentFlags& flags) {
  const std::string& address = flags.orchestrator;
  const StageChoice& stages = flags.stages;
  RETURN_IF_ERROR(CheckStageFlags(stages, address, flags.llm));
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadDesignModel(flags.llm, {}, address));
  std::unique_ptr<OpenDocuments> open(new OpenDocuments(llm, stages));
  session::DocumentParts parts;
  if (address.empty()) {
    // Says first what is wrong with folders.
    ASSIGN_OR_RETURN(open->channels_, open->StartServices(llm));
    ASSIGN_OR_RETURN(parts, Parts(stages));
    parts.choose_model = [self = open.get()](const v1::ModelChoice& choice) { return self->ChooseModel(choice); };
    if (llm.has_value()) {
      parts.model.set_base_url(llm->base_url());
      parts.model.set_model(llm->model());
    }
  } else {
    ASSIGN_OR_RETURN(parts, Parts(stages));
    ASSIGN_OR_RETURN(open->session_, Session::Open(address));
    RETURN_IF_ERROR(open->session_->ListJobs(1).status());
    const std::shared_ptr<grpc::Channel>& channel = open->session_->channel();
    open->channels_ = {.orchestrator = channel, .translator = channel, .optimizer = channel, .renderer = channel};
  }
  open->folder_ = FolderFor(address);
  ASSIGN_OR_RETURN(open->documents_, session::Documents::Open(open->folder_, open->channels_, std::move(parts)));
  return open;
}

absl::StatusOr<int> StopDescriptor() {
  if (stop_pipe[0] < 0) {
    if (::pipe2(stop_pipe, O_CLOEXEC) != 0) return absl::InternalError("no pipe for signals");
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, OnStop);
  }
  return stop_pipe[0];
}

}  // namespace flair::cli
