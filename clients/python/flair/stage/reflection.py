# SPDX-License-Identifier: GPL-3.0-or-later
"""grpc.reflection.v1alpha.ServerReflection: what grpcurl and the like ask a server for its protos."""

from collections.abc import Iterator

import grpc
from google.protobuf import descriptor_pool
from google.protobuf.descriptor import FileDescriptor

from flair.stage import reflection_pb2, reflection_pb2_grpc


def _with_imports(file: FileDescriptor, seen: dict[str, bytes]) -> list[bytes]:
    """The file and all that it imports, serialized, each once."""
    if file.name not in seen:
        seen[file.name] = file.serialized_pb
        for imported in file.dependencies:
            _with_imports(imported, seen)
    return list(seen.values())


class Reflection(reflection_pb2_grpc.ServerReflectionServicer):
    """Answers from the descriptors of all modules that this process has loaded."""

    def __init__(self, services: list[str]) -> None:
        self._services = sorted(services)
        self._pool = descriptor_pool.Default()

    def _files(self, request: reflection_pb2.ServerReflectionRequest) -> list[bytes]:
        """Serialized files; KeyError when unknown."""
        kind = request.WhichOneof("message_request")
        if kind == "file_by_filename":
            return _with_imports(self._pool.FindFileByName(request.file_by_filename), {})
        if kind == "file_containing_symbol":
            return _with_imports(self._pool.FindFileContainingSymbol(request.file_containing_symbol), {})
        raise KeyError(f"{kind} is not answered here; list_services, file_by_filename, file_containing_symbol are")

    def ServerReflectionInfo(
        self, request_iterator: Iterator[reflection_pb2.ServerReflectionRequest], context: grpc.ServicerContext
    ) -> Iterator[reflection_pb2.ServerReflectionResponse]:
        for request in request_iterator:
            answer = reflection_pb2.ServerReflectionResponse(valid_host=request.host, original_request=request)
            try:
                if request.WhichOneof("message_request") == "list_services":
                    for name in self._services:
                        answer.list_services_response.service.add(name=name)
                else:
                    answer.file_descriptor_response.file_descriptor_proto.extend(self._files(request))
            except KeyError as error:
                answer.error_response.error_code = grpc.StatusCode.NOT_FOUND.value[0]
                answer.error_response.error_message = str(error.args[0])
            yield answer
