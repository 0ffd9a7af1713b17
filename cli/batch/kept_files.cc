// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/kept_files.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

constexpr char kPictures[] = "pictures";
constexpr char kReport[] = "report";
constexpr char kReportText[] = "report.md";

std::string StemOf(v1::ArtifactKind kind) { return kind == v1::ARTIFACT_KIND_REPORT ? kReport : FileStem(kind); }

// Words for one artifact each: "layout" for layout.pb, "layout.json" for layout.json.
std::vector<std::string> AllWords() {
  std::vector<std::string> words;
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    if (stem.empty()) continue;
    words.push_back(stem);
    words.push_back(stem + ".json");
  }
  words.insert(words.end(), {kPictures, kReport, kReportText});
  return words;
}

// A picture's name that no file has yet: "birdseye.png", "birdseye_2.png".
std::string FreeName(const std::string& name, const std::vector<OutputFile>& files) {
  const auto taken = [&files](const std::string& candidate) {
    return std::ranges::any_of(files, [&](const OutputFile& file) { return file.name == candidate; });
  };
  const size_t dot = name.rfind('.');
  std::string free = name;
  for (int i = 2; taken(free); ++i) free = fmt::format("{}_{}{}", name.substr(0, dot), i, name.substr(dot));
  return free;
}

}  // namespace

absl::StatusOr<KeptFiles> KeptFiles::Parse(const std::string& text) {
  const std::vector<std::string> known = AllWords();
  KeptFiles kept;
  for (const absl::string_view part : absl::StrSplit(text, ',')) {
    std::string word(absl::StripAsciiWhitespace(part));
    if (word.empty() || word == "none") continue;
    if (word == "plan" || word == "picture" || word == "plan.png") word = kPictures;
    if (word == "report.json") word = kReport;
    if (word.ends_with(".pb")) word.resize(word.size() - 3);
    if (word == "all") {
      kept.words_.insert(known.begin(), known.end());
      continue;
    }
    if (std::ranges::find(known, word) == known.end()) {
      return absl::InvalidArgumentError(fmt::format("--keep: {}: no such file{}; one of {}, all, none", word,
                                                    DidYouMean(word, known), absl::StrJoin(known, ", ")));
    }
    kept.words_.insert(word);
  }
  return kept;
}

std::string KeptFiles::Words() const { return words_.empty() ? "none" : absl::StrJoin(words_, ","); }

bool KeptFiles::Needs(v1::ArtifactKind kind) const {
  if (Has(kReportText)) return true;  // tells of all stages
  if (kind == v1::ARTIFACT_KIND_PREVIEW) return Has(kPictures);
  const std::string stem = StemOf(kind);
  return Has(stem) || Has(stem + ".json");
}

void KeptFiles::AddPicture(const v1::Preview& preview, std::vector<OutputFile>& files) const {
  if (!Has(kPictures)) return;
  const std::string name = FreeName(PictureName(preview), files);
  files.push_back({name, preview.image()});
  if (preview.has_annotations()) files.push_back({name + ".json", ToJson(preview.annotations())});
}

std::vector<OutputFile> KeptFiles::FilesOf(const v1::Job& job, const std::vector<v1::Artifact>& artifacts) const {
  std::vector<OutputFile> files;
  if (empty()) return files;
  files.push_back({"job.json", ToJson(job)});
  ArtifactsByKind by_kind;
  for (const v1::Artifact& artifact : artifacts) {
    if (artifact.has_preview()) AddPicture(artifact.preview(), files);
    const v1::ArtifactKind kind = orchestrator::KindOf(artifact);
    if (Has(kReportText)) by_kind.emplace(kind, artifact);
    const std::string stem = StemOf(kind);
    if (stem.empty()) continue;
    if (kind == v1::ARTIFACT_KIND_REPORT) {
      if (Has(kReport)) files.push_back({"report.json", ToJson(artifact)});
      continue;
    }
    if (Has(stem)) files.push_back({stem + ".pb", ArtifactBytes(artifact)});
    if (Has(stem + ".json")) files.push_back({stem + ".json", ToJson(artifact)});
  }
  if (Has(kReportText) && job.state() == v1::JOB_STATE_SUCCEEDED) {
    files.push_back({kReportText, WriteReport(job, by_kind)});
  }
  return files;
}

}  // namespace flair::cli
