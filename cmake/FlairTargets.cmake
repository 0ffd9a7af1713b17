# SPDX-License-Identifier: GPL-3.0-or-later
# flair_library(NAME [COLD] SOURCES a.cc ... DEPENDS lib ...): a static library whose headers are included from the root.
# COLD: nobody waits for its code (options, tables, fixtures of tests), so that it is compiled with less optimization.
function(flair_library name)
  cmake_parse_arguments(arg "COLD" "" "SOURCES;DEPENDS" ${ARGN})
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    set(visibility PUBLIC)
  else()
    add_library(${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  target_include_directories(${name} ${visibility} ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} ${visibility} ${arg_DEPENDS})
  if(arg_COLD)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  flair_rounds(${name} rounds ${arg_DEPENDS})
  if(arg_SOURCES AND FLAIR_PRECOMPILE AND NOT (rounds AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang"))
    target_precompile_headers(${name} REUSE_FROM flair_library_headers)
  endif()
endfunction()

# flair_rounds(LIBRARY RESULT DEPENDS ...): whether LIBRARY is compiled with CGAL's -frounding-math. Clang refuses a precompiled
# header that was not.
function(flair_rounds name result)
  get_property(rounding GLOBAL PROPERTY FLAIR_ROUNDING)
  set(${result} OFF PARENT_SCOPE)
  foreach(library IN LISTS ARGN)
    if(library STREQUAL "CGAL::CGAL" OR library IN_LIST rounding)
      set_property(GLOBAL APPEND PROPERTY FLAIR_ROUNDING ${name})
      set(${result} ON PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# flair_test(NAME [ALONE] [WHOLE] [LABEL unit] SOURCES a_test.cc ... [APART a_test.cc ...] DEPENDS lib ...): one GoogleTest program,
# one CTest case per test. WHOLE: one case of the program's name for all of them, where starting it takes longer than a test.
# Labels: unit (default), contract, golden, end_to_end, fuzz, bench. ALONE: no other test runs meanwhile.
# APART: sources that are compiled alone, because they have a name at file level in common with another source of the test.
# Give new tests names of their own instead.
# Tests are compiled with less optimization than what they test, from one precompiled header.
function(flair_test name)
  cmake_parse_arguments(arg "ALONE;WHOLE" "LABEL" "SOURCES;APART;DEPENDS" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  add_executable(${name} ${arg_SOURCES})
  set_source_files_properties(${arg_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gmock GTest::gtest_main)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-Og> -Wno-missing-field-initializers)
  if(FLAIR_PRECOMPILE_TESTS)
    target_precompile_headers(${name} REUSE_FROM flair_test_headers)
  endif()
  target_compile_definitions(${name} PRIVATE FLAIR_SOURCE_DIR="${CMAKE_SOURCE_DIR}" FLAIR_BINARY_DIR="${CMAKE_BINARY_DIR}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test_bin)
  set(properties LABELS ${arg_LABEL} TIMEOUT 600 RUN_SERIAL ${arg_ALONE})
  if(arg_WHOLE)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES ${properties})
  else()
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  endif()
endfunction()

# flair_program(NAME [TEST] [CLONE] SOURCES main.cc ... DEPENDS lib ...): an executable in bin/ that knows its build.
# Installed and part of target `programs` unless only a test (TEST) or somebody with a clone of the repository (CLONE) runs it.
function(flair_program name)
  cmake_parse_arguments(arg "TEST;CLONE" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES} $<TARGET_OBJECTS:flair_build_name>)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS})
  if(NOT arg_TEST AND NOT arg_CLONE)
    set_property(GLOBAL APPEND PROPERTY FLAIR_PROGRAMS ${name})
    install(TARGETS ${name} RUNTIME)
  endif()
endfunction()

# flair_embedded_text(TARGET FUNCTION file ...): gives a library a function `std::string_view FUNCTION()` in namespace flair
# that returns the text of the files, one after the other. Its users declare it.
function(flair_embedded_text target function)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${file} part)
    string(APPEND text "${part}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  file(CONFIGURE OUTPUT ${function}.cc @ONLY CONTENT
"#include <string_view>
namespace flair {
std::string_view ${function}();
std::string_view ${function}() {
  return R\"text(${text})text\";
}
}  // namespace flair
")
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${function}.cc)
endfunction()

# Precompiled headers: one for libraries, one for tests (-fPIE), each compiled once. CMake puts it before every file; a file
# includes what it uses all the same. Clang refuses that of the tests, whose definitions differ; without -fpch-preprocess
# ccache would keep nothing.
option(FLAIR_PRECOMPILE "Use precompiled headers" ON)
set(FLAIR_PRECOMPILE_TESTS OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(FLAIR_PRECOMPILE_TESTS ${FLAIR_PRECOMPILE})
  add_compile_options(-fpch-preprocess)
else()
  add_compile_options(-Xclang -fno-pch-timestamp)
endif()

# What most libraries include. Headers that cost much and that few include (gRPC, nlohmann, CLI11) would cost all the others more.
set(FLAIR_LIBRARY_HEADERS
    <absl/status/statusor.h> <absl/strings/str_cat.h> <absl/time/time.h> <fmt/format.h> <fmt/ranges.h> <algorithm> <array> <atomic>
    <chrono> <cmath> <condition_variable> <filesystem> <fstream> <functional> <map> <memory> <mutex> <optional> <set> <span>
    <sstream> <string> <string_view> <thread> <utility> <variant> <vector> <flair/v1/artifact.pb.h> <flair/v1/job.pb.h>
    <flair/v1/language_service.pb.h> <flair/v1/optimizer_service.pb.h> <flair/v1/orchestrator_service.pb.h>
    <flair/v1/renderer_service.pb.h> <flair/v1/translator_service.pb.h>)

# The targets that the others borrow their precompiled headers from.
function(flair_shared_headers)
  file(CONFIGURE OUTPUT flair_library_headers.cc CONTENT "// Nothing.\n")
  add_library(flair_library_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/flair_library_headers.cc)
  target_link_libraries(flair_library_headers PRIVATE flair_protos absl::statusor absl::time fmt::fmt)
  if(FLAIR_PRECOMPILE)
    target_precompile_headers(flair_library_headers PRIVATE ${FLAIR_LIBRARY_HEADERS})
    set_target_properties(flair_library_headers PROPERTIES CXX_COMPILER_LAUNCHER "${FLAIR_PRECOMPILE_LAUNCHER}")
  endif()

  # A program, because tests are: a precompiled header serves only code that is compiled in the same way.
  file(CONFIGURE OUTPUT flair_test_headers.cc CONTENT "int main() { return 0; }\n")
  add_executable(flair_test_headers EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/flair_test_headers.cc)
  target_link_libraries(flair_test_headers PRIVATE flair_protos GTest::gmock absl::statusor fmt::fmt)
  target_compile_options(flair_test_headers PRIVATE $<$<CONFIG:Release>:-Og>)
  if(FLAIR_PRECOMPILE_TESTS)
    target_precompile_headers(
      flair_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <absl/status/statusor.h> <fmt/format.h> <functional> <memory>
      <string> <string_view> <vector> <flair/v1/layout_graph.pb.h> <flair/v1/solved_layout.pb.h>)
    set_target_properties(flair_test_headers PROPERTIES CXX_COMPILER_LAUNCHER "${FLAIR_PRECOMPILE_LAUNCHER}")
  endif()
endfunction()
