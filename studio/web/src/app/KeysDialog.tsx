// SPDX-License-Identifier: GPL-3.0-or-later
import { signal } from "@preact/signals";
import { Dialog } from "./Dialog";

export const isShowingKeys = signal(false);

const groups: Array<[string, Array<[string, string]>]> = [
  [
    "Select",
    [
      ["Click", "one piece"],
      ["Click again", "what carries it"],
      ["Shift click", "add or take away"],
      ["Drag on the floor", "all that is touched"],
      ["Ctrl A", "everything"],
      ["Tab", "the next piece"],
      ["Esc", "nothing"],
    ],
  ],
  [
    "Move",
    [
      ["Drag", "snaps; with Alt it does not, with Shift along one axis"],
      ["Arrows", "1 cm"],
      ["Shift arrows", "10 cm"],
      ["R, T", "turn by 90° clockwise, counter-clockwise"],
      ["Enter, click a distance", "type another one; Tab goes to the next"],
    ],
  ],
  [
    "Change",
    [
      ["Ctrl D", "duplicate"],
      ["Ctrl C, Ctrl V", "copy, paste"],
      ["Delete", "remove"],
      ["L", "lock or unlock"],
      ["S", "settle: the others make room for what was moved"],
      ["O", "other layouts of the same pieces"],
      ["Auto", "settles after every change"],
      ["Ctrl Z, Ctrl Shift Z", "undo, redo"],
    ],
  ],
  [
    "Look",
    [
      ["Scroll, space drag", "pan"],
      ["Ctrl scroll, + and -", "zoom"],
      ["0, double click", "the whole room"],
      ["1, 2, 3", "plan, both, 3D"],
      ["W A S D, arrows, drag", "walk (with Shift faster), turn and look around, in 3D"],
      ["Double click the floor", "look from there, in 3D"],
      ["F", "furniture"],
      ["[", "sidebar"],
      ["U", "metres or feet"],
    ],
  ],
  [
    "Draw a room",
    [
      ["Click", "the next corner; Alt frees it"],
      ["Arrows, 3.2 Enter", "a wall that way, that long"],
      ["Enter", "close the walls"],
      ["D, W, E", "door, window, socket"],
      ["Double click", "a corner on a wall"],
      ["Delete", "remove what is selected"],
    ],
  ],
];

export function KeysDialog() {
  if (!isShowingKeys.value) return null;
  return (
    <Dialog title="Keys" class="keys-dialog" onClose={() => { isShowingKeys.value = false; }}>
      <div class="key-groups">
        {groups.map(([name, keys]) => (
          <section key={name}>
            <h3>{name}</h3>
            <dl>{keys.map(([key, what]) => [<dt><kbd>{key}</kbd></dt>, <dd>{what}</dd>])}</dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
