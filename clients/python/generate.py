#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the Python package `flair` in a folder: the code beside this script and what protoc makes of the protos.

    python3 clients/python/generate.py FOLDER && export PYTHONPATH=FOLDER

Needs protoc, grpc_python_plugin and the protos of gRPC's own services (Debian: protobuf-compiler,
protobuf-compiler-grpc, grpc-proto). Uses the standard library only: pip runs it where nothing else is installed.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROTO_ROOT = HERE.parent.parent / "protos"
# Where Debian keeps the services that every gRPC server has, and the folder of ours that their code goes to: a module
# named grpc.health would hide the library's own package grpc.
GRPC_PROTO_ROOT = Path("/usr/share/grpc-proto/grpc")
STAGE_PROTOS = {"health.proto": "health/v1", "reflection.proto": "reflection/v1alpha"}


def run_protoc(out: Path, kinds: list[str], search: list[str], protos: list[str]) -> None:
    """Writes the modules of `protos`, paths below `search`, to `out`. Kinds: "python", "pyi" (types), "grpc_python"."""
    plugin = shutil.which("grpc_python_plugin")
    if plugin is None or shutil.which("protoc") is None:
        sys.exit("generate.py: protoc or its plugin is missing; apt install protobuf-compiler protobuf-compiler-grpc")
    command = ["protoc", f"--plugin=protoc-gen-grpc_python={plugin}", *(f"-I{path}" for path in search)]
    subprocess.run([*command, *(f"--{kind}_out={out}" for kind in kinds), *protos], check=True)


def names_of(proto: Path) -> dict[str, list[str]]:
    """The names that each module of a proto has, by module."""
    text = proto.read_text()
    modules = {f"{proto.stem}_pb2": re.findall(r"^(?:message|enum) (\w+)", text, re.MULTILINE)}
    for service in re.findall(r"^service (\w+)", text, re.MULTILINE):
        stubs = [f"{service}Servicer", f"{service}Stub", f"add_{service}Servicer_to_server"]
        modules.setdefault(f"{proto.stem}_pb2_grpc", []).extend(stubs)
    return {module: names for module, names in modules.items() if names}


def generate(out: Path) -> None:
    """Makes `out`/flair anew."""
    package = out / "flair"
    shutil.rmtree(package, ignore_errors=True)
    shutil.copytree(HERE / "flair", package, ignore=shutil.ignore_patterns("__pycache__", "*_test.py"))
    protos = sorted(PROTO_ROOT.glob("flair/v1/*.proto"))
    if not protos:
        sys.exit(f"generate.py: no protos in {PROTO_ROOT}/flair/v1; run it in a checkout of Flair")
    paths = [str(proto.relative_to(PROTO_ROOT)) for proto in protos]
    run_protoc(out, ["python", "pyi"], [str(PROTO_ROOT)], paths)
    run_protoc(out, ["grpc_python"], [str(PROTO_ROOT)], [path for path in paths if path.endswith("_service.proto")])
    lines = ['"""All messages, enums, stubs and servicers of flair.v1. Generated; the protos say what they mean."""']
    for proto in protos:
        lines += [f"from flair.v1.{module} import {', '.join(names)}" for module, names in names_of(proto).items()]
    (package / "v1" / "__init__.py").write_text("\n".join(lines) + "\n")
    for proto, folder in STAGE_PROTOS.items():
        if not (GRPC_PROTO_ROOT / folder / proto).is_file():
            sys.exit(f"generate.py: {GRPC_PROTO_ROOT / folder / proto} is missing; apt install grpc-proto")
        search = [f"flair/stage={GRPC_PROTO_ROOT / folder}"]
        run_protoc(out, ["python", "grpc_python"], search, [f"flair/stage/{proto}"])


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    generate(Path(sys.argv[1]).resolve())
