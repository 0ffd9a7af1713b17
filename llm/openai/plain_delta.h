// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace flair::llm {

// The piece of text in a chunk of a stream that brings nothing else, as nearly all of the hundreds of a reply do: the
// JSON string of choices[0].delta.content, with its quotation marks. None when the chunk may bring anything more, or is
// not JSON; then it must be parsed. Takes a twentieth of the time of parsing; what it skips is not checked.
std::optional<std::string_view> PlainDelta(std::string_view chunk);

// The text of such a string that holds neither escapes nor anything but ASCII; none when it does.
std::optional<std::string_view> PlainText(std::string_view json_string);

}  // namespace flair::llm
