// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from "preact/hooks";
import { Dialog } from "../app/Dialog";
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";

const views = [
  { format: DocumentFormat.BIRDSEYE_PNG, label: "From above" },
  { format: DocumentFormat.PERSPECTIVE_PNG, label: "From within" },
];

// A ray-traced picture in a dialog.
export function Traced({ room, onClose }: { room: OpenRoom; onClose(): void }) {
  const studio = useStudio();
  const [format, setFormat] = useState(DocumentFormat.BIRDSEYE_PNG);
  const [address, setAddress] = useState("");
  useEffect(() => {
    let made = "", isEnded = false;
    setAddress("");
    void studio.told(() => studio.clients.studio.exportDocument({ documentId: room.id, format })).then((file) => {
      if (isEnded) return;
      if (!file) return onClose();
      made = URL.createObjectURL(new Blob([file.content as BlobPart], { type: file.mediaType }));
      setAddress(made);
    });
    return () => {
      isEnded = true;
      URL.revokeObjectURL(made);
    };
  }, [format]);
  return (
    <Dialog title="Ray-traced view" class="traced" onClose={onClose}>
      <div class="traced-choice">
        <div class="segmented" role="group" aria-label="From where">
          {views.map((one) => (
            <button key={one.format} aria-pressed={format === one.format} onClick={() => setFormat(one.format)}>
              {one.label}
            </button>
          ))}
        </div>
      </div>
      <div class="traced-picture">
        {address ? <img src={address} alt={`${room.document.value.title}, ray-traced`} />
          : <p class="hint"><span class="spinner" />Tracing; this takes some seconds.</p>}
      </div>
    </Dialog>
  );
}
