# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DIN=FILE -DOUT=HEADER -DNAME=flair::cli::kName -P embed_bytes.cmake: a file as a C++ constant.
string(REGEX MATCH "^(.*)::([^:]+)$" name "${NAME}")
set(space ${CMAKE_MATCH_1})
set(constant ${CMAKE_MATCH_2})
file(READ ${IN} digits HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${digits}")
string(REGEX REPLACE "(....................................................................................................)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUT} "#pragma once\nnamespace ${space} {\ninline constexpr unsigned char ${constant}[] = {\n${bytes}};\n}\n")
