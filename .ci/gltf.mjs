// Judges glTF files by Khronos's validator and by three.js. Both are found in the folder of modules that the first argument names.
//
// `node gltf.mjs MODULES valid FILE…`: no errors and no warnings.
// `node gltf.mjs MODULES plays FILE SAMPLES DEGREES UNITS`: three.js shows every node within these of what
// `inbetween sample --space world --fps N` says in SAMPLES.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, task, ...rest] = process.argv.slice(2);
const load = name => import(pathToFileURL(path.resolve(modules, 'node_modules', name)));

function fail(sentence) {
  console.error(`judges: ${sentence}`);
  process.exit(1);
}

async function valid(files) {
  const { default: validator } = await load('gltf-validator/index.js');
  for (const file of files) {
    const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 0 });
    if (issues.numErrors + issues.numWarnings > 0) fail(`${file}: ${JSON.stringify(issues.messages.slice(0, 5))}`);
  }
  console.log(`${files.length} files by Khronos's validator: no errors, no warnings`);
}

async function plays(file, samples, degrees, units) {
  globalThis.self = globalThis;
  const three = await load('three/build/three.module.js');
  const { GLTFLoader } = await load('three/examples/jsm/loaders/GLTFLoader.js');
  const bytes = fs.readFileSync(file);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const { scene, animations } = await new GLTFLoader().parseAsync(buffer, '');
  const byPath = new Map();
  scene.traverse(node => byPath.set(node.userData.inbetween?.path, node));
  const mixer = new three.AnimationMixer(scene);
  for (const clip of animations) {
    const action = mixer.clipAction(clip).setLoop(three.LoopOnce, 1);
    action.clampWhenFinished = true;
    action.play();
  }
  const parts = matrix => {
    const [place, turn, scale] = [new three.Vector3(), new three.Quaternion(), new three.Vector3()];
    matrix.decompose(place, turn, scale);
    return { place, turn };
  };
  const { nodes, frames } = JSON.parse(fs.readFileSync(samples));
  const worst = { degrees: 0, units: 0 };
  for (const frame of frames) {
    mixer.setTime(frame.ms / 1000);
    scene.updateMatrixWorld(true);
    nodes.forEach((name, index) => {
      const node = byPath.get(name);
      if (!node) fail(`${file}: three.js has no node ${name}`);
      const here = parts(new three.Matrix4().fromArray(frame.world_from_node[index]));
      const there = parts(node.matrixWorld);
      // The angle by the chord, which is exact for small ones; a quaternion and its negative are one rotation.
      const chord = sign => Math.hypot(...here.turn.toArray().map((part, at) => part - sign * there.turn.toArray()[at]));
      const angle = 4 * Math.asin(Math.min(chord(1), chord(-1)) / 2) * 180 / Math.PI;
      worst.degrees = Math.max(worst.degrees, angle);
      worst.units = Math.max(worst.units, here.place.distanceTo(there.place));
    });
  }
  const found = `${worst.degrees.toFixed(5)} degrees and ${worst.units.toFixed(6)} units in the world`;
  if (frames.length < 100 || worst.degrees > degrees || worst.units > units) fail(`${file}: three.js is off by ${found}`);
  console.log(`${path.basename(file)} by three.js r${three.REVISION} at ${frames.length} times: within ${found}`);
}

if (task === 'valid') await valid(rest);
else await plays(rest[0], rest[1], Number(rest[2]), Number(rest[3]));
