# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a message that arrived is safe to work with; in every sentence the path of the field and its value.

Walks any message by its descriptor against the tables of limits.py, then follows the references between its parts.
"""

import math
import re
from collections.abc import Iterable, Iterator
from typing import Any

import grpc
from google.protobuf.descriptor import FieldDescriptor
from google.protobuf.message import Message

from flair.stage import references
from flair.stage.limits import COUNTS, IDS, NUMBERS, OPTIONAL_ENUMS, REQUIRED, TEXTS
from flair.stage.refusal import Refusal

_ID = re.compile(r"[a-z0-9_]{1,64}")
_CONTROL = re.compile(r"[\x00-\x1f\x7f]")
_SHOWN = 5


def require(request: Message, *fields: str) -> None:
    """Refuses a request in which something is wrong; `fields` are messages that it must have."""
    problems = []
    for name in fields:
        if not request.HasField(name):
            problems += problems_in(getattr(request, name), name) or [f"{name}: is not set"]
    problems += problems_in(request)
    if problems:
        more = f" (and {len(problems) - _SHOWN} more)" if len(problems) > _SHOWN else ""
        raise Refusal(grpc.StatusCode.INVALID_ARGUMENT, "; ".join(problems[:_SHOWN]) + more)


def problems_in(message: Message, path: str = "") -> list[str]:
    """What is wrong, in the order of the fields; empty when it is good."""
    return list(_walk(message, path)) + list(references.broken_in(message, path))


def _name(field: FieldDescriptor) -> str:
    return f"{field.containing_type.name}.{field.name}"


def _walk(message: Message, path: str) -> Iterator[str]:
    for field in message.DESCRIPTOR.fields:
        at = f"{path}.{field.name}" if path else field.name
        value = getattr(message, field.name)
        if field.label == FieldDescriptor.LABEL_REPEATED:
            yield from _walk_items(field, value, at)
        elif field.message_type is not None:
            if message.HasField(field.name) or _name(field) in REQUIRED:
                yield from _walk(value, at)
        elif not field.has_presence or message.HasField(field.name):
            yield from _value(field, value, at)


def _walk_items(field: FieldDescriptor, items: Any, at: str) -> Iterator[str]:
    least, most = COUNTS.get(_name(field), (0, math.inf))
    if not least <= len(items) <= most:
        yield f"{at}: has {len(items)}; must be {least} to {most}"
        return
    for index, item in enumerate(items):
        if field.message_type is not None:
            yield from _walk(item, f"{at}[{index}]")
        else:
            yield from _value(field, item, f"{at}[{index}]")
    if field.message_type is not None:
        for key in ("id", "name", "subject_id", "object_id"):
            if f"{field.message_type.name}.{key}" in IDS:
                yield from _repeated_ids([getattr(item, key) for item in items], at, key)


def _repeated_ids(ids: Iterable[str], at: str, key: str) -> Iterator[str]:
    seen: set[str] = set()
    for index, name in enumerate(ids):
        if name in seen:
            yield f"{at}[{index}].{key}: \"{name}\" is there twice; ids differ"
        seen.add(name)


def _value(field: FieldDescriptor, value: Any, at: str) -> Iterator[str]:
    name = _name(field)
    if field.cpp_type == FieldDescriptor.CPPTYPE_ENUM:
        known = value in field.enum_type.values_by_number
        if not known or (value == 0 and name not in OPTIONAL_ENUMS):
            yield f"{at}: {f'{value} is not a known value' if not known else 'is not set'}"
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        if not math.isfinite(value):
            yield f"{at}: {value} is not a number"
        elif name in NUMBERS and not NUMBERS[name].holds(value):
            yield f"{at}: {value:.17g} is outside {NUMBERS[name]}"
    elif isinstance(value, str):
        yield from _text(name, value, at)


def _text(name: str, value: str, at: str) -> Iterator[str]:
    if name in IDS and not _ID.fullmatch(value):
        yield f"{at}: \"{value[:80]}\" is not an id; 1 to 64 of a-z, 0-9 and _"
    least, most = (0, 128) if name.endswith("Request.request_id") else TEXTS.get(name, (0, math.inf))
    length = len(value.strip())
    if not least <= length <= most:
        yield f"{at}: is empty" if length == 0 else f"{at}: has {length} characters; must be {least} to {most}"
    if name == "Brief.text" and (control := _CONTROL.search(value.strip())):
        yield f"{at}: has the control character 0x{ord(control[0]):02x}; plain text only"
