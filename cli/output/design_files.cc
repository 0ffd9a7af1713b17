// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/design_files.h"

#include <string_view>

#include "absl/strings/ascii.h"
#include "cli/output/artifact_text.h"

namespace flair::cli {
namespace {

// "plan.png", "birdseye.exr".
std::string NameOf(v1::PreviewView view, v1::PreviewFormat format) {
  constexpr std::string_view kView = "PREVIEW_VIEW_";
  constexpr std::string_view kFormat = "PREVIEW_FORMAT_";
  return absl::AsciiStrToLower(v1::PreviewView_Name(view).substr(kView.size()) + "." +
                               v1::PreviewFormat_Name(format).substr(kFormat.size()));
}

}  // namespace

std::string PictureName(const v1::Preview& preview) {
  const bool known = preview.view() != v1::PREVIEW_VIEW_UNSPECIFIED && v1::PreviewView_IsValid(preview.view()) &&
                     preview.format() != v1::PREVIEW_FORMAT_UNSPECIFIED && v1::PreviewFormat_IsValid(preview.format());
  return known ? NameOf(preview.view(), preview.format()) : "plan.png";
}

std::vector<std::string> DesignFileNames() {
  std::vector<std::string> names = {"report.md"};
  for (int view = v1::PREVIEW_VIEW_PLAN; view < v1::PreviewView_ARRAYSIZE; ++view) {
    for (int format = v1::PREVIEW_FORMAT_PNG; format < v1::PreviewFormat_ARRAYSIZE; ++format) {
      names.push_back(NameOf(static_cast<v1::PreviewView>(view), static_cast<v1::PreviewFormat>(format)));
    }
  }
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    if (stem.empty()) continue;
    names.push_back(stem + ".pb");
    names.push_back(stem + ".json");
  }
  return names;
}

std::vector<OutputFile> MakeDesignFiles(const v1::Job& job, const ArtifactsByKind& artifacts) {
  std::vector<OutputFile> files;
  for (const auto& [kind, artifact] : artifacts) {
    if (artifact.has_preview()) files.push_back({PictureName(artifact.preview()), artifact.preview().image()});
    const std::string stem = FileStem(kind);
    if (stem.empty()) continue;
    files.push_back({stem + ".pb", ArtifactBytes(artifact)});
    files.push_back({stem + ".json", ToJson(artifact)});
  }
  files.push_back({"report.md", WriteReport(job, artifacts)});
  return files;
}

}  // namespace flair::cli
