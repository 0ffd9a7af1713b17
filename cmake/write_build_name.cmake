# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=NAME -DGIT=PROGRAM -DSOURCE=DIR -DOUT=FILE -P write_build_name.cmake
# Writes BuildName() to OUT, unless OUT says the same already, and OUT.d: the files that the name depends on. BUILD empty:
# asks GIT about SOURCE.

# What decides results. A commit that changes none of it leaves the name alone.
set(code . ":(exclude)*.md" ":(exclude)*_test.cc" ":(exclude)docs" ":(exclude)tests" ":(exclude)**/testdata"
    ":(exclude)compose.yaml" ":(exclude)Containerfile" ":(exclude).dockerignore" ":(exclude)deploy")

# git(RESULT ARGUMENTS...): what it prints, empty when it fails. Takes no locks: somebody may be committing.
function(git result)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0 ${GIT} -C ${SOURCE} ${ARGN}
                  OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(text "")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(files "")
if(NOT BUILD AND GIT)
  git(files -c core.quotePath=false ls-files --cached --others --exclude-standard -- ${code})
  git(commit rev-list -1 HEAD -- ${code})
  if(commit)
    git(BUILD describe --always --abbrev=12 ${commit})
    git(changes diff HEAD --binary --no-color --no-ext-diff -- ${code})
    git(new_files -c core.quotePath=false ls-files --others --exclude-standard -- ${code})
    string(REPLACE ";" "\\;" new_files "${new_files}")
    string(REPLACE "\n" ";" new_files "${new_files}")
    foreach(name IN LISTS new_files)
      if(EXISTS "${SOURCE}/${name}")
        file(SHA256 "${SOURCE}/${name}" digest)
        string(APPEND changes "\n${name} ${digest}")
      endif()
    endforeach()
    if(changes)
      string(SHA256 digest "${changes}")
      string(SUBSTRING ${digest} 0 8 digest)
      set(BUILD "${BUILD}-dirty-${digest}")
    endif()
  endif()
endif()
if(NOT BUILD)
  set(BUILD unknown)
endif()

set(text "// Written by cmake/write_build_name.cmake.
#include \"worker_runtime/bootstrap/build_id.h\"

namespace flair::runtime {

std::string BuildName() { return \"${BUILD}\"; }

}  // namespace flair::runtime
")
set(before "")
if(EXISTS "${OUT}")
  file(READ "${OUT}" before)
endif()
if(NOT text STREQUAL before)
  file(WRITE "${OUT}" "${text}")
endif()

# Names that a Makefile cannot hold are left out: a change of such a file alone is not seen.
string(REPLACE ";" "" files "${files}")
string(REPLACE "\n" ";" files "${files}")
list(FILTER files EXCLUDE REGEX "[^A-Za-z0-9._/+-]")
list(TRANSFORM files PREPEND "${SOURCE}/")
foreach(file IN LISTS files)
  if(NOT EXISTS "${file}")
    list(REMOVE_ITEM files "${file}")
  endif()
endforeach()
list(JOIN files " \\\n  " files)
file(WRITE "${OUT}.d" "${OUT}: ${files}\n")
