// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/site.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

constexpr int64_t kMostBytes = int64_t{64} << 20;
constexpr size_t kHashLength = 8;
constexpr char kNoPage[] =
    "The page of the studio has not been built.\n\n"
    "In a checkout, ./flair studio builds it; it needs Node.js 18 or later. Then open this address again.\n";

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kMediaTypes = {{
    {"", "text/plain; charset=utf-8"},
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".webmanifest", "application/manifest+json"},
    {".txt", "text/plain; charset=utf-8"},
    {".md", "text/plain; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".webp", "image/webp"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".glb", "model/gltf-binary"},
}};

std::string MediaType(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto* const found = std::ranges::find(kMediaTypes, extension, [](const auto& entry) { return entry.first; });
  return std::string(found == kMediaTypes.end() ? "application/octet-stream" : found->second);
}

bool IsHashed(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  if (stem.size() < kHashLength + 2 || stem[stem.size() - kHashLength - 1] != '-') return false;
  return std::all_of(stem.end() - kHashLength, stem.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
}

std::string_view Trimmed(absl::string_view text) {
  const absl::string_view trimmed = absl::StripAsciiWhitespace(text);
  return {trimmed.data(), trimmed.size()};
}

bool TakesGzip(std::string_view accept_encoding) {
  for (const absl::string_view one :
       absl::StrSplit(absl::string_view(accept_encoding.data(), accept_encoding.size()), ',')) {
    const std::vector<std::string> parts = absl::StrSplit(one, ';');
    if (Trimmed(parts[0]) != "gzip") continue;
    // "gzip;q=0" refuses it.
    return parts.size() == 1 || Trimmed(parts[1]).find_first_of("123456789") != std::string_view::npos;
  }
  return false;
}

bool Names(std::string_view if_none_match, std::string_view etag) {
  for (const absl::string_view one :
       absl::StrSplit(absl::string_view(if_none_match.data(), if_none_match.size()), ',')) {
    std::string_view tag = Trimmed(one);
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    if (tag == etag || tag == "*") return true;
  }
  return false;
}

absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return Unavailable("{}: cannot be read", path.string());
  return bytes;
}

// Regular files below the folder, by their path in it.
absl::StatusOr<std::map<std::string, std::string>> ReadFolder(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  std::error_code error;
  int64_t total = 0;
  for (std::filesystem::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::filesystem::path& path = at->path();
    if (path.filename().string().starts_with(".")) {
      at.disable_recursion_pending();
      continue;
    }
    std::error_code unreadable;
    if (at->is_symlink(unreadable) || !at->is_regular_file(unreadable)) continue;
    total += static_cast<int64_t>(at->file_size(unreadable));
    if (unreadable) return Unavailable("{}: {}", path.string(), unreadable.message());
    if (total > kMostBytes)
      return ResourceExhausted("{}: more than 64 MiB of files; is it a built page?", folder.string());
    ASSIGN_OR_RETURN(contents["/" + path.lexically_relative(folder).generic_string()], ReadFile(path));
  }
  if (error) return Unavailable("{}: {}", folder.string(), error.message());
  return contents;
}

}  // namespace

absl::StatusOr<Site> Site::Read(const std::filesystem::path& folder) {
  Site site;
  std::error_code ignored;
  if (folder.empty() || !std::filesystem::is_directory(folder, ignored)) return site;
  ASSIGN_OR_RETURN(auto contents, ReadFolder(folder));
  for (auto& [path, bytes] : contents) {
    if (path.ends_with(".gz") && contents.contains(path.substr(0, path.size() - 3))) continue;
    File& file = site.files_[path];
    file.media_type = MediaType(path);
    file.hashed = IsHashed(path);
    // Of both forms: either may change alone.
    const auto gzipped = contents.find(path + ".gz");
    if (gzipped != contents.end()) file.gzipped = gzipped->second;
    file.etag = runtime::Sha256Hex(bytes + file.gzipped).substr(0, 32);
    file.bytes = std::move(bytes);
  }
  return site;
}

Reply Site::Get(std::string_view path, std::string_view accept_encoding, std::string_view if_none_match) const {
  const auto found = files_.find(path == "/" ? std::string_view("/index.html") : path);
  if (found == files_.end()) return TextReply(path == "/" ? 503 : 404, path == "/" ? kNoPage : "Not found.\n");
  const File& file = found->second;
  const bool gzip = !file.gzipped.empty() && TakesGzip(accept_encoding);
  const std::string etag = fmt::format("\"{}{}\"", file.etag, gzip ? "-gz" : "");
  Reply reply;
  reply.headers = {{"Content-Type", file.media_type},
                   {"ETag", etag},
                   {"Vary", "Accept-Encoding"},
                   {"Cache-Control", file.hashed ? "private, max-age=31536000, immutable" : "private, no-cache"}};
  if (Names(if_none_match, etag)) {
    reply.status = 304;
    return reply;
  }
  if (gzip) reply.headers.emplace_back("Content-Encoding", "gzip");
  reply.file = gzip ? file.gzipped : file.bytes;
  return reply;
}

}  // namespace flair::studio
