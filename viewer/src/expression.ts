// Models as text, `oren_nayar + torrance_sparrow(fresnel=dielectric)`: the same that motes.models.parse reads.  Parsed, never executed.

import { MODELS, type ChildDeclaration, type ModelDeclaration, type ParameterDeclaration } from './generated';
import { Problem, quoted } from './problem';

export interface Sum {
  kind: 'sum';
  a: Model;
  b: Model;
}

export interface Named {
  kind: 'named';
  name: string;
  options: Record<string, string>;
  children: Record<string, Named | Sum | null>;
  values: Record<string, number[]>;
}

export type Model = Sum | Named;

/** A parameter in its place; `name` is unique in the model, a name met again has the suffix `_2`. */
export interface Slot {
  name: string;
  declared: ParameterDeclaration;
  value: number[];
}

const TOKEN = /\s*([A-Za-z_]\w*|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|'[^']*'|"[^"]*"|[()[\],=+])/y;
const MOST_PARTS = 64;
const LONGEST = 20_000;

/** Make models known that Motes does not bring itself: those of the page. */
export function declare(models: Record<string, unknown>): void {
  Object.assign(MODELS, models as Record<string, ModelDeclaration>);
}

/** The part of a model that lies below a layer, if it is one. */
export function baseOf(name: string): ChildDeclaration | null {
  const found = MODELS[name]?.fields.find((field) => field.kind === 'child' && field.place === 'base');
  return found?.kind === 'child' ? found : null;
}

/** The model that a text names. */
export function parse(text: string): Model {
  if (text.length > LONGEST) throw new Problem(`The model's text has ${text.length} characters`, `It may have ${LONGEST}`);
  const tokens = tokenize(text);
  let position = 0;
  let parts = 0;
  const fail = (): never => {
    throw new Problem(`The model ${quoted(text)} is not a sum of models`, `The models are ${Object.keys(MODELS).join(', ')}`);
  };
  const peek = (): string | undefined => tokens[position];
  const take = (wanted?: string): string => {
    const token = tokens[position];
    if (token === undefined || (wanted !== undefined && token !== wanted)) return fail();
    position += 1;
    return token;
  };
  const sum = (): Model => {
    let model = term();
    while (peek() === '+') {
      take();
      model = { kind: 'sum', a: model, b: term() };
    }
    return model;
  };
  const term = (): Model => {
    if (peek() === '(') {
      take();
      const inner = sum();
      take(')');
      return inner;
    }
    return named(take());
  };
  const named = (name: string): Named => {
    const declaration = Object.hasOwn(MODELS, name) ? MODELS[name] : undefined;
    if (!declaration) throw new Problem(`${quoted(name)} is not a model`, `The models are ${Object.keys(MODELS).join(', ')}`);
    parts += 1;
    if (parts > MOST_PARTS) throw new Problem(`The model has more than ${MOST_PARTS} parts`, 'Write a shorter one');
    const model = plain(name);
    const fields = new Map(declaration.fields.map((field) => [field.name, field]));
    if (peek() !== '(') return checked(model);
    take('(');
    const positional = declaration.fields.filter((field) => field.kind === 'child' && field.place !== 'fresnel');
    const seen = new Set<string>();
    while (peek() !== ')') {
      const key = /^[A-Za-z_]/.test(peek() ?? '') && tokens[position + 1] === '=' ? take() : (positional[seen.size]?.name ?? fail());
      if (peek() === '=') take();
      const field = fields.get(key);
      if (!field || seen.has(key)) throw new Problem(`${name} has no ${quoted(key)} (or it is given twice)`, `It has ${[...fields.keys()].join(', ')}`);
      seen.add(key);
      if (field.kind === 'parameter') model.values[key] = numbers();
      else if (field.kind === 'option') model.options[key] = word(field.words, `${name}: ${key}`);
      else model.children[key] = child(field, sum(), name);
      if (peek() !== ')') take(',');
    }
    take(')');
    return checked(model);
  };
  const numbers = (): number[] => {
    const several = peek() === '[' || peek() === '(';
    if (!several) return [number(take())];
    take();
    const list = [number(take())];
    while (peek() === ',') {
      take();
      list.push(number(take()));
    }
    take();
    return list;
  };
  const number = (token: string): number => (Number.isFinite(Number(token)) ? Number(token) : fail());
  const word = (words: readonly string[], what: string): string => {
    const given = take().replace(/^['"]|['"]$/g, '');
    if (!words.includes(given)) throw new Problem(`${what} = ${quoted(given)} is not one of ${words.join(', ')}`, 'Correct the model');
    return given;
  };
  const model = sum();
  if (position < tokens.length) fail();
  if (model.kind === 'named' && !MODELS[model.name]?.brdf) throw new Problem(`${model.name} is a Fresnel term, not a BRDF`, 'Use it as torrance_sparrow(fresnel=...)');
  return model;
}

/** A model as it is when nothing is said of it. */
function plain(name: string): Named {
  const model: Named = { kind: 'named', name, options: {}, children: {}, values: {} };
  for (const field of MODELS[name]!.fields) {
    if (field.kind === 'option') model.options[field.name] = field.value;
    if (field.kind === 'child') model.children[field.name] = field.value ? plain(field.value) : null;
    if (field.kind === 'parameter') model.values[field.name] = [field.value];
  }
  return model;
}

function tokenize(text: string): string[] {
  const tokens: string[] = [];
  TOKEN.lastIndex = 0;
  const whole = text.trimEnd();
  while (TOKEN.lastIndex < whole.length) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(whole);
    if (!match) throw new Problem(`The model ${quoted(text)} cannot be read from ${quoted(text.slice(at, at + 20))} on`, 'Write for example oren_nayar + torrance_sparrow');
    tokens.push(match[1]!);
  }
  return tokens;
}

function child(field: ChildDeclaration, model: Model, owner: string): Named | Sum {
  const any = field.accepts === 'brdf' || field.accepts === 'fresnel';
  const fits = model.kind === 'sum' ? field.accepts === 'brdf' : any ? (field.accepts === 'brdf') === MODELS[model.name]?.brdf : field.accepts === model.name;
  if (!fits) throw new Problem(`${owner}: ${field.name} is not a ${field.accepts}`, 'Correct the model');
  return model;
}

function checked(model: Named): Named {
  for (const field of MODELS[model.name]!.fields) {
    if (field.kind !== 'child') continue;
    const part = model.children[field.name];
    if (field.required && !part) throw new Problem(`${model.name} has no ${field.name}`, `Write ${model.name}(oren_nayar), say`);
    if (field.place !== 'cover' || part?.kind !== 'named') continue;
    for (const option of MODELS[part.name]!.fields)
      if (option.kind === 'option' && part.options[option.name] !== option.value)
        throw new Problem(`The ${field.name} of ${model.name} must have the ${option.name} ${option.value}`, `Leave its ${option.name} out`);
  }
  return model;
}

/** All parameters in the order of the fields, depth first, as `Parametrised.slots` lists them. */
export function slots(model: Model): Slot[] {
  const seen = new Map<string, number>();
  const found: Slot[] = [];
  const walk = (part: Model): void => {
    if (part.kind === 'sum') {
      walk(part.a);
      walk(part.b);
      return;
    }
    for (const field of MODELS[part.name]!.fields) {
      if (field.kind === 'parameter') {
        const times = (seen.get(field.name) ?? 0) + 1;
        seen.set(field.name, times);
        found.push({ name: times === 1 ? field.name : `${field.name}_${times}`, declared: field, value: part.values[field.name]! });
      } else if (field.kind === 'child') {
        const inner = part.children[field.name];
        if (inner) walk(inner);
      }
    }
  };
  walk(model);
  return found;
}
