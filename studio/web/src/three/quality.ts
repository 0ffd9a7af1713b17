// SPDX-License-Identifier: GPL-3.0-or-later
// How finely the view is drawn: as well as a graphics card can; without one, plainly at rest and coarsely while it moves.
import {
  ACESFilmicToneMapping, Mesh, MeshLambertMaterial, MeshStandardMaterial, PMREMGenerator, WebGLRenderer,
  type Material, type Object3D, type Scene,
} from "three";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
import { drawsInSoftware } from "./software";

// What moves again within this time is moving.
const kRest_ms = 220;
const kMoving = 0.5;

function plain(material: Material): Material {
  if (!(material instanceof MeshStandardMaterial)) return material;
  const { name, color, map, emissive, emissiveMap, emissiveIntensity, transparent, opacity, side, alphaTest,
    vertexColors, depthWrite } = material;
  const lambert = new MeshLambertMaterial({ name, color, map, emissive, emissiveMap, emissiveIntensity, transparent,
    opacity, side, alphaTest, vertexColors, depthWrite });
  // Metals have no light of their own but what they mirror.
  if (material.metalness > 0.5) lambert.color.addScalar(0.12);
  return lambert;
}

export class Quality {
  readonly renderer: WebGLRenderer;
  readonly isSoftware = drawsInSoftware();
  private last = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(scene: Scene) {
    this.renderer = new WebGLRenderer({ antialias: !this.isSoftware, alpha: true });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.05;
    this.renderer.setPixelRatio(this.isSoftware ? 1 : Math.min(devicePixelRatio, 2));
    if (this.isSoftware) return;
    scene.environment = new PMREMGenerator(this.renderer).fromScene(new RoomEnvironment(), 0.04).texture;
    scene.environmentIntensity = 0.55;
  }

  // Of lights that come from everywhere: mirrored surroundings make up for the rest.
  get ambience(): number {
    return this.isSoftware ? 2.7 : 1;
  }

  // A model as it is drawn.
  prepare(model: Object3D): void {
    if (!this.isSoftware) return;
    model.traverse((node) => {
      if (!(node instanceof Mesh)) return;
      node.material = Array.isArray(node.material) ? node.material.map(plain) : plain(node.material as Material);
    });
  }

  // Before a picture is drawn; `again` draws it once more, finely, when nothing moves any longer.
  begin(again: () => void): void {
    if (!this.isSoftware) return;
    const now = performance.now(), isMoving = now - this.last < kRest_ms;
    clearTimeout(this.timer);
    if (isMoving) this.timer = setTimeout(() => { this.last = -Infinity; again(); }, kRest_ms);
    const ratio = isMoving ? kMoving : 1;
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
  }

  // After it.
  end(): void {
    this.last = performance.now();
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }
}
