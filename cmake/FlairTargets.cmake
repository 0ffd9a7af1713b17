# SPDX-License-Identifier: GPL-3.0-or-later
# flair_library(NAME SOURCES a.cc ... DEPENDS lib ...): a static library whose headers are included from the root.
function(flair_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    set(visibility PUBLIC)
    # What the name of the build watches; tests decide no results.
    if(NOT CMAKE_CURRENT_SOURCE_DIR MATCHES "^${CMAKE_SOURCE_DIR}/tests" AND NOT name MATCHES "_testing$")
      set_property(GLOBAL APPEND PROPERTY FLAIR_LIBRARIES ${name})
    endif()
  else()
    add_library(${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  target_include_directories(${name} ${visibility} ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} ${visibility} ${arg_DEPENDS})
endfunction()

# flair_test(NAME [ALONE] [LABEL unit] SOURCES a_test.cc ... DEPENDS lib ...): one GoogleTest program, one CTest case per test.
# Labels: unit (default), contract, golden, end_to_end, fuzz, bench. ALONE: no other test runs meanwhile.
# Tests are compiled with less optimization than what they test, from one precompiled header.
function(flair_test name)
  cmake_parse_arguments(arg "ALONE" "LABEL" "SOURCES;DEPENDS" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  add_executable(${name} ${arg_SOURCES})
  flair_compile_together(${name})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gmock GTest::gtest_main)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1> -pthread -Wno-missing-field-initializers)
  if(FLAIR_PRECOMPILE)
    target_compile_options(${name} PRIVATE -fpch-preprocess)
    target_precompile_headers(${name} REUSE_FROM flair_test_headers)
  endif()
  target_compile_definitions(${name} PRIVATE FLAIR_SOURCE_DIR="${CMAKE_SOURCE_DIR}" FLAIR_BINARY_DIR="${CMAKE_BINARY_DIR}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test_bin)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 
                       PROPERTIES LABELS ${arg_LABEL} TIMEOUT 600 RUN_SERIAL ${arg_ALONE})
endfunction()

# flair_program(NAME [TEST] SOURCES main.cc ... DEPENDS lib ...): an executable in bin/ that knows its build, installed and
# part of target `programs` unless only a test runs it.
function(flair_program name)
  cmake_parse_arguments(arg "TEST" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES} $<TARGET_OBJECTS:flair_build_name>)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS})
  if(NOT arg_TEST)
    set_property(GLOBAL APPEND PROPERTY FLAIR_PROGRAMS ${name})
    install(TARGETS ${name} RUNTIME)
  endif()
endfunction()

# Precompiled headers, with GCC only: clang refuses those of a target whose definitions differ. Without -fpch-preprocess
# ccache would keep nothing.
set(FLAIR_PRECOMPILE OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(FLAIR_PRECOMPILE ON)
endif()

# flair_precompile(TARGET HEADER ...): compiles headers that most of a target's sources include once.
function(flair_precompile target)
  if(FLAIR_PRECOMPILE)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# What every test includes, compiled once, for all of them. A program, because tests are: a precompiled header serves only
# code that is compiled in the same way.
function(flair_test_headers)
  file(CONFIGURE OUTPUT flair_test_headers.cc CONTENT "int main() { return 0; }\n")
  add_executable(flair_test_headers EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/flair_test_headers.cc)
  target_link_libraries(flair_test_headers PRIVATE flair_protos GTest::gmock absl::statusor fmt::fmt)
  target_compile_options(flair_test_headers PRIVATE $<$<CONFIG:Release>:-O1> -pthread) # some libraries ask for it
  flair_precompile(
    flair_test_headers <gmock/gmock.h> <gtest/gtest.h> <absl/status/statusor.h> <fmt/format.h> <functional> <memory>
    <string> <string_view> <vector> <flair/v1/layout_graph.pb.h> <flair/v1/solved_layout.pb.h>)
endfunction()
