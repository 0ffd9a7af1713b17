// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_or.h"

#include <google/protobuf/descriptor.h>

#include <string>
#include <utility>

#include "cli/input/artifact_file.h"
#include "cli/input/artifact_form.h"
#include "cli/input/files.h"
#include "cli/input/json_place.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using google::protobuf::Descriptor;

// Whether a text has, outside of all others, a field that artifacts have and messages of the other type have not.
bool SeemsArtifact(ArtifactForm form, const std::string& text, const Descriptor& other) {
  const Descriptor& artifact = *v1::Artifact::descriptor();
  const size_t start = FindJsonField(text, {});
  for (int i = 0; i < artifact.field_count(); ++i) {
    const std::string& name = artifact.field(i)->name();
    if (other.FindFieldByName(name) != nullptr) continue;
    if (form == ArtifactForm::kJson && FindJsonField(text, {{name}}) != start) return true;
    for (const char* mark : {" {", "{", ":"}) {
      if (form == ArtifactForm::kProtobufText && ("\n" + text).find("\n" + name + mark) != std::string::npos)
        return true;
    }
  }
  return false;
}

}  // namespace

absl::StatusOr<bool> ReadArtifactOr(const std::filesystem::path& path, v1::Artifact& artifact,
                                    google::protobuf::Message& alone,
                                    const std::function<std::vector<validation::Problem>()>& problems) {
  const absl::StatusOr<std::string> bytes = ReadFile(path);
  if (!bytes.ok()) return bytes.status();
  const ArtifactForm form = FormOf(path, *bytes);
  const bool is_text = form != ArtifactForm::kBinary && !bytes->empty();
  if (!is_text || SeemsArtifact(form, *bytes, *alone.GetDescriptor())) {
    absl::StatusOr<v1::Artifact> read = ReadArtifact(path);
    if (read.ok()) artifact = *std::move(read);
    // Bytes that are no artifact at all may be the message.
    const bool may_be_alone = absl::IsDataLoss(read.status()) && LeadingId(*bytes).empty() && !is_text &&
                              ForeignKind(*bytes).empty() && !bytes->empty() && alone.ParseFromString(*bytes);
    if (!may_be_alone) return read.ok() ? absl::StatusOr<bool>(true) : read.status();
    if (absl::Status status = ListProblems(path.string(), problems()); !status.ok()) return status;
    return false;
  }
  const TextForm text_form = form == ArtifactForm::kJson ? TextForm::kJson : TextForm::kProtobufText;
  absl::Status status = ParseMessageText(text_form, path.string(), *bytes, alone);
  if (status.ok()) status = LocateProblems(text_form, path.string(), *bytes, alone, problems());
  if (!status.ok()) return status;
  return false;
}

}  // namespace flair::cli
