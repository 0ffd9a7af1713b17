// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/build_id.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>

#include <cstring>
#include <string_view>

namespace flair::runtime {
namespace {

constexpr size_t AlignTo4(size_t size) { return (size + 3) & ~size_t{3}; }

// The build id in a segment of notes, in hex; empty when there is none.
std::string FindBuildId(const char* notes, size_t size) {
  for (size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) header;
    std::memcpy(&header, notes + at, sizeof header);
    const char* name = notes + at + sizeof header;
    const char* description = name + AlignTo4(header.n_namesz);
    if (header.n_type == NT_GNU_BUILD_ID && std::string_view(name, header.n_namesz) == std::string_view("GNU\0", 4)) {
      std::string hex;
      for (size_t i = 0; i < header.n_descsz; ++i)
        hex += fmt::format("{:02x}", static_cast<unsigned char>(description[i]));
      return hex;
    }
    at += sizeof header + AlignTo4(header.n_namesz) + AlignTo4(header.n_descsz);
  }
  return "";
}

// Called for the program first; one call is enough.
int ReadProgram(dl_phdr_info* info, size_t, void* result) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const char* notes = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
    const std::string id = FindBuildId(notes, segment.p_memsz);
    if (!id.empty()) *static_cast<std::string*>(result) = id;
  }
  return 1;
}

}  // namespace

std::string BuildId() {
  std::string id;
  ::dl_iterate_phdr(ReadProgram, &id);
  if (!id.empty()) return id;
  struct stat file = {};
  (void)::stat("/proc/self/exe", &file);
  return fmt::format("{:x}{:x}{:x}", file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec);
}

}  // namespace flair::runtime
