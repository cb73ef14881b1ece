// How much of the picture a frame draws: what the machine can do within a patience, found from how long frames take.

/** Directions of the sky a frame: while things move at least so many; at rest from the third on, doubled up to the second. */
const FEWEST = 2;
export const MOST = 64;
export const AT_REST = 8;
const PATIENCE_MS = 45;
const COARSEST = 8;
/** At rest a frame draws as many rows of the picture as take about so long: what is asked for in between need not wait. */
const REST_MS: [number, number] = [60, 160];

export class Pace {
  /** Directions of the sky a frame while things move, and how many pixels to the side are drawn as one. */
  batch = 4;
  coarseness = 3;
  /** At rest: rows times directions that a frame draws. */
  budget = 0;
  private times: number[] = [];
  private turning = false;

  /** Called at each frame of a picture of that height: more directions, pixels and rows where the machine is quick, fewer where it is not. */
  follow(now: number, moved: boolean, height: number): void {
    this.budget ||= AT_REST * height;
    if (this.times.length && (moved !== this.turning || now - this.times.at(-1)! > 3000)) this.times = [];
    this.turning = moved;
    this.times.push(now);
    if (this.times.length < (moved ? 6 : 4)) return;
    const mean = (now - this.times[0]!) / (this.times.length - 1);
    this.times = [];
    if (!moved) {
      if (mean > REST_MS[1]) this.budget = Math.max(this.budget / 2, AT_REST);
      else if (mean < REST_MS[0]) this.budget = Math.min(this.budget * 2, MOST * height);
    } else if (mean > PATIENCE_MS) {
      if (this.batch > FEWEST) this.batch /= 2;
      else this.coarseness = Math.min(Math.ceil(this.coarseness * Math.min(Math.sqrt(mean / PATIENCE_MS), 2)), COARSEST);
    } else if (mean < PATIENCE_MS / 2) {
      if (this.coarseness > 1) this.coarseness -= 1;
      else if (this.batch < MOST) this.batch *= 2;
    }
  }
}
