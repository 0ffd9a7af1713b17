// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the page's lower edge, which has a place of its own and covers nothing: what has just happened and what can
// be done about it; otherwise what the pointer can do.
import { useLayoutEffect, useRef } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";
import { route } from "../state/route";
import { useStudio, type Studio } from "../state/studio";
import type { Toast } from "../state/toasts";
import { Icon } from "./Icon";
import { CloseButton } from "./PanelHead";

function hintOf({ pieces, selection }: OpenRoom): string {
  if (pieces.value.size === 0) return "Say what shall stand here, or take furniture from the drawer.";
  if (selection.value.size === 0) return "Click a piece to see why it stands there. Drag it to move it.";
  if (selection.value.size === 1) return "Drag it, or turn it with R. Click a distance to type another one.";
  return "Drag them, or turn them with R. Shift adds a piece or takes it away.";
}

interface MessageProps {
  studio: Studio;
  toast: Toast;
  isWhole?: boolean;
}

function Message({ studio: { toasts }, toast, isWhole }: MessageProps) {
  const { id, kind, text, acts } = toast, others = toasts.shown.value.length - 1;
  const leave = (run = () => {}) => {
    toasts.isHeld = false;
    toasts.dismiss(id);
    run();
  };
  return (
    <div class={`message is-${kind}`}>
      <Icon name={kind === "error" || kind === "warning" ? "warning" : "check"} />
      <span class="message-text" title={!isWhole && text.length > 150 ? text : undefined}>{text}</span>
      {acts.map(({ label, run }) => (
        <button key={label} class="link-button" onClick={() => leave(run)}>{label}</button>
      ))}
      {others > 0 && !isWhole && (
        <button class="link-button is-quiet" aria-expanded={toasts.isListed.value}
          onClick={() => { toasts.isListed.value = !toasts.isListed.peek(); }}>{`${others} more`}</button>
      )}
      <CloseButton label="Dismiss" onClose={() => leave()} />
    </div>
  );
}

// All that was told and is not gone yet, the latest at the foot, where it is seen alone.
function MessageList({ studio }: { studio: Studio }) {
  const { toasts } = studio;
  const list = useRef<HTMLElement>(null);
  // Keys are heard from the very moment that it is seen.
  useLayoutEffect(() => {
    const close = () => { toasts.isListed.value = false; };
    const outside = (event: Event) => { if (!list.current?.parentElement?.contains(event.target as Node)) close(); };
    const escape = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      close();
    };
    addEventListener("pointerdown", outside, true);
    addEventListener("keydown", escape, true);
    return () => {
      removeEventListener("pointerdown", outside, true);
      removeEventListener("keydown", escape, true);
    };
  }, [toasts]);
  return (
    <section class="message-list" aria-label="All messages" ref={list}>
      {toasts.shown.value.map((toast) => <Message key={toast.id} studio={studio} toast={toast} isWhole />)}
    </section>
  );
}

export function MessageBar() {
  const studio = useStudio(), { toasts } = studio;
  const hold = (isHeld: boolean) => () => { toasts.isHeld = isHeld; };
  const latest = toasts.latest.value, room = route.value.page === "document" ? studio.open.value : undefined;
  return (
    <footer class={latest ? `message-bar is-${latest.kind}` : "message-bar"} onPointerEnter={hold(true)}
      onPointerLeave={hold(false)} onFocusIn={hold(true)} onFocusOut={hold(false)}>
      {toasts.isListed.value && <MessageList studio={studio} />}
      <div role="status" aria-live="polite">{latest && <Message key={latest.id} studio={studio} toast={latest} />}</div>
      {!latest && room && <p class="message-hint">{hintOf(room)}</p>}
      {!latest && <p class="message-keys"><kbd>?</kbd> all keys</p>}
    </footer>
  );
}
