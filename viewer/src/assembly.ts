// The shader of a material that was dropped: the printed pieces of Motes' library, called as its model says.  No equation is written here.

import { baseOf, type Model, type Named, type Slot } from './expression';
import { MODELS, type ShaderView } from './generated';
import { Problem } from './problem';

const NAME = 'motes_eval';

/** GLSL for a model of one channel or three, with a uniform for each parameter. */
export function assemble(model: Model, slots: readonly Slot[], library: Record<string, ShaderView>, title: string): ShaderView {
  const used = new Set<string>();
  let next = 0;
  const piece = (name: string): ShaderView => {
    const found = library[name];
    if (!found) throw new Problem(`This page holds no shader for ${name}`, 'Write a page of its own: motes view MATERIAL');
    used.add(name);
    return found;
  };
  /** The names of a model's parameters from here on, in the order of the slots. */
  const argument = (wanted: number): string => {
    const slot = slots[next]!;
    next += 1;
    return wanted > 1 && slot.value.length === 1 ? `vec3(${slot.name})` : slot.name;
  };
  const call = (name: string, given: string[]): string => {
    const shader = piece(name);
    const rest = shader.uniforms.slice(given.length).map((uniform) => argument(uniform.size));
    return `${shader.name}_with(wi, wo, ${[...given, ...rest].join(', ')})`;
  };
  const expression = (part: Model): string => {
    if (part.kind === 'sum') return `(${expression(part.a)} + ${expression(part.b)})`;
    const below = baseOf(part.name);
    if (!below) return call(key(part), []);
    // The base takes its parameters first; the printed layer lies on a Lambertian base, whose value is K_d/pi.
    const base = expression(part.children[below.name]!);
    return call(key(part), [`3.14159265358979 * ${base}`]);
  };
  const body = expression(model);
  const uniforms = slots.map((slot) => ({ name: `motes_${slot.name}`, slot: slot.name, size: slot.value.length }));
  const type = (size: number): string => (size === 1 ? 'float' : 'vec3');
  const source = [
    `// ${title.replace(/[^ -~]|\\|\*\//g, ' ')}`,
    '// Put together by the viewer from shaders that Motes printed from its equations, one for each model.',
    '',
    ...[...used].map((name) => library[name]!.source),
    ...uniforms.map((uniform) => `uniform ${type(uniform.size)} ${uniform.name};`),
    '',
    `vec3 ${NAME}_with(vec3 wi, vec3 wo${slots.map((slot) => `, ${type(slot.value.length)} ${slot.name}`).join('')}) {`,
    `    return ${body};`,
    '}',
    '',
    `vec3 ${NAME}(vec3 wi, vec3 wo) {`,
    `    return ${NAME}_with(wi, wo${uniforms.map((uniform) => `, ${uniform.name}`).join('')});`,
    '}',
    '',
  ].join('\n');
  return { source, name: NAME, uniforms, channels: Math.max(...slots.map((slot) => slot.value.length)), stages: false, kept: [], table: null };
}

/** The name of a model's piece: its options as Motes names them. */
function key(part: Named): string {
  const words = MODELS[part.name]!.fields.flatMap((field) => {
    if (field.kind === 'option') return [part.options[field.name]!];
    const inner = field.kind === 'child' && field.place === 'fresnel' ? part.children[field.name] : null;
    return inner && inner.kind === 'named' ? [inner.name] : [];
  });
  return [part.name, ...words].join('_');
}
