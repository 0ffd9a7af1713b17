// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/limited_json.h"

#include <cmath>
#include <exception>
#include <string>

#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/nests_within.h"

namespace flair::renderer {
namespace {

using Json = nlohmann::json;

constexpr int kMaxDepth = 64;

}  // namespace

absl::StatusOr<Json> ParseLimitedJson(std::string_view text) {
  if (!NestsWithin(text, kMaxDepth)) return InvalidArgument("JSON is more than {} levels deep", kMaxDepth);
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const std::exception& failure) {
    return absl::InvalidArgumentError(failure.what());
  }
}

const Json* Find(const Json& json, const char* name) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(name);
  return found == json.end() ? nullptr : &*found;
}

const Json& ArrayOf(const Json& json, const char* name) {
  static const Json& nothing = *new Json(Json::array());
  const Json* found = Find(json, name);
  return found != nullptr && found->is_array() ? *found : nothing;
}

std::string_view TextOf(const Json& json, const char* name) {
  const Json* found = Find(json, name);
  return found != nullptr && found->is_string() ? std::string_view(found->get_ref<const std::string&>())
                                                : std::string_view();
}

std::optional<size_t> CountOf(const Json& json, const char* name) {
  constexpr double kMost = 9007199254740992.0;
  const Json* found = Find(json, name);
  if (found == nullptr || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  if (!(value >= 0) || value > kMost || value != std::floor(value)) return std::nullopt;
  return static_cast<size_t>(value);
}

std::optional<double> NumberOf(const Json& json, const char* name) {
  const Json* found = Find(json, name);
  if (found == nullptr || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace flair::renderer
