// SPDX-License-Identifier: GPL-3.0-or-later
import { signal } from "@preact/signals";
import { Drawer } from "../furniture/Drawer";
import { useStudio } from "../state/studio";
import { Documents } from "./Documents";
import { Icon } from "./Icon";

export const sidebarTab = signal<"rooms" | "furniture">("rooms");

export function Sidebar() {
  const studio = useStudio();
  if (studio.settings.sidebar.value === "closed") return null;
  const room = studio.open.value;
  const tab = room ? sidebarTab.value : "rooms";
  return (
    <nav class="sidebar" aria-label="Rooms and furniture">
      {room && (
        <div class="tabs" role="tablist" aria-label="Sidebar">
          <button role="tab" id="tab-rooms" aria-selected={tab === "rooms"} aria-controls="sidebar-panel"
            onClick={() => { sidebarTab.value = "rooms"; }}><Icon name="rooms" />Rooms</button>
          <button role="tab" id="tab-furniture" aria-selected={tab === "furniture"} aria-controls="sidebar-panel"
            onClick={() => { sidebarTab.value = "furniture"; }}><Icon name="chair" />Furniture</button>
        </div>
      )}
      <div
        class="sidebar-panel"
        id="sidebar-panel"
        role={room ? "tabpanel" : undefined}
        aria-labelledby={room ? `tab-${tab}` : undefined}
      >
        {tab === "furniture" && room ? <Drawer room={room} /> : <Documents />}
      </div>
    </nav>
  );
}
