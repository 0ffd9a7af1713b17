// SPDX-License-Identifier: GPL-3.0-or-later
// The furnished room in three.js: what is loaded, lit, looked at and selected. Draws only when something changed.
import {
  AmbientLight, Box3, BoxHelper, Color, DirectionalLight, Group, HemisphereLight, Mesh, PerspectiveCamera, Raycaster,
  Scene, TextureLoader, Vector2, Vector3, type Intersection, type Light, type Object3D, type Quaternion,
} from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import type { Room } from "../gen/flair/v1/room_pb";
import { cornersOf, type Pieces } from "../state/pieces";
import type { Sight } from "./camera";
import { Quality } from "./quality";
import { atDoor, keptInside, onFloor, wallBehind, wallsInTheWay, type Stand } from "./places";
import { Walk } from "./walk";

export type Mode = "orbit" | "walk";

const kOrbitAngle = 50;
const kWalkAngle = 72;
// Nearer than this nothing is drawn: as far as one may be, for what lies close together is then told apart.
const kOrbitNear = 0.5;
const kWalkNear = 0.05;
const kOnFloor = 0.06;

// What the view needs to know of the room that it shows.
export interface Furnished {
  readonly room: Room;
  readonly pieces: Pieces;
}

// Where one looked from when the view was last open.
export interface Remembered {
  mode: Mode;
  walk?: { readonly position: Vector3; readonly rotation: Quaternion };
}

export interface ViewHost {
  readonly furnished: () => Furnished | undefined;
  readonly remembered: Remembered;
  onPick(id: string, isAdding: boolean): void;
  onMode(mode: Mode): void;
  onStep(): void;
}

// Pictures in the file are read by <img>: the page's policy lets nothing else read them.
function makeLoader(): GLTFLoader {
  const loader = new GLTFLoader();
  loader.register((parser) => {
    parser.textureLoader = new TextureLoader(parser.options.manager);
    return { name: "FLAIR_pictures" };
  });
  return loader;
}

function release(root: Object3D): void {
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    node.geometry.dispose();
    for (const material of [node.material].flat()) {
      material.map?.dispose();
      material.dispose();
    }
  });
}

// Furniture is a node of that name, with a node an object. Names are no ids: the loader changes those that parts of other
// pieces have.
const idOf = (node: Object3D): string => String(node.userData.id ?? node.name);

// The piece that a mesh belongs to.
function pieceOf(node: Object3D | null): string {
  for (let one = node; one; one = one.parent) if (one.parent?.name === "furniture") return idOf(one);
  return "";
}

export class View3d {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(kOrbitAngle, 1, 0.05, 200);
  private readonly quality = new Quality(this.scene);
  private readonly orbit: OrbitControls;
  private readonly walk: Walk;
  private readonly marks = new Group();
  private readonly loader = makeLoader();
  private model: Object3D | undefined;
  private selected: ReadonlySet<string> = new Set();
  private mode: Mode;
  private frame = 0;
  private loads = 0;

  // Throws where the browser has no WebGL.
  constructor(private readonly host: HTMLElement, private readonly owner: ViewHost) {
    this.mode = owner.remembered.mode;
    const canvas = this.quality.renderer.domElement, { ambience } = this.quality;
    host.prepend(canvas);
    const sun = new DirectionalLight(0xfff3e0, 1.6);
    sun.position.set(3, 6, 4);
    this.scene.add(new HemisphereLight(0xffffff, 0xb8a890, 0.6 * ambience),
      new AmbientLight(0xffffff, 0.15 * ambience), sun, this.marks);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.maxPolarAngle = Math.PI * 0.49;
    this.orbit.addEventListener("change", () => this.draw());
    this.walk = new Walk(this.camera, canvas, () => this.draw(), () => owner.onStep());
    this.listenToPicks();
    this.resize();
  }

  async load(content: Uint8Array): Promise<void> {
    const load = ++this.loads;
    const buffer = content.slice().buffer;
    const { scene } = await this.loader.parseAsync(buffer, "");
    if (load !== this.loads) return release(scene);
    const isFirst = !this.model;
    if (this.model) {
      this.scene.remove(this.model);
      release(this.model);
    }
    this.model = scene;
    this.quality.prepare(scene);
    // The file's lights are for engines with exposure; here the room is lit evenly, and lamps only glow.
    scene.traverse((node) => { if ((node as Light).isLight) node.visible = false; });
    this.scene.add(scene);
    if (isFirst) this.setMode(this.mode);
    this.mark();
  }

  setMode(mode: Mode): void {
    this.remember();
    this.mode = this.owner.remembered.mode = mode;
    this.orbit.enabled = mode === "orbit";
    this.camera.fov = mode === "walk" ? kWalkAngle : kOrbitAngle;
    this.camera.near = mode === "walk" ? kWalkNear : kOrbitNear;
    this.camera.updateProjectionMatrix();
    if (mode === "orbit") {
      this.walk.stop();
      this.lookFromAbove();
    } else {
      this.goOnWalking();
      this.walk.start();
    }
    this.draw();
  }

  // Looks from there, walking.
  lookFrom({ eye, target }: Stand): void {
    if (this.mode !== "walk") this.setMode("walk");
    this.camera.position.set(eye.x, eye.z, -eye.y);
    this.camera.lookAt(target.x, target.z, -target.y);
    this.mark();
  }

  // Where one was before, or else at the door.
  private goOnWalking(): void {
    const furnished = this.owner.furnished(), { walk } = this.owner.remembered;
    if (!furnished) return;
    const floor = cornersOf(furnished.room);
    this.walk.allowed = (at) => keptInside(floor, at);
    if (!walk) return this.lookFrom(atDoor(furnished.room));
    this.camera.position.copy(walk.position);
    this.camera.quaternion.copy(walk.rotation);
  }

  private remember(): void {
    if (this.mode !== "walk" || !this.model || !this.walk.isWalking) return;
    this.owner.remembered.walk = {
      position: this.camera.position.clone(), rotation: this.camera.quaternion.clone(),
    };
  }

  // From outside, walls that are in the way are left out, with all that is in them and on them; so is the ceiling, but not
  // what hangs from it.
  private clearTheView(): void {
    const furnished = this.owner.furnished(), { model } = this;
    if (!furnished || !model) return;
    const { room, pieces } = furnished, { position } = this.camera, isWithin = this.mode === "walk";
    const away = isWithin ? new Set<string>() : wallsInTheWay(room, { x: position.x, y: -position.z });
    for (const node of model.getObjectByName("shell")?.children ?? []) {
      node.visible = idOf(node) === "ceiling" ? isWithin : !away.has(node.userData.wall);
    }
    for (const node of model.getObjectByName("furniture")?.children ?? []) {
      const piece = pieces.get(idOf(node));
      if (piece?.object.kind === ObjectKind.WALL) node.visible = away.size === 0 || !away.has(wallBehind(piece, room));
    }
  }

  select(ids: ReadonlySet<string>): void {
    this.selected = ids;
    this.mark();
  }

  // What is seen just now.
  get sight(): Sight {
    const { position, fov, aspect } = this.camera;
    const ahead = this.camera.getWorldDirection(new Vector3());
    const target = this.mode === "orbit" ? this.orbit.target : ahead.add(position);
    return { eye: position.clone(), target: target.clone(), angle: fov, aspect };
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.quality.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  dispose(): void {
    this.remember();
    this.loads += 1;
    cancelAnimationFrame(this.frame);
    this.walk.stop();
    this.orbit.dispose();
    if (this.model) release(this.model);
    this.quality.dispose();
  }

  private draw(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.quality.begin(() => this.draw());
      this.clearTheView();
      this.quality.renderer.render(this.scene, this.camera);
      this.quality.end();
    });
  }

  private boxOfRoom(): Box3 {
    return new Box3().setFromObject(this.model?.getObjectByName("floor") ?? this.scene);
  }

  private lookFromAbove(): void {
    const box = this.boxOfRoom(), middle = box.getCenter(new Vector3()), size = box.getSize(new Vector3());
    // So far that a ball around the room is in the picture, whichever way that is narrow.
    const height = new Box3().setFromObject(this.model ?? this.scene).max.y;
    const radius = Math.hypot(size.x, size.z, height) / 2;
    const half = (this.camera.fov * Math.PI) / 360;
    const away = radius / Math.sin(Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect)));
    this.orbit.target.copy(middle).setY(height / 2);
    this.camera.position.copy(this.orbit.target).addScaledVector(new Vector3(0.34, 1, 0.82).normalize(), away);
    this.orbit.update();
    this.draw();
  }

  private mark(): void {
    this.marks.clear();
    for (const id of this.selected) {
      const node = this.model?.getObjectByName("furniture")?.children.find((one) => idOf(one) === id);
      // Nor of what one looks out of.
      const isAround = this.mode === "walk" && node &&
        new Box3().setFromObject(node).expandByScalar(0.4).containsPoint(this.camera.position);
      if (node && !isAround) this.marks.add(new BoxHelper(node, new Color(0x19a0a4)));
    }
    this.draw();
  }

  private listenToPicks(): void {
    const canvas = this.quality.renderer.domElement;
    let from = new Vector2();
    canvas.addEventListener("pointerdown", (event) => { from = new Vector2(event.clientX, event.clientY); });
    canvas.addEventListener("pointerup", (event) => {
      if (event.button !== 0 || from.distanceTo(new Vector2(event.clientX, event.clientY)) > 4) return;
      const hit = this.hitAt(event);
      if (hit) this.owner.onPick(pieceOf(hit.object), event.shiftKey);
      else if (this.model) this.owner.onPick("", event.shiftKey);
    });
    // A double click on the floor goes there.
    canvas.addEventListener("dblclick", (event) => {
      const hit = this.hitAt(event), furnished = this.owner.furnished();
      if (!hit || hit.point.y > kOnFloor || !furnished) return;
      const ahead = this.camera.getWorldDirection(new Vector3());
      this.lookFrom(onFloor(cornersOf(furnished.room), { x: hit.point.x, y: -hit.point.z }, { x: ahead.x, y: -ahead.z }));
      this.owner.onMode("walk");
    });
  }

  private hitAt(event: MouseEvent): Intersection | undefined {
    if (!this.model) return undefined;
    const box = this.quality.renderer.domElement.getBoundingClientRect();
    const at = new Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      1 - ((event.clientY - box.top) / box.height) * 2,
    );
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray.intersectObject(this.model, true).find(({ object }) => object.visible && this.isSeen(object));
  }

  private isSeen(node: Object3D): boolean {
    for (let one: Object3D | null = node; one; one = one.parent) if (!one.visible) return false;
    return true;
  }
}
