// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Wider vectors where the processor has them; every operation rounds alike, so the result is the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FLAIR_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FLAIR_WIDE_VECTORS
#endif
