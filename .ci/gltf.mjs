// Judges glTF files by Khronos's validator and by three.js. Both are found in the folder of modules that the first argument names.
//
// `node gltf.mjs MODULES valid FILE…`: no errors and no warnings.
// `node gltf.mjs MODULES plays FILE SAMPLES DEGREES UNITS`: three.js shows every node within these of what
// `inbetween sample --space world --fps N` says in SAMPLES. Nodes of skinned meshes are left out: joints alone place what they show.
// `node gltf.mjs MODULES shows MODEL EXPORT SECONDS UNITS`: what MODEL shows until then, EXPORT shows too, triangle by triangle,
// with every corner within these.
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

async function played(file) {
  globalThis.self = globalThis;
  // Data URIs are fetched, and node has no events of that.
  globalThis.ProgressEvent ??= class extends Event {};
  const three = await load('three/build/three.module.js');
  const { GLTFLoader } = await load('three/examples/jsm/loaders/GLTFLoader.js');
  const bytes = fs.readFileSync(file);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const { scene, animations } = await new GLTFLoader().parseAsync(buffer, '');
  const mixer = new three.AnimationMixer(scene);
  // Of several animations an import takes the first.
  const actions = animations.slice(0, 1).map(clip => mixer.clipAction(clip).setLoop(three.LoopOnce, 1));
  const at = seconds => {
    // One that was at its end is paused there.
    for (const action of actions) {
      action.reset().play();
      action.clampWhenFinished = true;
    }
    mixer.setTime(seconds);
    scene.updateMatrixWorld(true);
  };
  return { three, scene, at };
}

// How far two world matrices are apart, as columns: scales above a turn make axes that are at no right angles, so nothing is decomposed.
// The angle is the rotation's where both are rotations, and at least that of the worst axis.
function apart(a, b) {
  const column = (matrix, at) => matrix.slice(4 * at, 4 * at + 3);
  const length = vector => Math.hypot(...vector);
  const chords = [0, 1, 2].map(axis => {
    const [one, other] = [a, b].map(matrix => column(matrix, axis).map(part => part / length(column(matrix, axis))));
    return length(one.map((part, at) => part - other[at]));
  });
  const degrees = Math.max(length(chords) / Math.SQRT2, ...chords);
  const lengths = [0, 1, 2].map(axis => Math.abs(length(column(a, axis)) / length(column(b, axis)) - 1));
  return {
    degrees: 2 * Math.asin(Math.min(degrees / 2, 1)) * 180 / Math.PI,
    units: length(column(a, 3).map((part, at) => part - column(b, 3)[at])),
    scale: Math.max(...lengths),
  };
}

async function plays(file, samples, degrees, units) {
  const { three, scene, at } = await played(file);
  const byPath = new Map();
  scene.traverse(node => byPath.set(node.userData.inbetween?.path, node));
  const { nodes, frames } = JSON.parse(fs.readFileSync(samples));
  const worst = { degrees: 0, units: 0, scale: 0 };
  let compared = 0;
  for (const frame of frames) {
    at(frame.ms / 1000);
    nodes.forEach((name, index) => {
      const node = byPath.get(name);
      if (!node) fail(`${file}: three.js has no node ${name}`);
      if (node.isSkinnedMesh) return;
      compared += 1;
      const off = apart(frame.world_from_node[index], node.matrixWorld.toArray());
      for (const measure in worst) worst[measure] = Math.max(worst[measure], off[measure]);
    });
  }
  const found = `${worst.degrees.toFixed(5)} degrees and ${worst.units.toFixed(6)} units in the world`;
  const isWithin = worst.degrees <= degrees && worst.units <= units && worst.scale <= 1e-4;
  if (frames.length < 100 || compared === 0 || !isWithin) {
    fail(`${file}: three.js is off by ${found}, and scales by ${worst.scale}, at ${frames.length} times`);
  }
  console.log(`${path.basename(file)} by three.js r${three.REVISION} at ${frames.length} times: within ${found}`);
}

// The triangles of a mesh in the world, as lists of nine numbers. A mirror turns triangles around, which is undone.
function triangles(three, mesh) {
  const { index, attributes } = mesh.geometry;
  const corner = at => {
    const vertex = index ? index.getX(at) : at;
    return mesh.getVertexPosition(vertex, new three.Vector3()).applyMatrix4(mesh.matrixWorld).toArray();
  };
  const isMirror = !mesh.isSkinnedMesh && mesh.matrixWorld.determinant() < 0;
  const count = (index ?? attributes.position).count / 3;
  return Array.from({ length: count }, (_, at) => {
    const [a, b, c] = [3 * at, 3 * at + 1, 3 * at + 2].map(corner);
    return isMirror ? [a, c, b].flat() : [a, b, c].flat();
  });
}

// The largest distance of corners of two meshes, each triangle begun at the corner that fits best; infinite if they have other counts.
function apartAsMeshes(a, b) {
  if (a.length !== b.length) return Infinity;
  const distance = (one, other, shift) => Math.max(...[0, 3, 6].map(at => {
    const from = (at + shift) % 9;
    return Math.hypot(one[at] - other[from], one[at + 1] - other[from + 1], one[at + 2] - other[from + 2]);
  }));
  return a.reduce((worst, one, at) => Math.max(worst, Math.min(...[0, 3, 6].map(shift => distance(one, b[at], shift)))), 0);
}

async function shows(model, exported, seconds, units) {
  const [theirs, ours] = [await played(model), await played(exported)];
  const meshes = ({ scene }, isWanted) => {
    const found = [];
    scene.traverse(node => { if (node.isMesh && isWanted(node)) found.push(node); });
    return found;
  };
  const expected = meshes(theirs, () => true);
  // Import adds a ground.
  const left = meshes(ours, node => !/^ground(\/|$)/.test(node.userData.inbetween?.path ?? ''));
  if (expected.length !== left.length || left.length === 0) fail(`${exported}: ${left.length} meshes, and not ${expected.length}`);
  const pairs = [];
  let worst = 0;
  const times = 101;
  for (let time = 0; time < times; time++) {
    [theirs, ours].forEach(file => file.at(seconds * time / (times - 1)));
    const shown = expected.map(mesh => triangles(theirs.three, mesh));
    if (time === 0) {
      // Which is which is told by where they are in the beginning.
      for (const mesh of shown) {
        const distances = left.map(other => apartAsMeshes(mesh, triangles(ours.three, other)));
        const nearest = distances.indexOf(Math.min(...distances));
        pairs.push(left.splice(Math.max(nearest, 0), 1)[0]);
      }
    }
    shown.forEach((mesh, at) => { worst = Math.max(worst, apartAsMeshes(mesh, triangles(ours.three, pairs[at]))); });
  }
  if (!(worst <= units)) fail(`${exported}: a corner is ${worst} units from where ${model} has it`);
  console.log(`${path.basename(exported)} shows what ${path.basename(model)} does at ${times} times: within ${worst.toFixed(6)} units`);
}

if (task === 'valid') await valid(rest);
else if (task === 'plays') await plays(rest[0], rest[1], Number(rest[2]), Number(rest[3]));
else if (task === 'shows') await shows(rest[0], rest[1], Number(rest[2]), Number(rest[3]));
else fail(`no task ${task}`);
