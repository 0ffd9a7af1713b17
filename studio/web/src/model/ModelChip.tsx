// SPDX-License-Identifier: GPL-3.0-or-later
// Who designs: the handbook, or a language model that is chosen here. Its key stays in the server's memory.
import { useEffect, useState } from "preact/hooks";
import { Dialog } from "../app/Dialog";
import { sentenceOf } from "../api/problems";
import { useStudio } from "../state/studio";
import type { GetModelResponse } from "../gen/flair/v1/studio_service_pb";

export function ModelChip() {
  const studio = useStudio();
  const [now, setNow] = useState<GetModelResponse>();
  const [isOpen, setOpen] = useState(false);
  const look = () => { studio.clients.studio.getModel({}).then(setNow, () => {}); };
  useEffect(look, []);
  if (!now?.canChoose) return null;
  return (
    <>
      <button
        type="button"
        class="chip"
        aria-haspopup="dialog"
        title="Who designs: Flair's handbook or a language model"
        onClick={() => setOpen(true)}
      >
        {now.model?.model || "Handbook"}
      </button>
      {isOpen && (
        <ModelDialog
          now={now}
          onClose={() => {
            setOpen(false);
            look();
          }}
        />
      )}
    </>
  );
}

function ModelDialog({ now, onClose }: { now: GetModelResponse; onClose(): void }) {
  const { clients } = useStudio();
  const [baseUrl, setBaseUrl] = useState(now.model?.baseUrl ?? "");
  const [model, setModel] = useState(now.model?.model ?? "");
  const [apiKey, setApiKey] = useState("");
  const [problem, setProblem] = useState("");
  const choose = (choice: { baseUrl: string; model: string; apiKey: string }) =>
    clients.studio.chooseModel({ model: choice }).then(onClose, (error: unknown) => setProblem(sentenceOf(error)));
  return (
    <Dialog title="Who designs" class="model-dialog" onClose={onClose}>
      {/* No form: it stands in that of the brief. */}
      <div
        class="model-fields"
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key !== "Enter" || !(event.target instanceof HTMLInputElement)) return;
          event.preventDefault();
          void choose({ baseUrl, model, apiKey });
        }}
      >
        <p class="hint">
          Flair's handbook needs no network. A language model knows more kinds of rooms; any server with the
          OpenAI-compatible API will do, such as Ollama on this machine.
        </p>
        <label>
          <span>Address</span>
          <input
            value={baseUrl}
            spellcheck={false}
            placeholder="http://127.0.0.1:11434/v1"
            onInput={(event) => setBaseUrl(event.currentTarget.value)}
          />
        </label>
        <label>
          <span>Model</span>
          <input
            value={model}
            spellcheck={false}
            placeholder="llama3.1"
            onInput={(event) => setModel(event.currentTarget.value)}
          />
        </label>
        <label>
          <span>Key</span>
          <input
            value={apiKey}
            type="password"
            autocomplete="off"
            placeholder={now.hasKey ? "kept in memory; leave empty to go without" : "none"}
            onInput={(event) => setApiKey(event.currentTarget.value)}
          />
        </label>
        {problem && (
          <p class="say-remark" role="alert">
            {problem}
          </p>
        )}
        <div class="dialog-foot">
          <button type="button" class="button" onClick={() => void choose({ baseUrl: "", model: "", apiKey: "" })}>
            Use the handbook
          </button>
          <button
            type="button"
            class="button is-primary"
            disabled={!baseUrl || !model}
            onClick={() => void choose({ baseUrl, model, apiKey })}
          >
            Use this model
          </button>
        </div>
      </div>
    </Dialog>
  );
}
