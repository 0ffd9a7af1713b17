// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "fmt/format.h"

namespace flair::orchestrator {

// Items of a page for a page_size of a request. INVALID_ARGUMENT when out of range.
inline absl::StatusOr<int> PageLimit(int page_size) {
  if (page_size < 0 || page_size > 1000) {
    return absl::InvalidArgumentError(fmt::format("page_size: {} is out of range [0, 1000]", page_size));
  }
  return page_size == 0 ? 50 : page_size;
}

// The answer whose `field` (Response& to the repeated field) has the first `limit` of the items; one more than these
// says that there is another page.
template <typename Response, typename Item, typename Field>
Response PageOf(std::vector<Item> items, int limit, const Field& field) {
  Response response;
  if (static_cast<int>(items.size()) > limit) {
    items.resize(static_cast<size_t>(limit));
    response.set_next_page_token(items.back().id());
  }
  field(response)->Assign(items.begin(), items.end());
  return response;
}

}  // namespace flair::orchestrator
