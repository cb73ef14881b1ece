// The viewer's parsers, given whatever tools/fuzz.py sends: a line of JSON with the shaders and a material, then lines of lists [parser, name, content].
// For each input one line goes back: what became of it, and the time that it took [ms].
import { build } from 'esbuild';
import { createInterface } from 'node:readline';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

const contents = ['cells', 'expression', 'material', 'measurement', 'meshfiles', 'shapes', 'state'].map((name) => `export * as ${name} from './src/${name}';`).join('\n');
const made = await build({ stdin: { contents, resolveDir: dirname(fileURLToPath(import.meta.url)) }, bundle: true, format: 'esm', write: false, platform: 'node', logLevel: 'error' });
globalThis.self ??= globalThis;
globalThis.fetch = () => {
  throw new Error('the network was asked');
};
const { cells, expression, material, measurement, meshfiles, shapes, state } = await import('data:text/javascript;base64,' + Buffer.from(made.outputFiles[0].text).toString('base64'));
const answer = (value) => process.stdout.write(JSON.stringify(value) + '\n');
console.log = console.error = console.warn = () => {};

const start = state.initial('sphere', 0, false);
let library = {};
let own = null;
let dust = [];

/** What a page does with a material and what is set by hand. */
function shown(found, held) {
  for (const hours of [null, -1, 0, 1, 1e9]) {
    const values = material.valuesAt(found, hours, held);
    for (const slot of found.slots) {
      const value = values[slot.name];
      if (value.length !== slot.value.length) return `${slot.name} has ${value.length} values`;
      for (const each of value) material.check(slot, each);
    }
    JSON.stringify(material.toJson(found, values, held, hours));
  }
  return 'read';
}

const parsers = {
  link(name, data) {
    const found = state.decode(new TextDecoder().decode(data), start);
    if (!found) return 'refused';
    for (const [key, { low, high }] of Object.entries(state.RANGES)) if (!(found[key] >= low && found[key] <= high)) return `${key} is out of range`;
    for (const [key, words] of Object.entries(state.WORDS)) if (!words.includes(found[key])) return `${key} is no word`;
    for (const index of [0, 1]) {
      let one = own;
      if (found.dropped[index]) one = material.fromJson(found.dropped[index], library).material;
      const told = shown(one, material.held(one, found.values[index]));
      if (told !== 'read') return told;
    }
    if (JSON.stringify(state.decode(state.encode(found, start), start) ?? start) !== JSON.stringify(found)) return 'another state when said again';
    return 'read';
  },
  material(name, data) {
    return shown(material.fromText(cells.decoded(data), library).material, {});
  },
  table(name, data) {
    const found = measurement.fromCsv(name, cells.decoded(data));
    measurement.commonIncidence(found);
    return found.count && found.wi.every(Number.isFinite) && found.wo.every(Number.isFinite) ? 'read' : 'a table of nothing';
  },
  async mesh(name, data) {
    const made = shapes.prepared(await meshfiles.readMesh(name, data), dust);
    const count = made.getAttribute('position').count;
    if (!made.getIndex().array.every((k) => k < count)) return 'triangles of no vertices';
    for (const attribute of ['position', 'normal', 'dust']) {
      const { array, itemSize } = made.getAttribute(attribute);
      for (const k of made.getIndex().array) for (let j = 0; j < itemSize; j += 1) if (!Number.isFinite(array[k * itemSize + j])) return `a ${attribute} that is not finite`;
    }
    return 'read';
  },
  model(name, data) {
    return expression.slots(expression.parse(new TextDecoder().decode(data))).length ? 'read' : 'a model of nothing';
  },
};

for await (const line of createInterface({ input: process.stdin })) {
  const message = JSON.parse(line);
  if (!Array.isArray(message)) {
    ({ library, dust } = message);
    own = material.fromJson(message.own, library).material;
    answer('ready');
    continue;
  }
  for (const [kind, name, content] of message) {
    const data = Uint8Array.from(Buffer.from(content, 'base64')).buffer;
    const before = process.cpuUsage();
    let told;
    try {
      told = await parsers[kind](name, data);
    } catch (error) {
      told = error.name !== 'Problem' ? `${error.name}: ${String(error.message).slice(0, 80)}` : error.message && error.hint ? 'refused' : `no hint: ${error.message.slice(0, 80)}`;
    }
    const { user, system } = process.cpuUsage(before);
    answer([told, (user + system) / 1000]);
  }
}
