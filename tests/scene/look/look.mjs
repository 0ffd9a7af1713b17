// SPDX-License-Identifier: GPL-3.0-or-later
// Shows GLB files in headless Chromium with three.js, as a viewer without settings would, and saves what it sees. By
// hand, to look at; Debian's chromium must be installed. Usage, in this folder:
//   npm ci
//   node look.mjs OUT_FOLDER [--camera NAME|orbit|front]... [--size PIXELS] [--bare] FILE.glb...
// A camera is one of the file's own ("birdseye", "perspective"), "orbit" (from the south, above) or "front" (straight at
// what the file holds, along -z: what an asset's front looks like). --bare leaves out the viewer's own light.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {chromium} from 'playwright-core';

const folder = path.dirname(fileURLToPath(import.meta.url));
const options = {cameras: [], size: 1024, bare: false};
const names = [];
for (let args = process.argv.slice(2); args.length > 0;) {
  const arg = args.shift();
  if (arg === '--camera') options.cameras.push(args.shift());
  else if (arg === '--size') options.size = Number(args.shift());
  else if (arg === '--bare') options.bare = true;
  else names.push(arg);
}
const [out, ...files] = names;
if (files.length === 0) {
  console.error('usage: node look.mjs OUT_FOLDER [--camera NAME]... [--size PIXELS] [--bare] FILE.glb...');
  process.exit(2);
}
if (options.cameras.length === 0) options.cameras = ['birdseye', 'perspective', 'orbit'];

const page = `<!doctype html><style>body{margin:0}</style><script type="importmap">
{"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {RoomEnvironment} from 'three/addons/environments/RoomEnvironment.js';
window.show = async (url, cameraName, bare) => {
  const gltf = await new GLTFLoader().loadAsync(url);
  const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
  renderer.setSize(innerWidth, innerHeight);
  renderer.toneMapping = THREE.NeutralToneMapping;
  document.body.replaceChildren(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xf4f4f2);
  if (!bare) {
    scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
    scene.environmentIntensity = 0.35;
  }
  scene.add(gltf.scene);
  scene.updateMatrixWorld(true);
  const box = new THREE.Box3().setFromObject(gltf.scene);
  const middle = box.getCenter(new THREE.Vector3());
  const extent = box.getSize(new THREE.Vector3()).length();
  let camera = gltf.cameras.find((c) => c.name === cameraName || c.parent?.name === cameraName);
  if (!camera) {
    camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
    const from = cameraName === 'front' ? [0, 0.25, 1] : [0.45, 1.1, 0.9];
    camera.position.copy(middle).addScaledVector(new THREE.Vector3(...from).normalize(), extent * 1.5);
    camera.lookAt(middle);
  }
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  renderer.render(scene, camera);
  return {triangles: renderer.info.render.triangles, calls: renderer.info.render.calls,
          size_m: box.getSize(new THREE.Vector3()).toArray(), png: renderer.domElement.toDataURL('image/png')};
};
window.ready = true;
</script>`;

const server = http.createServer((request, response) => {
  if (request.url === '/favicon.ico') return response.writeHead(204).end();
  if (request.url === '/') return response.setHeader('content-type', 'text/html').end(page);
  const asset = request.url.startsWith('/three/') ? path.join(folder, 'node_modules', request.url)
                                                  : files[Number(request.url.slice(1))];
  if (!asset || !fs.existsSync(asset)) return response.writeHead(404).end();
  if (asset.endsWith('.js')) response.setHeader('content-type', 'text/javascript');
  response.end(fs.readFileSync(asset));
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
const tab = await browser.newPage({viewport: {width: options.size, height: options.size}});
tab.on('console', (message) => console.error('console:', message.text()));
tab.on('pageerror', (error) => console.error('page:', error.message));
await tab.goto(`http://127.0.0.1:${server.address().port}/`);
await tab.waitForFunction('window.ready');
fs.mkdirSync(out, {recursive: true});
for (const [number, file] of files.entries()) {
  for (const camera of options.cameras) {
    const {png, ...seen} =
        await tab.evaluate(([n, c, bare]) => window.show('/' + n, c, bare), [number, camera, options.bare]);
    const picture = path.join(out, `${path.basename(file, '.glb')}_${camera}.png`);
    fs.writeFileSync(picture, Buffer.from(png.split(',')[1], 'base64'));
    console.log(picture, JSON.stringify(seen));
  }
}
await browser.close();
server.close();
