// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::cli {

// All of package flair.v1 as a page in GitHub's Markdown: docs/protocol.md. Every name of the package is a link.
std::string ProtocolMarkdown();

}  // namespace flair::cli
