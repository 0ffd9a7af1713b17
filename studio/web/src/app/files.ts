// SPDX-License-Identifier: GPL-3.0-or-later
import type { Studio } from "../state/studio";

// Gives the user a file, as browsers do it.
export function save(name: string, type: string, content: Uint8Array): void {
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = Object.assign(document.createElement("a"), { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export const kAccepted = ".pb,.json";
// The server takes no larger ones.
const kLargest = 16 << 20;

// A new document of a file; the server says what is wrong with it.
export async function openFile(studio: Studio, file: File): Promise<void> {
  if (file.size > kLargest) return studio.toasts.error(`${file.name} is larger than ${kLargest >> 20} MB.`);
  const content = new Uint8Array(await file.arrayBuffer());
  await studio.create({ case: "file", value: content });
}

export function chooseFile(studio: Studio): void {
  const input = Object.assign(document.createElement("input"), { type: "file", accept: kAccepted });
  input.addEventListener("change", () => { if (input.files?.[0]) void openFile(studio, input.files[0]); });
  input.click();
}
