# SPDX-License-Identifier: GPL-3.0-or-later
# What the programs say they were built from: `git describe` of the last commit that changed code, and a digest of what is
# not committed; "unknown" outside git; or what the one who packages says. See docs/decisions/0012.
#
# The name is looked up again when HEAD moves and when a file that decides results has changed, not at every build; only the
# programs are linked again, and only when it changes.
set(FLAIR_BUILD "" CACHE STRING "What to call this build; empty asks git")
if(NOT FLAIR_BUILD MATCHES "^[A-Za-z0-9._+-]*$")
  message(FATAL_ERROR "FLAIR_BUILD is \"${FLAIR_BUILD}\"; letters, digits, '.', '_', '+' and '-' are allowed")
endif()

find_program(FLAIR_GIT git)
set(head_moved)
if(FLAIR_GIT AND NOT FLAIR_BUILD)
  foreach(name logs/HEAD HEAD)
    execute_process(COMMAND ${FLAIR_GIT} -C ${CMAKE_SOURCE_DIR} rev-parse --git-path ${name}
                    OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed AND NOT head_moved)
      get_filename_component(path "${path}" ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
      if(EXISTS "${path}")
        set(head_moved "${path}")
      endif()
    endif()
  endforeach()
endif()

set(build_name_cc ${CMAKE_BINARY_DIR}/build_name/build_name.cc)
add_custom_command(
  OUTPUT ${build_name_cc}
  COMMAND ${CMAKE_COMMAND} -DBUILD=${FLAIR_BUILD} -DGIT=${FLAIR_GIT} -DSOURCE=${CMAKE_SOURCE_DIR} -DOUT=${build_name_cc}
          -P ${CMAKE_SOURCE_DIR}/cmake/write_build_name.cmake
  DEPENDS ${CMAKE_SOURCE_DIR}/cmake/write_build_name.cmake ${head_moved}
  DEPFILE ${build_name_cc}.d
  COMMENT "Naming the build" VERBATIM)
add_library(flair_build_name OBJECT ${build_name_cc})
target_include_directories(flair_build_name PRIVATE ${CMAKE_SOURCE_DIR})
