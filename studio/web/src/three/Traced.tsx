// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useRef, useState } from "preact/hooks";
import { Dialog } from "../app/Dialog";
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { viewCameraOf, type Sight } from "./camera";

type From = "view" | "above" | "within";

const labels: Record<From, string> = { view: "As in the view", above: "Bird's-eye", within: "Eye level" };

interface TracedProps {
  room: OpenRoom;
  // What the view shows; undefined where it shows nothing.
  sight: Sight | undefined;
  isWithin: boolean;
  onClose(): void;
}

// How long it has been, for as long as it lasts.
function Waiting() {
  const [seconds, setSeconds] = useState(0);
  useEffect(() => {
    const timer = setInterval(() => setSeconds((before) => before + 1), 1000);
    return () => clearInterval(timer);
  }, []);
  return (
    <p class="hint traced-wait" role="status">
      <span class="spinner" />
      Following the light through the room; that takes some seconds{seconds > 2 ? ` (${seconds})` : ""}.
    </p>
  );
}

// A ray-traced picture in a dialog, which has its size from the beginning.
export function Traced({ room, sight, isWithin, onClose }: TracedProps) {
  const studio = useStudio();
  const [from, setFrom] = useState<From>(sight ? "view" : "above");
  const [addresses, setAddresses] = useState<Partial<Record<From, string>>>({});
  const made = useRef<string[]>([]);
  useEffect(() => () => made.current.forEach((one) => URL.revokeObjectURL(one)), []);
  useEffect(() => {
    if (addresses[from]) return;
    let isEnded = false;
    const format = from === "within" || (from === "view" && isWithin)
      ? DocumentFormat.PERSPECTIVE_PNG : DocumentFormat.BIRDSEYE_PNG;
    const options = from === "view" && sight ? { camera: viewCameraOf(sight) } : undefined;
    void studio.told(() => studio.clients.studio.exportDocument({ documentId: room.id, format, options }))
      .then((file) => {
        if (isEnded) return;
        if (!file) return onClose();
        const address = URL.createObjectURL(new Blob([file.content as BlobPart], { type: file.mediaType }));
        made.current.push(address);
        setAddresses((before) => ({ ...before, [from]: address }));
      });
    return () => { isEnded = true; };
  }, [from]);
  const address = addresses[from];
  return (
    <Dialog title="Ray-traced picture" class="traced" onClose={onClose}>
      <div class="traced-choice">
        <div class="segmented" role="group" aria-label="From where">
          {(Object.keys(labels) as From[]).filter((one) => one !== "view" || sight).map((one) => (
            <button key={one} aria-pressed={from === one} onClick={() => setFrom(one)}>{labels[one]}</button>
          ))}
        </div>
        {address && <a class="button" href={address} download={`${room.document.value.title}, ray-traced.png`}>Save</a>}
      </div>
      <div class="traced-picture">
        {address
          ? <img src={address} alt={`${room.document.value.title}, ray-traced`}
              style={{ aspectRatio: `${from === "view" && sight ? Math.max(sight.aspect, 1) : 1}` }} />
          : <Waiting />}
      </div>
    </Dialog>
  );
}
