// Turning the picture: drag, wheel, pinch and keys; with Shift, or the right button, the lamp moves instead.

import { clamp } from './dom';
import { RANGES, type Store } from './state';

const PER_PIXEL = 0.4;

export function orbit(canvas: HTMLElement, store: Store): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let lamp = false;
  let spread = 0;
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    lamp = event.shiftKey || event.button === 2;
    spread = distance(pointers);
  });
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size > 1) {
      const now = distance(pointers);
      if (spread > 0 && now > 0) zoom(spread / now);
      spread = now;
    } else turn(dx * PER_PIXEL, dy * PER_PIXEL, lamp);
  });
  for (const end of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.0015));
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    const steps: Record<string, [number, number]> = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6] };
    const step = steps[event.key];
    if (step) turn(step[0], step[1], event.shiftKey);
    else if (event.key === '+' || event.key === '=') zoom(0.9);
    else if (event.key === '-') zoom(1 / 0.9);
    else return;
    event.preventDefault();
  });

  function turn(dx: number, dy: number, theLamp: boolean): void {
    const { state } = store;
    if (theLamp) store.change({ lampAzimuth: around(state.lampAzimuth + dx), lampElevation: clamp(state.lampElevation - dy, RANGES.lampElevation.low, RANGES.lampElevation.high) });
    else store.change({ azimuth: around(state.azimuth - dx), elevation: clamp(state.elevation + dy, RANGES.elevation.low, RANGES.elevation.high) });
  }

  function zoom(factor: number): void {
    store.change({ distance: clamp(store.state.distance * factor, RANGES.distance.low, RANGES.distance.high) });
  }
}

const around = (angle: number): number => ((((angle + 180) % 360) + 360) % 360) - 180;

function distance(pointers: Map<number, { x: number; y: number }>): number {
  const [a, b] = [...pointers.values()];
  return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
}
