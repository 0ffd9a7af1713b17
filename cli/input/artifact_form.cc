// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_form.h"

#include <algorithm>
#include <utility>

#include "orchestrator/store/artifact_id.h"
#include "room/validation/field.h"

namespace flair::cli {
namespace {

using std::string_view_literals::operator""sv;

constexpr size_t kLookedAt = 4096;

// Text that people write: UTF-8 without control characters but white space, as far as it is looked at.
bool IsText(std::string_view bytes) {
  size_t end = std::min(bytes.size(), kLookedAt);
  // Not in the middle of a character.
  while (end > 0 && end < bytes.size() && (static_cast<unsigned char>(bytes[end]) & 0xC0) == 0x80) --end;
  const std::string_view begin = bytes.substr(0, end);
  const bool has_control = std::any_of(begin.begin(), begin.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') || byte == 0x7f;
  });
  return !has_control && validation::CharacterCount(begin) >= 0;
}

// A comment or a field's name, then ":" or "{".
bool BeginsAsProtobufText(std::string_view bytes) {
  const size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  if (bytes[start] == '#') return !bytes.substr(start).starts_with("#!");
  size_t at = start;
  while (at < bytes.size() && ((bytes[at] >= 'a' && bytes[at] <= 'z') || bytes[at] == '_')) ++at;
  const size_t next = bytes.find_first_not_of(" \t", at);
  return at > start && next != std::string_view::npos && (bytes[next] == ':' || bytes[next] == '{');
}

}  // namespace

std::string_view LeadingId(std::string_view bytes) {
  if (bytes.size() < kLeadingIdBytes || !bytes.starts_with("\x0a\x40"sv)) return {};
  const std::string_view id = bytes.substr(2, kLeadingIdBytes - 2);
  return orchestrator::IsArtifactId(id) ? id : std::string_view{};
}

ArtifactForm FormOf(const std::filesystem::path& path, std::string_view bytes) {
  if (!LeadingId(bytes).empty()) return ArtifactForm::kBinary;
  const std::string ending = path.extension().string();
  if (ending == ".json") return ArtifactForm::kJson;
  if (ending == ".textproto" || ending == ".txtpb" || ending == ".pbtxt") return ArtifactForm::kProtobufText;
  if (!IsText(bytes)) return ArtifactForm::kBinary;
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{') return ArtifactForm::kJson;
  return BeginsAsProtobufText(bytes) ? ArtifactForm::kProtobufText : ArtifactForm::kBinary;
}

std::string ForeignKind(std::string_view bytes) {
  constexpr std::pair<std::string_view, const char*> kKinds[] = {{"\x89PNG\r\n"sv, "a PNG picture"},
                                                                 {"\xff\xd8\xff"sv, "a JPEG picture"},
                                                                 {"II*\0"sv, "a TIFF picture"},
                                                                 {"MM\0*"sv, "a TIFF picture"},
                                                                 {"\x76\x2f\x31\x01"sv, "an OpenEXR picture"},
                                                                 {"GIF8"sv, "a GIF picture"},
                                                                 {"%PDF-"sv, "a PDF document"},
                                                                 {"glTF"sv, "a GLB model"},
                                                                 {"\x7f"
                                                                  "ELF"sv,
                                                                  "a program"},
                                                                 {"\x1f\x8b"sv, "compressed with gzip"},
                                                                 {"\x28\xb5\x2f\xfd"sv, "compressed with zstd"},
                                                                 {"\xfd"
                                                                  "7zXZ"sv,
                                                                  "compressed with xz"},
                                                                 {"PK\x03\x04"sv, "a ZIP archive"},
                                                                 {"SQLite format 3"sv, "an SQLite database"},
                                                                 {"<?xml"sv, "XML"},
                                                                 {"<svg"sv, "an SVG drawing"},
                                                                 {"<!DOCTYPE"sv, "a web page"},
                                                                 {"#!"sv, "a script"}};
  for (const auto& [begin, kind] : kKinds) {
    if (bytes.starts_with(begin)) return kind;
  }
  return LeadingId(bytes).empty() && !bytes.empty() && IsText(bytes) ? "text" : "";
}

}  // namespace flair::cli
