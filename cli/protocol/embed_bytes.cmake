# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DIN=flair_v1.desc -DOUT=protocol_bytes.h -P embed_bytes.cmake: a file as a C++ constant.
file(READ ${IN} digits HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${digits}")
string(REGEX REPLACE "(....................................................................................................)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUT} "#pragma once\nnamespace flair::cli {\ninline constexpr unsigned char kProtocolBytes[] = {\n${bytes}};\n}\n")
