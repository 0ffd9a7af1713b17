// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/digest_functions.h"

#include <sqlite3.h>

#include "absl/strings/escaping.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::orchestrator {
namespace {

constexpr size_t kDigestBytes = 32;

std::string_view Argument(sqlite3_value* value) {
  const void* data = sqlite3_value_blob(value);
  const int size = sqlite3_value_bytes(value);
  return data == nullptr ? "" : std::string_view(static_cast<const char*>(data), static_cast<size_t>(size));
}

void SetResult(sqlite3_context* context, const std::string& bytes) {
  sqlite3_result_blob64(context, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
}

void Digest(sqlite3_context* context, int, sqlite3_value** arguments) {
  SetResult(context, DigestBytes(Argument(arguments[0])));
}

void Brief(sqlite3_context* context, int, sqlite3_value** arguments) {
  // A damaged spec has the brief that is left of it: its job cannot be read anyway.
  v1::JobSpec spec;
  const std::string_view bytes = Argument(arguments[0]);
  (void)spec.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  SetResult(context, BriefDigest(spec));
}

}  // namespace

std::string DigestBytes(std::string_view hex) {
  return IsArtifactId(hex) ? absl::HexStringToBytes(absl::string_view(hex.data(), hex.size())) : std::string(hex);
}

std::string DigestHex(std::string_view bytes) {
  if (bytes.size() != kDigestBytes) return std::string(bytes);
  return absl::BytesToHexString(absl::string_view(bytes.data(), bytes.size()));
}

int AddDigestFunctions(sqlite3* connection) {
  constexpr int kFlags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY;
  const int code =
      sqlite3_create_function_v2(connection, "flair_digest", 1, kFlags, nullptr, Digest, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) return code;
  return sqlite3_create_function_v2(connection, "flair_brief", 1, kFlags, nullptr, Brief, nullptr, nullptr, nullptr);
}

}  // namespace flair::orchestrator
