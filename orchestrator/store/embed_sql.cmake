# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DIN=schema.sql -DOUT=schema_sql.h -P embed_sql.cmake: the schema as a C++ constant.
file(READ ${IN} text)
file(WRITE ${OUT} "#pragma once\n#include <string_view>\nnamespace flair::orchestrator {\ninline constexpr std::string_view kSchemaSql = R\"sql(${text})sql\";\n}\n")
