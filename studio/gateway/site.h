// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "studio/gateway/reply.h"

namespace flair::studio {

// The built page: the files of a folder, read once. No other name exists, whatever a path says.
//   index.html        "/"
//   NAME-HASH.EXT     HASH of eight letters A-Z and digits, as esbuild names them: browsers keep it for good
//   anything else     browsers ask each time whether it has changed
//   FILE.gz           sent in place of FILE to browsers that take it
// Links and names that begin with "." are left out.
class Site {
 public:
  // An empty site when the folder is not there. UNAVAILABLE when a file cannot be read, RESOURCE_EXHAUSTED beyond 64
  // MiB.
  static absl::StatusOr<Site> Read(const std::filesystem::path& folder);

  // What a GET of `path` gives, for a browser with these headers (empty: not sent).
  Reply Get(std::string_view path, std::string_view accept_encoding, std::string_view if_none_match) const;

 private:
  struct File {
    std::string media_type;
    std::string etag;
    bool hashed = false;
    std::string bytes;
    // Empty: there is none.
    std::string gzipped;
  };
  // By path, such as "/app-3FQ2XYZA.js".
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace flair::studio
