// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the page's lower edge, which has a place of its own and covers nothing: what has just happened and what can
// be done about it; otherwise what the pointer can do.
import type { OpenRoom } from "../state/open_room";
import { route } from "../state/route";
import { useStudio, type Studio } from "../state/studio";
import type { Toast } from "../state/toasts";
import { Icon } from "./Icon";

function hintOf({ pieces, selection }: OpenRoom): string {
  if (pieces.value.size === 0) return "Say what shall stand here, or take furniture from the drawer.";
  if (selection.value.size === 0) return "Click a piece to see why it stands there. Drag it to move it.";
  if (selection.value.size === 1) return "Drag it, or turn it with R. Click a distance to type another one.";
  return "Drag them, or turn them with R. Shift adds a piece or takes it away.";
}

function Message({ studio: { toasts }, toast }: { studio: Studio; toast: Toast }) {
  const { id, kind, text, acts } = toast, others = toasts.shown.value.length - 1;
  const leave = (run = () => {}) => {
    toasts.isHeld = false;
    toasts.dismiss(id);
    run();
  };
  return (
    <div class={`message is-${kind}`}>
      <Icon name={kind === "error" ? "warning" : "check"} />
      <span class="message-text" title={text.length > 150 ? text : undefined}>{text}</span>
      {acts.map(({ label, run }) => (
        <button key={label} class="link-button" onClick={() => leave(run)}>{label}</button>
      ))}
      {others > 0 && <button class="link-button is-quiet" onClick={() => leave()}>{`${others} more`}</button>}
      <button class="icon-button" aria-label="Dismiss" onClick={() => leave()}><Icon name="close" size={12} /></button>
    </div>
  );
}

export function MessageBar() {
  const studio = useStudio();
  const hold = (isHeld: boolean) => () => { studio.toasts.isHeld = isHeld; };
  const latest = studio.toasts.latest.value, room = route.value.page === "document" ? studio.open.value : undefined;
  return (
    <footer class={latest ? `message-bar is-${latest.kind}` : "message-bar"} onPointerEnter={hold(true)}
      onPointerLeave={hold(false)} onFocusIn={hold(true)} onFocusOut={hold(false)}>
      <div role="status" aria-live="polite">{latest && <Message key={latest.id} studio={studio} toast={latest} />}</div>
      {!latest && room && <p class="message-hint">{hintOf(room)}</p>}
      {!latest && <p class="message-keys"><kbd>?</kbd> all keys</p>}
    </footer>
  );
}
