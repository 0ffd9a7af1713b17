// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/log_vfs.h"

#include <sqlite3.h>

#include <new>
#include <string>

namespace flair::orchestrator {
namespace {

constexpr char kName[] = "flair-log";

// Of the log's format (https://www.sqlite.org/fileformat2.html#walformat): before each page comes a frame header, whose
// second number, big-endian, is zero but for the last page of a transaction.
constexpr int kFrameHeaderBytes = 24;
constexpr int kCommitAt = 4;
constexpr int kCommitBytes = 4;

// A transaction that is larger is written in parts. The usual file takes less than 128 KiB at once, and a page may have
// 64.
constexpr size_t kMostKept = 60 * 1024;

// A log. The usual file comes right behind it in memory.
struct LogFile {
  sqlite3_file base;
  // Written, and to be put into the file, from `begin` on.
  std::string kept;
  sqlite3_int64 begin;
  // Where the last write ended. Only what goes on from there is kept back: a log that is appended to.
  sqlite3_int64 end;
  // The last header was of a frame that ends a transaction: its page comes next, in parts if it is flushed in the
  // middle.
  bool ends_transaction;
};

sqlite3_file* UsualFile(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(reinterpret_cast<LogFile*>(file) + 1);
}
LogFile& LogOf(sqlite3_file* file) { return *reinterpret_cast<LogFile*>(file); }

// What cannot be written is given up with its transaction, which is told so.
int WriteKept(sqlite3_file* file) {
  LogFile& log = LogOf(file);
  if (log.kept.empty()) return SQLITE_OK;
  sqlite3_file* usual = UsualFile(file);
  const int code = usual->pMethods->xWrite(usual, log.kept.data(), static_cast<int>(log.kept.size()), log.begin);
  log.kept.clear();
  return code;
}

bool EndsTransaction(const void* bytes) {
  const auto* commit = static_cast<const unsigned char*>(bytes) + kCommitAt;
  for (int i = 0; i < kCommitBytes; ++i) {
    if (commit[i] != 0) return true;
  }
  return false;
}

int Write(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset) {
  LogFile& log = LogOf(file);
  const bool goes_on = offset == log.end;
  const bool header = size == kFrameHeaderBytes;
  if (header) log.ends_transaction = EndsTransaction(bytes);
  log.end = offset + size;
  if (!goes_on) {
    if (const int code = WriteKept(file); code != SQLITE_OK) return code;
    sqlite3_file* usual = UsualFile(file);
    return usual->pMethods->xWrite(usual, bytes, size, offset);
  }
  if (log.kept.empty()) log.begin = offset;
  log.kept.append(static_cast<const char*>(bytes), static_cast<size_t>(size));
  const bool last_page = log.ends_transaction && !header;
  return last_page || log.kept.size() >= kMostKept ? WriteKept(file) : SQLITE_OK;
}

int Close(sqlite3_file* file) {
  const int written = WriteKept(file);
  sqlite3_file* usual = UsualFile(file);
  const int closed = usual->pMethods->xClose(usual);
  LogOf(file).~LogFile();
  return written == SQLITE_OK ? closed : written;
}

// Calls a method of the usual file, once it is as it should be.
template <auto kMethod, typename... Arguments>
int Call(sqlite3_file* file, Arguments... arguments) {
  if (const int code = WriteKept(file); code != SQLITE_OK) return code;
  sqlite3_file* usual = UsualFile(file);
  return (usual->pMethods->*kMethod)(usual, arguments...);
}

// What the usual file says of itself, whatever has been written.
template <auto kMethod>
int Ask(sqlite3_file* file) {
  sqlite3_file* usual = UsualFile(file);
  return (usual->pMethods->*kMethod)(usual);
}

using Methods = sqlite3_io_methods;
constexpr Methods kLogMethods = {
    .iVersion = 1,
    .xClose = Close,
    .xRead = Call<&Methods::xRead, void*, int, sqlite3_int64>,
    .xWrite = Write,
    .xTruncate = Call<&Methods::xTruncate, sqlite3_int64>,
    .xSync = Call<&Methods::xSync, int>,
    .xFileSize = Call<&Methods::xFileSize, sqlite3_int64*>,
    .xLock = Call<&Methods::xLock, int>,
    .xUnlock = Call<&Methods::xUnlock, int>,
    .xCheckReservedLock = Call<&Methods::xCheckReservedLock, int*>,
    .xFileControl = Call<&Methods::xFileControl, int, void*>,
    .xSectorSize = Ask<&Methods::xSectorSize>,
    .xDeviceCharacteristics = Ask<&Methods::xDeviceCharacteristics>,
};

sqlite3_vfs* Usual() { return sqlite3_vfs_find(nullptr); }

int Open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  sqlite3_vfs* usual = Usual();
  if ((flags & SQLITE_OPEN_WAL) == 0) return usual->xOpen(usual, name, file, flags, out_flags);
  new (file) LogFile{};
  LogOf(file).end = -1;
  const int code = usual->xOpen(usual, name, UsualFile(file), flags, out_flags);
  if (code == SQLITE_OK) {
    LogOf(file).base.pMethods = &kLogMethods;
  } else {
    LogOf(file).~LogFile();
    file->pMethods = nullptr;
  }
  return code;
}

sqlite3_vfs* Register() {
  sqlite3_vfs* usual = Usual();
  if (usual == nullptr) return nullptr;
  // But for how files are opened it is the usual one, whose methods do not mind by which name they are called.
  static sqlite3_vfs vfs = *usual;
  vfs.zName = kName;
  vfs.pNext = nullptr;
  vfs.szOsFile = static_cast<int>(sizeof(LogFile)) + usual->szOsFile;
  vfs.xOpen = Open;
  return sqlite3_vfs_register(&vfs, 0) == SQLITE_OK ? &vfs : nullptr;
}

}  // namespace

const char* LogVfsName() {
  static const sqlite3_vfs* const vfs = Register();
  return vfs == nullptr ? nullptr : kName;
}

}  // namespace flair::orchestrator
