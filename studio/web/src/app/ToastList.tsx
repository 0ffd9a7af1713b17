// SPDX-License-Identifier: GPL-3.0-or-later
import { useStudio } from "../state/studio";
import { Icon } from "./Icon";

export function ToastList() {
  const { toasts } = useStudio();
  return (
    <div class="toasts" role="status" aria-live="polite">
      {toasts.shown.value.map(({ id, kind, text, acts }) => (
        <div key={id} class={`toast is-${kind}`}>
          {kind === "error" && <Icon name="warning" />}
          <span>{text}</span>
          {acts.map(({ label, run }) => (
            <button key={label} class="link-button" onClick={() => { toasts.dismiss(id); run(); }}>{label}</button>
          ))}
          <button class="icon-button" aria-label="Dismiss" onClick={() => toasts.dismiss(id)}>
            <Icon name="close" size={12} />
          </button>
        </div>
      ))}
    </div>
  );
}
