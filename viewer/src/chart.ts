// A chart in SVG: axes, grid, lines, bands, dots.  Drawn anew each time; everything has its colour from the style sheet.

import { fresh, s, tidy } from './dom';

export interface Axis {
  low: number;
  high: number;
  label: string;
  ticks?: number[];
  /** How a tick is written. */
  write?: (value: number) => string;
}

export interface Line {
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  tint: string;
  dashed?: boolean;
}

const [WIDE, HIGH] = [360, 210];
const MARGIN = { left: 52, right: 10, top: 10, bottom: 34 };

export class Chart {
  readonly svg: SVGSVGElement;
  private readonly title: SVGTitleElement;
  private readonly body = s('g');
  private x: Axis = { low: 0, high: 1, label: '' };
  private y: Axis = { low: 0, high: 1, label: '' };
  private readonly clip = fresh('clip');

  constructor(
    label: string,
    private readonly height = HIGH,
    private readonly width = WIDE,
  ) {
    this.title = s('title', {}, label);
    const inner = s('rect', { x: MARGIN.left, y: MARGIN.top - 4, width: width - MARGIN.left - MARGIN.right, height: height - MARGIN.top - MARGIN.bottom + 8 });
    this.svg = s('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', class: 'motes-chart' }, this.title, s('defs', {}, s('clipPath', { id: this.clip }, inner)), this.body);
  }

  /** Start over with new axes; `label` says in words what is seen. */
  begin(label: string, x: Axis, y: Axis): void {
    this.title.textContent = label;
    this.body.replaceChildren();
    this.x = x;
    this.y = y.high > y.low ? y : { ...y, high: y.low + 1 };
    const bottom = this.height - MARGIN.bottom;
    for (const tick of x.ticks ?? nice(x.low, x.high, this.width > 300 ? 6 : 4)) {
      const at = this.px(tick);
      this.body.append(s('line', { x1: at, x2: at, y1: MARGIN.top, y2: bottom, class: 'grid' }), s('text', { x: at, y: bottom + 14, class: 'tick', 'text-anchor': 'middle' }, (x.write ?? tidy)(tick)));
    }
    for (const tick of this.y.ticks ?? nice(this.y.low, this.y.high, 4)) {
      const at = this.py(tick);
      this.body.append(s('line', { x1: MARGIN.left, x2: this.width - MARGIN.right, y1: at, y2: at, class: tick === 0 ? 'axis' : 'grid' }), s('text', { x: MARGIN.left - 5, y: at + 3.5, class: 'tick', 'text-anchor': 'end' }, (this.y.write ?? tidy)(tick)));
    }
    this.body.append(
      s('text', { x: (MARGIN.left + this.width - MARGIN.right) / 2, y: this.height - 4, class: 'label', 'text-anchor': 'middle' }, x.label),
      s('text', { x: 10, y: (MARGIN.top + bottom) / 2, class: 'label', 'text-anchor': 'middle', transform: `rotate(-90 10 ${(MARGIN.top + bottom) / 2})` }, y.label),
    );
  }

  line({ x, y, tint, dashed }: Line): void {
    let path = '';
    let pen = 'M';
    for (let k = 0; k < x.length; k += 1) {
      if (!Number.isFinite(y[k]!)) {
        pen = 'M';
        continue;
      }
      path += `${pen}${this.px(x[k]!).toFixed(1)} ${this.py(y[k]!).toFixed(1)}`;
      pen = 'L';
    }
    this.inside(s('path', { d: path, class: `line ${tint}${dashed ? ' dashed' : ''}` }));
  }

  band(x: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number>, tint: string): void {
    const points: string[] = [];
    for (let k = 0; k < x.length; k += 1) points.push(`${this.px(x[k]!).toFixed(1)} ${this.py(high[k]!).toFixed(1)}`);
    for (let k = x.length - 1; k >= 0; k -= 1) points.push(`${this.px(x[k]!).toFixed(1)} ${this.py(low[k]!).toFixed(1)}`);
    if (points.length) this.inside(s('path', { d: `M${points.join('L')}Z`, class: `band ${tint}` }));
  }

  /** Many dots as one path of points with round ends. */
  dots(x: ArrayLike<number>, y: ArrayLike<number>, tint: string): void {
    let path = '';
    for (let k = 0; k < x.length; k += 1) if (Number.isFinite(y[k]!)) path += `M${this.px(x[k]!).toFixed(1)} ${this.py(y[k]!).toFixed(1)}h0`;
    if (path) this.inside(s('path', { d: path, class: `dots ${tint}` }));
  }

  bars(x: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number>, tint: string): void {
    let path = '';
    for (let k = 0; k < x.length; k += 1) if (Number.isFinite(low[k]!) && Number.isFinite(high[k]!)) path += `M${this.px(x[k]!).toFixed(1)} ${this.py(low[k]!).toFixed(1)}V${this.py(high[k]!).toFixed(1)}`;
    if (path) this.inside(s('path', { d: path, class: `bars ${tint}` }));
  }

  /** A vertical mark, such as the present time. */
  mark(x: number): void {
    this.inside(s('line', { x1: this.px(x), x2: this.px(x), y1: MARGIN.top, y2: this.height - MARGIN.bottom, class: 'now' }));
  }

  private inside(element: SVGElement): void {
    element.setAttribute('clip-path', `url(#${this.clip})`);
    this.body.append(element);
  }

  private px(value: number): number {
    return MARGIN.left + ((value - this.x.low) / (this.x.high - this.x.low)) * (this.width - MARGIN.left - MARGIN.right);
  }

  private py(value: number): number {
    const bottom = this.height - MARGIN.bottom;
    return bottom - ((value - this.y.low) / (this.y.high - this.y.low)) * (bottom - MARGIN.top);
  }
}

/** About `count` round numbers within a range. */
export function nice(low: number, high: number, count: number): number[] {
  const rough = (high - low) / count;
  if (!(rough > 0) || !Number.isFinite(rough)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((k) => k * power).find((each) => each >= rough * 0.999)!;
  const ticks: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) ticks.push(Number((k * step).toPrecision(10)));
  return ticks;
}
