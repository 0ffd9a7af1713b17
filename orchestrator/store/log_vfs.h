// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace flair::orchestrator {

// The name of a way for SQLite to its files, to be given to sqlite3_open_v2; null when it cannot be had. It is the
// usual one, but for write-ahead logs: SQLite writes each page of a transaction in two system calls, and here all of
// them are one. What is kept back is written before the call returns that writes the last page of a transaction, so
// before any other process looks for it and before SQLite flushes; and before anything else is asked of the file. Other
// processes may use the same files in the usual way.
const char* LogVfsName();

}  // namespace flair::orchestrator
