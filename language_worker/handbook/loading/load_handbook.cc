// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/loading/load_handbook.h"

#include <fmt/format.h>
#include <google/protobuf/io/tokenizer.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "english/wordnet.h"
#include "language_worker/handbook/loading/handbook_files.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

namespace fs = std::filesystem;
namespace pb = google::protobuf;

// Collects what the parser of text protos finds, as "file:line:column: message".
class SyntaxFaults : public pb::io::ErrorCollector {
 public:
  SyntaxFaults(std::string file, std::vector<std::string>& lines) : file_(std::move(file)), lines_(lines) {}
  void AddError(int line, int column, const std::string& message) override {
    lines_.push_back(fmt::format("{}:{}:{}: {}", file_, line + 1, column + 1, message));
  }

 private:
  std::string file_;
  std::vector<std::string>& lines_;
};

absl::Status ReadFolder(const fs::path& folder, bool overlay, bool last, std::vector<HandbookFile>& files) {
  std::error_code error;
  const std::size_t before = files.size();
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".textproto" || !it->is_regular_file()) continue;
    std::ifstream stream(it->path(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) return absl::UnavailableError(fmt::format("cannot read handbook file {}", it->path().string()));
    HandbookFile& file = files.emplace_back();
    file.name = overlay ? it->path().generic_string() : fs::relative(it->path(), folder).generic_string();
    file.text = text.str();
    file.overlay = overlay;
    file.last = last;
  }
  if (error) return absl::NotFoundError(fmt::format("handbook folder {}: {}", folder.string(), error.message()));
  if (files.size() == before) {
    return absl::NotFoundError(fmt::format("handbook folder {} has no *.textproto files", folder.string()));
  }
  std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end(),
            [](const HandbookFile& a, const HandbookFile& b) { return a.name < b.name; });
  return absl::OkStatus();
}

// Lays the files of one folder over what is there: replaces entries of the same name, and puts all others first.
void Lay(const hb::Handbook& part, hb::Handbook& merged) {
  const pb::Descriptor& type = *hb::Handbook::descriptor();
  hb::Handbook all;
  for (int f = 0; f < type.field_count(); ++f) {
    const pb::FieldDescriptor& field = *type.field(f);
    const pb::Reflection& reflection = *merged.GetReflection();
    const bool is_message = field.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE;
    const pb::FieldDescriptor* name = is_message ? field.message_type()->FindFieldByName("name") : nullptr;
    // Lists of words of one name are one list.
    if (field.message_type() == hb::WordList::descriptor()) name = nullptr;
    for (int i = 0; i < reflection.FieldSize(part, &field); ++i) {
      if (!is_message) {
        reflection.AddString(&all, &field, reflection.GetRepeatedString(part, &field, i));
        continue;
      }
      const pb::Message& entry = reflection.GetRepeatedMessage(part, &field, i);
      pb::Message* there = nullptr;
      for (int k = 0; name != nullptr && there == nullptr && k < reflection.FieldSize(merged, &field); ++k) {
        pb::Message* other = reflection.MutableRepeatedMessage(&merged, &field, k);
        if (reflection.GetRepeatedMessage(merged, &field, k).GetReflection()->GetString(*other, name) ==
            entry.GetReflection()->GetString(entry, name)) {
          there = other;
        }
      }
      if (there == nullptr) there = reflection.AddMessage(&all, &field);
      there->CopyFrom(entry);
    }
  }
  all.MergeFrom(merged);
  merged.Swap(&all);
}

// Names the classes of the categories that sentences are about.
void NameTargets(hb::Handbook& handbook) {
  const auto name = [&handbook](hb::Relation& relation) {
    for (const std::string& category : relation.target_categories()) {
      for (const hb::Furniture& furniture : handbook.furniture()) {
        const auto& named = relation.targets();
        const bool further = std::find(named.begin(), named.end(), furniture.name()) == named.end();
        if (furniture.category() == category && further) relation.add_targets(furniture.name());
      }
    }
  };
  for (hb::Furniture& furniture : *handbook.mutable_furniture())
    std::ranges::for_each(*furniture.mutable_relations(), name);
  for (hb::GeneralRule& rule : *handbook.mutable_general_rules()) name(*rule.mutable_relation());
}

}  // namespace

absl::StatusOr<HandbookFindings> CheckHandbook(const fs::path& folder, const std::vector<fs::path>& overlays) {
  std::vector<HandbookFile> files;
  HandbookFindings findings;
  hb::Handbook merged;
  std::string digest_input;
  for (std::size_t f = 0; f <= overlays.size(); ++f) {
    const std::size_t begin = files.size();
    RETURN_IF_ERROR(ReadFolder(f == 0 ? folder : overlays[f - 1], f > 0, f == overlays.size(), files));
    hb::Handbook whole;
    for (std::size_t i = begin; i < files.size(); ++i) {
      HandbookFile& file = files[i];
      // Where a folder lies is no part of what it says.
      const std::string name = f == 0 ? file.name : fs::relative(file.name, overlays[f - 1]).generic_string();
      digest_input +=
          fmt::format("{}{}\n{}\n{}", f > 0 && i == begin ? "overlay\n" : "", name, file.text.size(), file.text);
      SyntaxFaults faults(file.name, findings.faults);
      pb::TextFormat::Parser parser;
      parser.RecordErrorsTo(&faults);
      parser.WriteLocationsTo(file.lines.get());
      if (parser.ParseFromString(file.text, &file.part)) whole.MergeFrom(file.part);
    }
    if (f == 0) {
      merged = std::move(whole);
    } else {
      Lay(whole, merged);
    }
  }
  if (findings.faults.empty()) CheckFiles(files, findings);
  if (findings.faults.empty()) {
    NameTargets(merged);
    findings.handbook =
        std::make_unique<const Handbook>(std::move(merged), runtime::Sha256Hex(digest_input).substr(0, 16));
  }
  return findings;
}

absl::StatusOr<std::unique_ptr<const Handbook>> LoadHandbook(const fs::path& folder,
                                                             const std::vector<fs::path>& overlays) {
  constexpr std::size_t kMostShown = 20;
  RETURN_IF_ERROR(english::WordNet::CheckInstalled());
  ASSIGN_OR_RETURN(HandbookFindings findings, CheckHandbook(folder, overlays));
  if (findings.handbook != nullptr) return std::move(findings.handbook);
  std::string message = "the handbook has faults:";
  for (std::size_t i = 0; i < std::min(findings.faults.size(), kMostShown); ++i) message += "\n  " + findings.faults[i];
  if (findings.faults.size() > kMostShown)
    message += fmt::format("\n  and {} more", findings.faults.size() - kMostShown);
  return absl::InvalidArgumentError(message);
}

fs::path DefaultHandbookFolder() { return runtime::InstalledFolder("handbook", FLAIR_HANDBOOK_FOLDER); }

}  // namespace flair::language
