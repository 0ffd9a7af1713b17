// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon, type IconName } from "../app/Icon";
import { useDrawing } from "./context";
import type { Tool } from "./controller";

const tools: Array<{ tool: Tool; label: string; icon: IconName; key: string }> = [
  { tool: "select", label: "Select", icon: "pointer", key: "V" },
  { tool: "door", label: "Door", icon: "door", key: "D" },
  { tool: "window", label: "Window", icon: "window", key: "W" },
  { tool: "socket", label: "Socket", icon: "socket", key: "E" },
];

export function Toolbar() {
  const drawing = useDrawing(),
    { past, future, now } = drawing.history.value;
  const isClosed = drawing.sketch.value.isClosed;
  return (
    <div class="room-tools">
      {isClosed && (
        <div class="segmented" role="group" aria-label="Tool">
          {tools.map(({ tool, label, icon, key }) => (
            <button
              key={tool}
              aria-pressed={drawing.tool.value === tool}
              aria-label={label}
              title={`${label} (${key})`}
              onClick={() => drawing.take(tool)}
            >
              <Icon name={icon} />
              <span>{label}</span>
            </button>
          ))}
        </div>
      )}
      <div class="button-group">
        <button
          class="icon-button"
          disabled={past.length === 0}
          onClick={() => drawing.undo()}
          aria-label={`Undo: ${now.label || "nothing"}`}
          title={past.length > 0 ? `Undo: ${now.label} (Ctrl Z)` : "Nothing to undo"}
        >
          <Icon name="undo" />
        </button>
        <button
          class="icon-button"
          disabled={future.length === 0}
          onClick={() => drawing.redo()}
          aria-label={`Redo: ${future[0]?.label ?? "nothing"}`}
          title={future.length > 0 ? `Redo: ${future[0]!.label} (Ctrl Shift Z)` : "Nothing to redo"}
        >
          <Icon name="redo" />
        </button>
      </div>
    </div>
  );
}
