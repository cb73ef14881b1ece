// The section of the lobe: the polar plot of the present materials at the present angle of incidence.

import { Choice } from './controls';
import { degrees, h, radians, tidy } from './dom';
import type { Material, Values } from './material';
import { scanAt, type Measurement } from './measurement';
import { Polar, type Curve } from './polar';
import type { Probe } from './probe';
import { inPlane, scaled, shownChannels } from './slice';
import type { State } from './state';

const STEPS = 179;
/** Measured points are shown where they lie in the plane of incidence and at the angle of incidence, within so many degrees. */
const IN_PLANE_DEG = 3;
const NEAR_DEG = 2.5;

/** Indices of the samples near the plane of incidence at an angle of incidence. */
export function near(data: Measurement, incidenceDeg: number, tolerance = NEAR_DEG): number[] {
  const found: number[] = [];
  const limit = Math.sin(radians(IN_PLANE_DEG));
  for (let k = 0; k < data.count; k += 1) {
    if (Math.abs(degrees(data.thetaI[k]!) - incidenceDeg) > tolerance) continue;
    if (Math.abs(Math.sin(data.dphi[k]!)) * Math.min(Math.sin(data.thetaR[k]!), Math.max(Math.sin(data.thetaI[k]!), 0.05)) <= limit) found.push(k);
  }
  return found;
}

/** The signed angle [rad] of a sample's view, the mirror's side positive. */
export function signed(data: Measurement, k: number): number {
  return Math.cos(data.dphi[k]!) > 0 ? -data.thetaR[k]! : data.thetaR[k]!;
}

export class Reflection {
  readonly element: HTMLElement;
  private readonly polar: Polar;
  private readonly radius: Choice;
  private readonly scale: Choice;
  private readonly words = h('p', { class: 'motes-caption' });

  constructor(change: (patch: Partial<State>) => void) {
    this.polar = new Polar((incidence) => change({ incidence }));
    this.radius = new Choice('Radius', [['f', 'f, the BRDF'], ['f cos', 'f cos θ']], (radius) => change({ radius }));
    this.scale = new Choice('Scale', [['linear', 'linear'], ['cube root', 'cube root']], (scale) => change({ scale }));
    this.element = h('div', {}, this.polar.svg, this.words, h('div', { class: 'motes-pair' }, this.radius.element, this.scale.element));
  }

  update(state: State, materials: readonly Material[], values: readonly Values[], probe: Probe, data: Measurement | null): void {
    this.radius.show(state.radius);
    this.scale.show(state.scale);
    const wi = inPlane(-radians(state.incidence));
    const theta = Float32Array.from({ length: STEPS }, (_, k) => radians(k + 1 - 90));
    const wo = Float32Array.from([...theta].flatMap(inPlane));
    const from = new Float32Array(wo.length);
    for (let k = 0; k < STEPS; k += 1) from.set(wi, 3 * k);
    const weight = (angle: number): number => (state.radius === 'f cos' ? Math.cos(angle) : 1);
    const curves: Curve[] = [];
    const said: string[] = [];
    const shown = state.compare === 'one' ? [state.active] : materials.map((_, k) => k);
    for (const index of shown) {
      const material = materials[index];
      if (!material) continue;
      const f = probe.evaluate(material, values[index]!, from, wo);
      const width = material.shader.channels;
      for (const { channel, tint } of shownChannels(material.channels, material.wavelengths)) {
        const radius = theta.map((angle, k) => scaled(f[k * width + channel]! * weight(angle), state.scale));
        curves.push({ theta, radius, tint, dashed: index > 0 && shown.length > 1 });
      }
      let most = 0;
      for (let k = 1; k < STEPS; k += 1) if (f[k * width]! > f[most * width]!) most = k;
      said.push(`${material.name}: largest ${tidy(f[most * width]!)} 1/sr at ${tidy(degrees(theta[most]!))}°`);
    }
    const dots: Curve[] = [];
    const material = materials[0];
    if (data && material && shown.includes(0)) {
      const scan = scanAt(data, state.hours);
      const some = near(data, state.incidence);
      const angles = some.map((k) => signed(data, k));
      for (const { channel, tint } of shownChannels(data.channels, material.wavelengths)) {
        const radius = some.map((k, i) => scaled(data.values[(scan * data.count + k) * data.channels.length + channel]! * weight(angles[i]!), state.scale));
        dots.push({ theta: angles, radius, tint, dashed: false });
      }
    }
    const label = `The ${state.radius === 'f' ? 'BRDF' : 'BRDF times the cosine'} in the plane of incidence, light at ${tidy(state.incidence)}° from the normal. ${said.join('; ')}.`;
    this.polar.draw(label, state.incidence, curves, dots, (value) => tidy(state.scale === 'cube root' ? value ** 3 : value, 2));
    this.words.textContent = `Light at ${tidy(state.incidence)}°. ${said.join('; ')}.${dots.some((each) => each.theta.length) ? ' Dots: measured.' : ''} Drag the yellow handle, or focus it and use the arrow keys.`;
  }
}
