// SPDX-License-Identifier: GPL-3.0-or-later
// Walking: W, A, S, D and the up and down arrows go, with Shift faster; left and right arrows turn; dragging looks around.
// A tap is a step.
import { Euler, Vector3, type Camera } from "three";
import type { Vec } from "../geometry/vec";

// Metres and radians a second: as one strolls, and as one hurries.
const kSpeed = 1.4;
const kFast = 3.5;
const kTurn = Math.PI / 3;
// Of a tap, however short.
const kStep = 0.1;
const kStepTurn = Math.PI / 36;
// A picture that takes longer slows the walk, so that nobody runs through walls unseen.
const kLongestStep = 0.25;
const kTurnPerPixel = 0.0035;

// To the right, back, and turned to the left.
const directions: Record<string, readonly [number, number, number]> = {
  KeyW: [0, -1, 0],
  ArrowUp: [0, -1, 0],
  KeyS: [0, 1, 0],
  ArrowDown: [0, 1, 0],
  KeyA: [-1, 0, 0],
  KeyD: [1, 0, 0],
  ArrowLeft: [0, 0, 1],
  ArrowRight: [0, 0, -1],
};

export class Walk {
  // Where one may stand, of a place in the room.
  allowed: (at: Vec) => Vec = (at) => at;
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
    private readonly onStep: () => void,
  ) {}

  get isWalking(): boolean {
    return this.isOn;
  }

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
    if (event.repeat && this.held.has(event.code)) return;
    this.held.add(event.code);
    this.go([event.code], kStep, kStepTurn);
    this.onStep();
    if (this.frame) return;
    this.last = performance.now();
    this.frame = requestAnimationFrame((now) => this.step(now));
  }

  private look(event: PointerEvent): void {
    if (event.buttons !== 1) return;
    this.turn(event.movementX * kTurnPerPixel, event.movementY * kTurnPerPixel);
    this.draw();
  }

  private turn(by: number, up = 0): void {
    const angles = new Euler().setFromQuaternion(this.camera.quaternion, "YXZ");
    angles.y += by;
    angles.x = Math.max(-1.2, Math.min(1.2, angles.x + up));
    this.camera.quaternion.setFromEuler(angles);
  }

  private go(codes: Iterable<string>, metres: number, angle: number): void {
    const by = new Vector3();
    let turn = 0;
    for (const code of codes) {
      const [right, back, left] = directions[code]!;
      by.add(new Vector3(right, 0, back));
      turn += left;
    }
    if (turn) this.turn(turn * angle);
    const heading = new Euler().setFromQuaternion(this.camera.quaternion, "YXZ").y;
    by.normalize().multiplyScalar(metres).applyAxisAngle(new Vector3(0, 1, 0), heading);
    const { position } = this.camera;
    // The view's frame has south as z.
    const { x, y } = this.allowed({ x: position.x + by.x, y: -(position.z + by.z) });
    position.set(x, position.y, -y);
    this.draw();
  }

  private step(now: number): void {
    this.frame = 0;
    if (this.held.size === 0) return;
    const seconds = Math.min((now - this.last) / 1000, kLongestStep);
    this.last = now;
    this.go(this.held, (this.isFast ? kFast : kSpeed) * seconds, kTurn * seconds);
    this.frame = requestAnimationFrame((next) => this.step(next));
  }
}
