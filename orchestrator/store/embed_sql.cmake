# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DIN=a.sql,b.sql -DOUT=schema_sql.h -P embed_sql.cmake: the steps of the schema as C++ constants, oldest first.
string(REPLACE "," ";" files "${IN}")
set(steps "")
foreach(file ${files})
  file(READ ${file} text)
  string(APPEND steps "    R\"sql(${text})sql\",\n")
endforeach()
file(WRITE ${OUT} "#pragma once\n#include <string_view>\nnamespace flair::orchestrator {\ninline constexpr std::string_view kMigrations[] = {\n${steps}};\n}\n")
