// SPDX-License-Identifier: GPL-3.0-or-later
// Walking: W, A, S, D or arrows go, with Shift faster; dragging looks around.
import { Euler, Vector3, type Box3, type Camera } from "three";

// Metres a second: as one strolls, and as one hurries.
const kSpeed = 1.4;
const kFast = 3.5;
// A picture that takes longer slows the walk, so that nobody runs through walls unseen.
const kLongestStep = 0.25;
const kTurnPerPixel = 0.0035;
const kMargin = 0.25;

const directions: Record<string, [number, number]> = {
  KeyW: [0, -1],
  ArrowUp: [0, -1],
  KeyS: [0, 1],
  ArrowDown: [0, 1],
  KeyA: [-1, 0],
  ArrowLeft: [-1, 0],
  KeyD: [1, 0],
  ArrowRight: [1, 0],
};

export class Walk {
  bounds: Box3 | undefined;
  private readonly held = new Set<string>();
  private frame = 0;
  private last = 0;
  private isOn = false;
  private isFast = false;
  private ending = new AbortController();

  constructor(
    private readonly camera: Camera,
    private readonly canvas: HTMLElement,
    private readonly draw: () => void,
  ) {}

  start(): void {
    if (this.isOn) return;
    this.isOn = true;
    this.ending = new AbortController();
    const { signal } = this.ending;
    addEventListener("keydown", (event) => this.down(event), { signal, capture: true });
    addEventListener("keyup", (event) => {
      this.isFast = event.shiftKey;
      this.held.delete(event.code);
    }, { signal });
    addEventListener("blur", () => this.held.clear(), { signal });
    this.canvas.addEventListener("pointerdown", (event) => this.canvas.setPointerCapture(event.pointerId), { signal });
    this.canvas.addEventListener("pointermove", (event) => this.look(event), { signal });
  }

  stop(): void {
    this.isOn = false;
    this.ending.abort();
    this.held.clear();
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private down(event: KeyboardEvent): void {
    const isTyping = /^(INPUT|TEXTAREA)$/.test((event.target as HTMLElement).tagName);
    this.isFast = event.shiftKey;
    if (!directions[event.code] || isTyping || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.held.add(event.code);
    if (this.frame) return;
    this.last = performance.now();
    this.frame = requestAnimationFrame((now) => this.step(now));
  }

  private look(event: PointerEvent): void {
    if (event.buttons !== 1) return;
    const angles = new Euler().setFromQuaternion(this.camera.quaternion, "YXZ");
    angles.y += event.movementX * kTurnPerPixel;
    angles.x = Math.max(-1.2, Math.min(1.2, angles.x + event.movementY * kTurnPerPixel));
    this.camera.quaternion.setFromEuler(angles);
    this.draw();
  }

  private step(now: number): void {
    this.frame = 0;
    if (this.held.size === 0) return;
    const seconds = Math.min((now - this.last) / 1000, kLongestStep);
    this.last = now;
    const by = new Vector3();
    for (const code of this.held) by.add(new Vector3(directions[code]![0], 0, directions[code]![1]));
    const heading = new Euler().setFromQuaternion(this.camera.quaternion, "YXZ").y;
    by.normalize().multiplyScalar((this.isFast ? kFast : kSpeed) * seconds).applyAxisAngle(new Vector3(0, 1, 0), heading);
    this.camera.position.add(by);
    if (this.bounds) {
      const { min, max } = this.bounds;
      this.camera.position.x = Math.min(max.x - kMargin, Math.max(min.x + kMargin, this.camera.position.x));
      this.camera.position.z = Math.min(max.z - kMargin, Math.max(min.z + kMargin, this.camera.position.z));
    }
    this.draw();
    this.frame = requestAnimationFrame((next) => this.step(next));
  }
}
