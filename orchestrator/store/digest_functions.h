// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

struct sqlite3;

namespace flair::orchestrator {

// Digests in hex as the store keeps them, in half the bytes. What is no digest (see IsArtifactId) stays as it is.
std::string DigestBytes(std::string_view hex);
// The other way.
std::string DigestHex(std::string_view bytes);

// Lets the steps of the schema call flair_digest(TEXT), which is DigestBytes, and flair_brief(BLOB), the BriefDigest of
// a serialized JobSpec. Returns SQLite's code.
int AddDigestFunctions(sqlite3* connection);

}  // namespace flair::orchestrator
