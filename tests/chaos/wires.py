# SPDX-License-Identifier: GPL-3.0-or-later
"""Connections that can be cut as a network cuts them: nobody is told, bytes just stop coming, and come later or never."""

import asyncio
import contextlib
import threading

from processes import free_address

_READ_BYTES = 1 << 16


class Wires:
    """All wires; they are carried by one thread. Close it."""

    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()

    def lay(self, name: str, kind: str, targets: list[str]) -> "Link":
        """Wires from somebody, `name`, to these addresses, all cut at once."""
        return asyncio.run_coroutine_threadsafe(self._lay(name, kind, targets), self._loop).result()

    async def _lay(self, name: str, kind: str, targets: list[str]) -> "Link":
        link = Link(name, kind, self._loop)
        for target in targets:
            await link.add(target)
        return link


class Link:
    """To a fault it is a server that can be frozen: cut. Addresses that stand for the targets, in their order."""

    def __init__(self, name: str, kind: str, loop: asyncio.AbstractEventLoop) -> None:
        self.name = name
        self.kind = kind
        self.addresses: list[str] = []
        self._loop = loop
        self._whole = asyncio.Event()
        self._whole.set()
        self._servers: list[asyncio.Server] = []

    async def add(self, target: str) -> None:
        host, port = target.rsplit(":", 1)
        self.addresses.append(free_address())
        own_host, own_port = self.addresses[-1].rsplit(":", 1)

        async def carry(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            # Whoever is killed or cut off leaves errors here; to both ends they are the end of the connection.
            with contextlib.suppress(OSError), contextlib.closing(writer):
                await self._whole.wait()
                far_reader, far_writer = await asyncio.open_connection(host, int(port))
                with contextlib.closing(far_writer):
                    ends = [asyncio.ensure_future(self._pump(reader, far_writer)),
                            asyncio.ensure_future(self._pump(far_reader, writer))]
                    await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
                    for end in ends:
                        end.cancel()

        self._servers.append(await asyncio.start_server(carry, own_host, int(own_port)))

    async def _pump(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(OSError):
            while content := await reader.read(_READ_BYTES):
                await self._whole.wait()
                writer.write(content)
                await writer.drain()

    def up(self) -> bool:
        return self._whole.is_set()

    def freeze(self) -> None:
        self._loop.call_soon_threadsafe(self._whole.clear)

    def thaw(self) -> None:
        self._loop.call_soon_threadsafe(self._whole.set)
