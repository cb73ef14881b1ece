// The lobe as a polar plot in the plane of incidence, with the incident direction to drag.

import { clamp, degrees, fresh, radians, s, tidy } from './dom';
import { nice } from './chart';
import { RANGES } from './state';

export interface Curve {
  /** Signed angles [rad], the mirror's side positive, and radii as they are drawn. */
  theta: ArrayLike<number>;
  radius: ArrayLike<number>;
  tint: string;
  dashed: boolean;
}

const [WIDTH, HEIGHT, RADIUS] = [360, 214, 150];
const [CX, CY] = [WIDTH / 2, 186];

export class Polar {
  readonly svg: SVGSVGElement;
  private readonly title = s('title', { id: fresh('polar') }, 'Polar plot');
  private readonly body = s('g');
  private readonly handle: SVGGElement;
  private now = 0;
  private readonly ray = s('line', { class: 'incident' });
  private readonly grip = s('circle', { r: 9, class: 'grip' });

  constructor(private readonly turn: (incidenceDeg: number) => void) {
    this.handle = s('g', {
      role: 'slider',
      tabindex: 0,
      class: 'motes-incident',
      'aria-label': 'Angle of incidence in degrees',
      'aria-valuemin': RANGES.incidence.low,
      'aria-valuemax': RANGES.incidence.high,
      'aria-valuenow': 0,
    }, this.ray, this.grip);
    this.svg = s('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'motes-chart motes-polar', role: 'group', 'aria-labelledby': this.title.id }, this.title, this.body, this.handle);
    this.handle.addEventListener('pointerdown', (event) => this.begin(event));
    this.handle.addEventListener('keydown', (event) => this.key(event));
  }

  /** Draw curves, each within the largest radius of all; `label` says in words what is seen. */
  draw(label: string, incidenceDeg: number, curves: readonly Curve[], dots: readonly Curve[], write: (value: number) => string): void {
    this.title.textContent = label;
    this.now = incidenceDeg;
    let most = 0;
    for (const { radius } of [...curves, ...dots]) for (let k = 0; k < radius.length; k += 1) if (Number.isFinite(radius[k]!)) most = Math.max(most, radius[k]!);
    const reach = most > 0 ? most : 1;
    this.body.replaceChildren(...this.grid(reach, write));
    for (const { theta, radius, tint, dashed } of curves) {
      let path = '';
      for (let k = 0; k < theta.length; k += 1) {
        const [x, y] = point(theta[k]!, (radius[k]! / reach) * RADIUS);
        path += `${k ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
      }
      this.body.append(s('path', { d: path, class: `line ${tint}${dashed ? ' dashed' : ''}` }));
    }
    for (const { theta, radius, tint } of dots) {
      let path = '';
      for (let k = 0; k < theta.length; k += 1) {
        const [x, y] = point(theta[k]!, (radius[k]! / reach) * RADIUS);
        if (Number.isFinite(x) && Number.isFinite(y)) path += `M${x.toFixed(1)} ${y.toFixed(1)}h0`;
      }
      this.body.append(s('path', { d: path, class: `dots ${tint}` }));
    }
    const [x, y] = point(-radians(incidenceDeg), RADIUS);
    for (const [key, value] of [['x1', x], ['y1', y], ['x2', CX], ['y2', CY]] as const) this.ray.setAttribute(key, value.toFixed(1));
    this.grip.setAttribute('cx', x.toFixed(1));
    this.grip.setAttribute('cy', y.toFixed(1));
    this.handle.setAttribute('aria-valuenow', tidy(incidenceDeg));
    this.handle.setAttribute('aria-valuetext', `${tidy(incidenceDeg)} degrees from the normal`);
  }

  private grid(reach: number, write: (value: number) => string): SVGElement[] {
    const parts: SVGElement[] = [s('line', { x1: CX - RADIUS, x2: CX + RADIUS, y1: CY, y2: CY, class: 'axis' })];
    for (const value of nice(0, reach, 3).slice(1)) {
      const r = (value / reach) * RADIUS;
      parts.push(s('path', { d: `M${CX - r} ${CY}A${r} ${r} 0 0 1 ${CX + r} ${CY}`, class: 'grid' }), s('text', { x: CX + r, y: CY + 13, class: 'tick', 'text-anchor': 'middle' }, write(value)));
    }
    for (const angle of [-60, -30, 0, 30, 60]) {
      const [x, y] = point(radians(angle), RADIUS + 4);
      const [tx, ty] = point(radians(angle), RADIUS + 15);
      parts.push(s('line', { x1: CX, y1: CY, x2: x, y2: y, class: 'grid' }), s('text', { x: tx, y: ty + 4, class: 'tick', 'text-anchor': 'middle' }, `${Math.abs(angle)}°`));
    }
    parts.push(s('text', { x: 6, y: CY + 26, class: 'tick' }, 'light'), s('text', { x: WIDTH - 6, y: CY + 26, class: 'tick', 'text-anchor': 'end' }, 'mirror side'));
    return parts;
  }

  private begin(event: PointerEvent): void {
    event.preventDefault();
    this.handle.focus();
    this.handle.setPointerCapture(event.pointerId);
    const move = (moved: PointerEvent): void => {
      const box = this.svg.getBoundingClientRect();
      const x = ((moved.clientX - box.left) / box.width) * WIDTH - CX;
      const y = CY - ((moved.clientY - box.top) / box.height) * HEIGHT;
      this.set(degrees(Math.atan2(-x, Math.max(y, 0))));
    };
    const end = (): void => {
      this.handle.removeEventListener('pointermove', move);
      this.handle.removeEventListener('pointerup', end);
      this.handle.removeEventListener('pointercancel', end);
    };
    this.handle.addEventListener('pointermove', move);
    this.handle.addEventListener('pointerup', end);
    this.handle.addEventListener('pointercancel', end);
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, number> = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
    const wanted = event.key === 'Home' ? RANGES.incidence.low : event.key === 'End' ? RANGES.incidence.high : event.key in steps ? this.now + steps[event.key]! : null;
    if (wanted === null) return;
    event.preventDefault();
    this.set(wanted);
  }

  private set(incidenceDeg: number): void {
    this.now = Math.round(clamp(incidenceDeg, RANGES.incidence.low, RANGES.incidence.high) * 2) / 2;
    this.turn(this.now);
  }
}

/** A point of the plot: light comes from the left, the mirror's side is to the right. */
function point(theta: number, radius: number): [number, number] {
  return [CX + Math.sin(theta) * radius, CY - Math.cos(theta) * radius];
}
