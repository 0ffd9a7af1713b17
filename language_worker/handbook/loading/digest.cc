// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/loading/digest.h"

#include <fmt/format.h>
#include <openssl/sha.h>

namespace flair::language {

std::string Sha256Hex(std::string_view bytes) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest);
  std::string hex;
  for (const unsigned char byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace flair::language
