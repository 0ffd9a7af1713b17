# SPDX-License-Identifier: GPL-3.0-or-later
# Warnings, sanitizers, the linker and the compiler cache; the same for every target.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

add_compile_options(-Wall -Wextra -Wno-unused-parameter -Werror=return-type -Werror=switch)

# The same for all, so that all can use the same precompiled headers.
add_compile_options(-pthread)
add_compile_definitions(FMT_SHARED)

# Bit-for-bit equal results on every machine: no contraction of a * b + c, no value-changing shortcuts.
add_compile_options(-ffp-contract=off)

if(FLAIR_SANITIZE)
  add_compile_options(-fsanitize=${FLAIR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${FLAIR_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # As in optimizer_worker/zones, for what clang instantiates elsewhere.
    add_compile_options(-fno-sanitize=vptr)
  endif()
endif()

if(FLAIR_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "FLAIR_FUZZ needs clang: cmake --preset fuzz, or -DCMAKE_CXX_COMPILER=clang++-19")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(FLAIR_MOLD mold)
if(FLAIR_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

find_program(FLAIR_CCACHE ccache)
if(FLAIR_CCACHE)
  # Paths relative to the build folder, so that several build folders share one cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros ${FLAIR_CCACHE})
  # For precompiled headers: ccache's preprocessor would read the old one where it stands and take it for the headers' content.
  set(FLAIR_PRECOMPILE_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
      CCACHE_SLOPPINESS=pch_defines,time_macros ${FLAIR_CCACHE})
endif()
