// SPDX-License-Identifier: GPL-3.0-or-later
import type { OpenRoom } from "../state/open_room";

export default function Scene({ room }: { room: OpenRoom }) {
  return <div class="scene">{room.document.value.title}</div>;
}
