// The cells of a table as text, by the rules of motes.measurements._cells: encodings, separators, comments, quotes.

import { column, isUnit, MISSING, normal, type Role } from './columns';
import { Problem, quoted } from './problem';

export interface Cells {
  header: string[];
  rows: string[][];
  lines: number[];
  notes: string[];
  /** What a row of units below the header says; empty without one. */
  units: string[];
}

const COMMENT = /^\s*(?:#|%|\/\/|!)/;
const HEADER_LINES = 400;
const BLANKS = 'blanks';
const WIDE_BLANKS = 'two blanks or more';
const SEPARATORS = ['\t', ';', ',', '|', WIDE_BLANKS, BLANKS];
const NUMBER = /^[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?$/;
const WITH_UNIT = /^([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?)\s*([^\d\s.,+-].*)$/;
const HINT = 'A header names the columns, such as theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,brdf';

/** Text from bytes: by the byte-order mark, as UTF-8, or else as Windows-1252. */
export function decoded(data: ArrayBuffer): string {
  const bytes = new Uint8Array(data);
  const [a, b] = [bytes[0], bytes[1]];
  if (a === 0xff && b === 0xfe) return new TextDecoder('utf-16le').decode(data);
  if (a === 0xfe && b === 0xff) return new TextDecoder('utf-16be').decode(data);
  const start = bytes.slice(0, 2000);
  for (const [at, code] of [[1, 'utf-16le'], [0, 'utf-16be']] as const) {
    const zeros = start.filter((byte, k) => byte === 0 && k % 2 === at).length;
    if (bytes.length >= 8 && zeros > 0.4 * start.length) return new TextDecoder(code).decode(data);
  }
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(data);
  } catch {
    return new TextDecoder('windows-1252').decode(data);
  }
}

function kindOf(cell: string): Role | 'direction' | '' {
  try {
    const found = column(cell);
    return !found ? '' : found.role === 'angle' || found.role === 'vector' ? 'direction' : found.role;
  } catch {
    return 'direction'; // a known name with a wrong unit is the name of a column all the same
  }
}

function names(cells: string[]): number {
  const kinds = cells.filter((cell) => cell && cell.length <= 100).map(kindOf).filter(Boolean);
  return kinds.includes('direction') && kinds.length >= 2 ? kinds.length : 0;
}

function split(line: string, separator: string, ofHeader = false): string[] {
  if (separator === WIDE_BLANKS) return line.trim().split(/\s{2,}|\t/).map(unquoted);
  if (separator === BLANKS) {
    if (!ofHeader) return line.trim().split(/\s+/).map(unquoted);
    const joined: string[] = [];
    for (const part of line.match(/"[^"]*"|[([{][^)\]}]*[)\]}]|[^\s([{"]+(?:[([{][^)\]}]*[)\]}])?/g) ?? []) {
      if (joined.length && '([{'.includes(part[0]!)) joined[joined.length - 1] += ` ${part}`;
      else joined.push(unquoted(part));
    }
    return joined;
  }
  if (!line.includes('"')) return line.split(separator).map((cell) => cell.trim());
  const cells: string[] = [];
  let cell = '';
  let inside = false;
  for (let k = 0; k < line.length; k += 1) {
    const c = line[k]!;
    if (c === '"' && inside && line[k + 1] === '"') {
      cell += '"';
      k += 1;
    } else if (c === '"') inside = !inside;
    else if (c === separator && !inside) {
      cells.push(cell.trim());
      cell = '';
    } else cell += c;
  }
  return [...cells, cell.trim()];
}

const unquoted = (cell: string): string => cell.trim().replace(/^"|"$/g, '');

/** The first row after a line that is neither empty nor a comment. */
function rowAfter(lines: string[], at: number, separator: string): string[] | null {
  const found = rowsOf(lines.slice(0, at + 50), at + 1, separator).next();
  return found.done ? null : found.value[1];
}

function* rowsOf(lines: string[], start: number, separator: string): Generator<[number, string[]]> {
  const own = separator === WIDE_BLANKS ? BLANKS : separator;
  for (let k = start; k < lines.length; k += 1) {
    const line = lines[k]!;
    if (!line || COMMENT.test(line)) continue;
    const text = /#(?:N\/A|NA|VALUE|DIV)/i.test(line) ? line : line.split('#')[0]!;
    if (!text.trim()) continue;
    const cells = split(text, own);
    if (cells.some(Boolean)) yield [k + 1, cells];
  }
}

interface Header {
  at: number;
  separator: string;
  cells: string[];
  commented: boolean;
}

function headerOf(lines: string[]): Header | null {
  let commented: Header | null = null;
  let uneven: Header | null = null;
  for (let at = 0; at < Math.min(lines.length, HEADER_LINES); at += 1) {
    const line = lines[at]!;
    if (!line.trim()) continue;
    const comment = COMMENT.test(line);
    const text = comment ? line.trim().replace(/^[#%!/]+/, '').trim() : line.split('#')[0]!.trimEnd();
    let best: [number, Header] | null = null;
    for (const separator of SEPARATORS) {
      const cells = split(text, separator, true);
      const n = names(cells);
      if (n > (best?.[0] ?? 0)) best = [n, { at, separator, cells, commented: comment }];
    }
    if (!best) continue;
    const row = rowAfter(lines, at, best[1].separator);
    const even = row !== null && best[1].cells.filter(Boolean).length <= row.length && row.length <= best[1].cells.length + 1;
    if (even && !comment) return best[1];
    if (even) commented = best[1];
    else if (!comment) uneven ??= best[1];
  }
  return commented ?? uneven;
}

/** The cells of a text table. */
export function cellsOf(name: string, text: string): Cells {
  const lines = text.replace(/^\ufeff/, '').split(/\r\n|\r|\n/);
  const found = headerOf(lines);
  if (!found) throw new Problem(`${name} has no line that names columns of directions; its first line is ${quoted(lines.find((line) => line.trim())?.trim() ?? '')}`, HINT);
  const notes: string[] = [];
  const before = lines.slice(0, found.at).filter((line) => line.trim() && !COMMENT.test(line) && !/^\s*sep=.\s*$/i.test(line));
  if (before.length) notes.push(`${before.length} line${before.length > 1 ? 's' : ''} before the header passed over, from '${before[0]!.trim().slice(0, 40)}' on`);
  if (found.commented) notes.push('The header stands in a comment, the last before the numbers');
  const numbered = [...rowsOf(lines, found.at + 1, found.separator)];
  return squared(name, { header: found.cells, rows: numbered.map(([, row]) => row), lines: numbered.map(([line]) => line), notes, units: [] });
}

function squared(name: string, table: Cells): Cells {
  let { header, rows, lines } = table;
  const { notes } = table;
  while (header.length && header.at(-1) === '' && rows.every((row) => row.length < header.length || row[header.length - 1] === '')) header = header.slice(0, -1);
  rows = rows.map((row) => {
    let end = row.length;
    while (end > header.length && row[end - 1] === '') end -= 1;
    return row.slice(0, end);
  });
  if (rows.length && rows.every((row) => row.length === header.length + 1) && areRowNames(rows.map((row) => row[0]!))) header = ['', ...header];
  const repeated = rows.map((row) => row.length === header.length && row.every((cell, k) => cell === header[k]));
  const count = repeated.filter(Boolean).length;
  if (count) {
    notes.push(`The header stands ${count} more time${count > 1 ? 's' : ''} further down, passed over`);
    rows = rows.filter((_, k) => !repeated[k]);
    lines = lines.filter((_, k) => !repeated[k]);
  }
  let units: string[] = [];
  const bare = (cell: string): string => cell.replace(/^[()[\] ]+|[()[\] ]+$/g, '');
  const first = rows[0];
  if (first && first.length <= header.length && first.some(Boolean) && first.every((cell) => cell === '' || isUnit(bare(cell))) && !first.some((cell) => NUMBER.test(cell))) {
    units = header.map((_, k) => bare(first[k] ?? ''));
    rows = rows.slice(1);
    lines = lines.slice(1);
    notes.push('The row below the header holds units');
  }
  rows.forEach((row, k) => {
    if (row.length !== header.length) throw new Problem(`${name}, line ${lines[k]} has ${row.length} cells; the header has ${header.length}`, 'Each row has a cell for each column, empty where nothing was measured');
  });
  return { header, rows, lines, notes, units };
}

function areRowNames(cells: string[]): boolean {
  if (cells.every((cell) => /^\d{1,9}$/.test(cell))) return (cells[0] === '0' || cells[0] === '1') && cells.every((cell, k) => Number(cell) - Number(cells[0]) === k);
  return !cells.some((cell) => NUMBER.test(cell));
}

/** Cells as numbers, by one decision for the table on what a comma means. */
export class Numbers {
  readonly decimalComma: boolean;

  constructor(
    private readonly name: string,
    private readonly table: Cells,
    columns: number[],
  ) {
    let comma: [number, string] | null = null;
    let point: [number, string] | null = null;
    table.rows.forEach((row, k) => {
      for (const at of columns) {
        const cell = row[at]!;
        if (cell.includes(',')) comma ??= [table.lines[k]!, cell];
        else if (cell.includes('.')) point ??= [table.lines[k]!, cell];
      }
    });
    const [withComma, withPoint] = [comma as [number, string] | null, point as [number, string] | null];
    if (withComma && withPoint && /\d\.\d|^\./.test(withPoint[1]) && /\d,\d/.test(withComma[1])) {
      throw new Problem(`${name} has numbers with decimal commas ('${withComma[1].slice(0, 20)}', line ${withComma[0]}) and with decimal points ('${withPoint[1].slice(0, 20)}', line ${withPoint[0]})`, 'Write all of them in one way');
    }
    this.decimalComma = withComma !== null;
  }

  /** A column, NaN where a cell says that there is no number, and the unit in its cells. */
  column(at: number): { values: number[]; unit: string } {
    let unit = '';
    const values = this.table.rows.map((row, k) => {
      const cell = this.decimalComma ? row[at]!.replaceAll(',', '.') : row[at]!;
      if (MISSING.has(cell.toLowerCase())) return NaN;
      let plain = cell.replaceAll('\u2212', '-').replace(/[\u00a0\u202f]/g, '');
      const both = NUMBER.test(plain) ? null : WITH_UNIT.exec(plain);
      if (both && isUnit(both[2]!)) {
        plain = both[1]!;
        if (unit && normal(both[2]!) !== normal(unit)) throw this.error(k, at, `'${both[2]!.trim()}' stands where '${unit}' stands above`);
        unit ||= both[2]!.trim();
      }
      const word = /^[-+]?inf(inity)?$/i.test(plain);
      const value = word ? (plain.startsWith('-') ? -Infinity : Infinity) : NUMBER.test(plain) ? Number(plain.replace(/[dD]/, 'e')) : NaN;
      if (Number.isNaN(value)) throw this.error(k, at, `'${cell.slice(0, 40)}' is not a number`);
      return value;
    });
    return { values, unit };
  }

  private error(row: number, at: number, what: string): Problem {
    return new Problem(`${this.name}, line ${this.table.lines[row]}: ${what} (column ${this.table.header[at] || at + 1})`, 'Leave a cell empty where nothing was measured');
  }
}
