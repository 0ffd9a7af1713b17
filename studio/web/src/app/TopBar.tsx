// SPDX-License-Identifier: GPL-3.0-or-later
import { redo, rename, settle, undo } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import type { Panes, Theme } from "../state/settings";
import { useStudio } from "../state/studio";
import { ExportMenu } from "./ExportMenu";
import { Icon, type IconName } from "./Icon";
import { isShowingKeys } from "./KeysDialog";

const panes: Array<{ value: Panes; label: string; icon: IconName }> = [
  { value: "plan", label: "Plan", icon: "plan" }, { value: "split", label: "Both", icon: "split" },
  { value: "3d", label: "3D", icon: "cube" },
];

const themeIcons: Record<Theme, IconName> = { system: "system", light: "sun", dark: "moon" };

function Title({ room }: { room: OpenRoom }) {
  const { title } = room.document.value;
  const take = (input: HTMLInputElement) => {
    const text = input.value.trim().slice(0, 200);
    if (text && text !== title) void rename(room, text);
    else input.value = title;
  };
  return (
    <h1 class="title-heading">
      <input
        class="title"
        key={`${room.id} ${title}`}
        defaultValue={title}
        aria-label="Title"
        maxLength={200}
        spellcheck={false}
        onBlur={(event) => take(event.currentTarget)}
        onKeyDown={(event) => {
          if (event.key === "Escape") event.currentTarget.value = title;
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }}
      />
    </h1>
  );
}

function RoomTools({ room }: { room: OpenRoom }) {
  const { settings } = useStudio();
  const { undoLabel, redoLabel, unsettled } = room.document.value;
  const auto = settings.autoSettle.value;
  return (
    <>
      <div class="button-group">
        <button
          class="icon-button"
          disabled={!undoLabel}
          onClick={() => void undo(room)}
          aria-label={`Undo: ${undoLabel || "nothing"}`}
          title={undoLabel ? `Undo: ${undoLabel} (Ctrl Z)` : "Nothing to undo"}
        >
          <Icon name="undo" />
        </button>
        <button
          class="icon-button"
          disabled={!redoLabel}
          onClick={() => void redo(room)}
          aria-label={`Redo: ${redoLabel || "nothing"}`}
          title={redoLabel ? `Redo: ${redoLabel} (Ctrl Shift Z)` : "Nothing to redo"}
        >
          <Icon name="redo" />
        </button>
      </div>
      <div class="button-group settle">
        <button class={unsettled ? "button is-due" : "button"} onClick={() => void settle(room)}
          title={unsettled ? "Let the other pieces make room for what you changed (S)"
            : "Let pieces that you have not placed or locked move where more of your wishes hold (S)"}>
          <Icon name="settle" />Settle</button>
        <button class="button is-toggle" aria-pressed={auto === "on"} title={auto === "on"
            ? "Auto is on: after every change the other pieces make room by themselves"
            : "Auto is off: pieces stay just where you put them until you press Settle"}
          onClick={settings.turnAuto}>Auto</button>
      </div>
      <div class="segmented" role="group" aria-label="What is shown">
        {panes.map(({ value, label, icon }) => (
          <button
            key={value}
            aria-pressed={settings.panes.value === value}
            onClick={() => {
              settings.panes.value = value;
            }}
          >
            <Icon name={icon} />
            <span>{label}</span>
          </button>
        ))}
      </div>
      <ExportMenu room={room} />
    </>
  );
}

export function TopBar() {
  const studio = useStudio(), { settings } = studio;
  const room = studio.open.value, theme = settings.theme.value, units = settings.units.value;
  return (
    <header class="top-bar">
      <button
        class="icon-button"
        aria-label="Sidebar"
        aria-expanded={settings.sidebar.value === "open"}
        title="Sidebar ([)"
        onClick={settings.turnSidebar}
      >
        <Icon name="sidebar" />
      </button>
      <button class="brand" onClick={() => goTo({ page: "start" })} aria-label="Flair: start page">
        Flair
      </button>
      {room ? <Title room={room} /> : <span class="spacer" />}
      {room && <RoomTools room={room} />}
      <button
        class="icon-button units"
        aria-label={`Units: ${units === "m" ? "metres" : "feet"}`}
        title="Metres or feet (U)"
        onClick={settings.turnUnits}
      >
        {units}
      </button>
      <button
        class="icon-button"
        aria-label={`Theme: ${theme}`}
        title={`Theme: ${theme}`}
        onClick={settings.turnTheme}
      >
        <Icon name={themeIcons[theme]} />
      </button>
      <button
        class="icon-button"
        aria-label="Keys"
        title="Keys (?)"
        onClick={() => {
          isShowingKeys.value = true;
        }}
      >
        <Icon name="question" />
      </button>
    </header>
  );
}
