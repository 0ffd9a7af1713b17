#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Package flair.v1 as a page in GitHub's Markdown, from the comments in its .proto files. Every name is a link.

    /usr/bin/python3 cli/protocol/page.py build/release/cli/protocol/flair_v1.desc > docs/protocol.md

The argument is what protoc made of the files (--descriptor_set_out, with --include_source_info).
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from google.protobuf.descriptor_pb2 import FieldDescriptorProto, FileDescriptorProto, FileDescriptorSet

INTRODUCTION = """\
# Protocol

Package `flair.v1`: what the servers are asked, what they answer, and the artifacts between them. Written from the
comments in [protos/flair/v1](../protos/flair/v1) by `cli/protocol/page.py`; a test fails when it is stale.
`flair protocol NAME` prints one entry. How a server is put in a stage's place: [replace-a-stage.md](replace-a-stage.md).

Metres and radians; x east, y north, z up. A field without "optional" that is not sent has its zero value; a field of
message type may always be absent. In JSON and text the names are those given here.

"""
# Numbers of fields in descriptors, by which comments are found.
MESSAGE, ENUM, SERVICE, MEMBER, ONEOF = 4, 5, 6, 2, 8


def link(text: str, name: str) -> str:
    """To the heading `name`, by the anchor that GitHub makes of it."""
    return f"[{text}](#{re.sub(r'[^a-z0-9_-]', '', name.lower().replace(' ', '-'))})"


class Page:
    def __init__(self, files: list[tuple[str, FileDescriptorProto]]) -> None:
        self.files = files
        self._comments = {(file.name, tuple(one.path)): one.leading_comments
                          for _, file in files for one in file.source_code_info.location}
        self._names = {declared.name for _, file in files for _, declared in self.declarations(file)}
        self._file = ""

    @staticmethod
    def declarations(file: FileDescriptorProto) -> Iterator[tuple[tuple[int, int], object]]:
        """Services, messages, enums, with their paths."""
        for kind, declared in ((SERVICE, file.service), (MESSAGE, file.message_type), (ENUM, file.enum_type)):
            yield from (((kind, i), one) for i, one in enumerate(declared))

    def paragraphs(self, path: tuple[int, ...]) -> list[str]:
        """The comment before a declaration, each paragraph on one line."""
        comment = self._comments.get((self._file, path), "")
        return [" ".join(part.split()) for part in re.split(r"\n\s*\n", comment) if part.strip()]

    def inline(self, comment: str) -> str:
        """With links for names, and with what Markdown would take for its own escaped."""
        text, is_code = "", False
        for word, other in re.findall(r"((?:[\w.]*\w))|(.)", comment):
            if word:
                name = word.partition(".")[0]
                # "SolveRequest" and "Producer.build" mean a declaration, "Room" the thing.
                named = name in self._names and (name != word or sum(map(str.isupper, name)) > 1)
                text += link(word, name) if named and not is_code else word
                continue
            is_code ^= other == "`"
            text += f"\\{other}" if other == "|" or (other in "*<_" and not is_code) else other
        return text

    def one_line(self, *path: int) -> str:
        return self.inline(" ".join(self.paragraphs(path)))

    @staticmethod
    def _type(field: FieldDescriptorProto) -> str:
        prefix = "optional " if field.proto3_optional else ""
        if field.label == FieldDescriptorProto.LABEL_REPEATED:
            prefix = "list of "
        if not field.type_name:
            return f"{prefix}`{FieldDescriptorProto.Type.Name(field.type).removeprefix('TYPE_').lower()}`"
        name = field.type_name.removeprefix(".flair.v1.")
        return prefix + (f"`{name[1:]}`" if name.startswith(".") else link(name, name))

    def _message(self, path: tuple[int, int], message: object) -> str:
        if not message.field:
            return "Has no fields.\n\n"
        text = "| field | type | number | meaning |\n| --- | --- | --- | --- |\n"
        for i, field in enumerate(message.field):
            text += f"| `{field.name}` | {self._type(field)} | {field.number} | {self.one_line(*path, MEMBER, i)} |\n"
        for i, oneof in enumerate(message.oneof_decl):
            names = [f"`{field.name}`" for field in message.field
                     if field.HasField("oneof_index") and field.oneof_index == i and not field.proto3_optional]
            if names:
                text += f"\nAt most one of {', '.join(names)} (`{oneof.name}`): {self.one_line(*path, ONEOF, i)}\n"
        return text + "\n"

    def _enum(self, path: tuple[int, int], enumeration: object) -> str:
        return "| value | number | meaning |\n| --- | --- | --- |\n" + "".join(
            f"| `{value.name}` | {value.number} | {self.one_line(*path, MEMBER, i)} |\n"
            for i, value in enumerate(enumeration.value)) + "\n"

    def _service(self, path: tuple[int, int], service: object) -> str:
        text = ""
        for i, method in enumerate(service.method):
            request, response = (name.rpartition(".")[2] for name in (method.input_type, method.output_type))
            stream = "stream of " if method.server_streaming else ""
            text += (f"- **{method.name}**: {link(request, request)} → {stream}{link(response, response)}<br>"
                     f"{self.one_line(*path, MEMBER, i)}\n")
        return text + "\n"

    def text(self) -> str:
        text = INTRODUCTION + "| chapter | what is in it |\n| --- | --- |\n"
        for title, file in self.files:
            links = [link(declared.name, declared.name) for _, declared in self.declarations(file)]
            text += f"| {link(title, title)} | {', '.join(links)} |\n"
        text += "\n"
        section = {MESSAGE: self._message, ENUM: self._enum, SERVICE: self._service}
        for title, file in self.files:
            self._file = file.name
            text += f"## {title}\n\n[{file.name.rpartition('/')[2]}](../protos/{file.name})\n\n"
            for path, declared in self.declarations(file):
                about = "".join(f"{self.inline(paragraph)}\n\n" for paragraph in self.paragraphs(path))
                text += f"### {declared.name}\n\n{about}{section[path[0]](path, declared)}"
        return text[:-1]


def read_page(descriptors: Path) -> Page:
    """In the order of reading_order.json, which people read in."""
    read = FileDescriptorSet.FromString(descriptors.read_bytes())
    files = {file.name: file for file in read.file if file.package == "flair.v1"}
    order = json.loads((Path(__file__).parent / "reading_order.json").read_text(encoding="utf-8"))
    titles = {f"flair/v1/{name}.proto": title for name, title in order}
    listed = [(title, files[name]) for name, title in titles.items() if name in files]
    return Page(listed + [(name, file) for name, file in files.items() if name not in titles])


if __name__ == "__main__":
    sys.stdout.write(read_page(Path(sys.argv[1])).text())
