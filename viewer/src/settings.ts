// The parts of the panel that set the scene and the comparison: controls that change the state and follow it.

import { Choice, section, Slider, Switch } from './controls';
import { clamp, h, tidy, write } from './dom';
import type { Meshes } from './meshes';
import type { Pair } from './pair';
import { Problem } from './problem';
import { RANGES, type State, type Store } from './state';

const SHAPES: Record<string, string> = { sphere: 'Sphere', teapot: 'Teapot', bunny: 'Bunny' };

export class Settings {
  readonly scene: HTMLDetailsElement;
  readonly compare: HTMLDetailsElement;
  /** The file whose sky lights the scene. */
  skyName = '';
  private readonly followers: ((state: State) => void)[] = [];

  constructor(
    private readonly store: Store,
    private readonly start: State,
    private readonly fail: (error: unknown) => void,
    meshes: Meshes,
    pair: Pair,
    openSecond: HTMLElement,
  ) {
    this.scene = this.sceneSection(meshes, pair);
    this.compare = this.compareSection(pair, openSecond);
  }

  /** Show what is set. */
  follow(state: State): void {
    for (const follower of this.followers) follower(state);
  }

  private sceneSection(meshes: Meshes, pair: Pair): HTMLDetailsElement {
    const shape = new Choice('Shape', [], (value) => this.store.change({ shape: value }));
    this.followers.push((state) => {
      shape.fill(meshes.names.map((name) => [name, SHAPES[name] ?? name] as const));
      shape.show(state.shape);
    });
    const up = this.choice('Up', 'up', [['y', 'y, as glTF has it'], ['z', 'z, as Blender has it']]);
    this.followers.push((state) => (up.hidden = !meshes.isOwn(state.shape)));
    const surroundings = new Choice('Surroundings', [], (value) => this.store.change({ environment: value }));
    this.followers.push((state) => {
      surroundings.fill([['studio', 'Studio'], ['sky', 'Sky'], ['dome', 'White dome'], ['none', 'Nothing'], ...(this.skyName ? [['own', this.skyName] as const] : [])]);
      surroundings.show(state.environment);
    });
    const dust = this.onOff('Dust lies where it settles', 'dust', 'tau by inclination and shelter instead of the same everywhere');
    this.followers.push(() => (dust.hidden = !pair.all.some((material) => material?.tau)));
    return section(
      'Scene',
      true,
      h('div', { class: 'motes-pair' }, shape.element, surroundings.element),
      up,
      this.slider('lamp', 'lamp', { step: 0.05 }),
      this.slider('lamp azimuth', 'lampAzimuth', { unit: '°', step: 1 }),
      this.slider('lamp height', 'lampElevation', { unit: '°', step: 1 }),
      this.slider('surroundings', 'sky', { step: 0.05 }),
      this.slider('exposure', 'exposure', { unit: 'EV', step: 0.1 }),
      this.choice('Tone mapping', 'tone', [['neutral', 'Khronos PBR Neutral'], ['agx', 'AgX'], ['clip', 'Clip at 1']]),
      dust,
      this.onOff('Lobe in the corner', 'lobe', 'The BRDF in three dimensions'),
      this.onOff('Surroundings behind', 'backdrop', 'Show the environment as the background'),
      this.onOff('Ground', 'ground', 'The shadow on the ground of the light from all around; without surroundings behind'),
      h('p', { class: 'motes-caption' }, 'Drag to turn, Shift-drag to move the lamp, scroll to zoom. The lamp is a point; light from the surroundings is the sum over up to 1,024 directions, finished some frames after the last change. The ground lacks the light from all around that the shape keeps from it; nothing else casts shadows. A .hdr or .exr panorama that is dropped becomes the surroundings.'),
    );
  }

  private compareSection(pair: Pair, openSecond: HTMLElement): HTMLDetailsElement {
    const note = h('p', { class: 'motes-caption' });
    const comparison = this.choice('Show', 'compare', [['one', 'One material'], ['split', 'Two, split'], ['side', 'Two, side by side']]);
    const cut = this.slider('where it is split', 'split', { step: 0.01 });
    this.followers.push((state) => {
      comparison.querySelector('select')!.disabled = !pair.two;
      cut.hidden = !pair.two || state.compare !== 'split';
      write(note, pair.two ? `Left: ${pair.at(0)!.name}. Right: ${pair.at(1)!.name}.` : 'Open a second material (a material.json) to compare.');
    });
    return section('Compare', pair.cameWithTwo, comparison, cut, note, openSecond);
  }

  // ---------------------------------------------------------------- controls of one key of the state

  private slider(label: string, key: keyof typeof RANGES, extra: { unit?: string; step?: number } = {}): HTMLElement {
    const set = (value: number): void => this.store.change({ [key]: within(label, value, key) });
    const reset = (): void => this.store.change({ [key]: this.start[key] });
    const made = new Slider({ label, ...extra, ...RANGES[key], set, reset }, this.fail);
    this.followers.push((state) => made.show(state[key], state[key] !== this.start[key]));
    return made.element;
  }

  private choice(label: string, key: 'up' | 'tone' | 'compare', options: [string, string][]): HTMLElement {
    const made = new Choice(label, options, (value) => this.store.change({ [key]: value }));
    this.followers.push((state) => made.show(state[key]));
    return made.element;
  }

  private onOff(label: string, key: 'dust' | 'lobe' | 'backdrop' | 'ground', hint: string): HTMLElement {
    const made = new Switch(label, (on) => this.store.change({ [key]: on }), hint);
    this.followers.push((state) => made.show(state[key]));
    return made.element;
  }
}

function within(label: string, value: number, key: keyof typeof RANGES): number {
  const { low, high } = RANGES[key];
  if (!Number.isFinite(value)) throw new Problem(`${label} is not a number`, `Choose one from ${tidy(low)} to ${tidy(high)}`);
  return clamp(value, low, high);
}
