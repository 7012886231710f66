import { options, positive, typeError } from '../validate.js';
import { alphaOf, Cutter, packedColor, redGreenBlue } from './cutter.js';
import type { DebugGraphicsDevice, DebugLines } from './device.js';

/** Options of `SVGDebugDevice.create`. */
export interface SVGDebugDeviceParams {
  /** px, > 0. */
  width: number;
  /** px, > 0. */
  height: number;
  /** px, > 0. Default 1. */
  lineWidth?: number | undefined;
  /** Any colour of CSS, such as `'#102030'`. Default: none. */
  background?: string | undefined;
  /** Description of the picture, for those who cannot see it. Default: none. */
  title?: string | undefined;
}

/** Draws debug lines as an SVG document: pictures for documentation and tests, also in Node. */
export class SVGDebugDevice implements DebugGraphicsDevice {
  readonly width: number;
  readonly height: number;
  private readonly lineWidth: number;
  private readonly background: string;
  private readonly title: string;
  private readonly cutter = new Cutter();
  private paths: string[] = [];

  /** @internal use `create` */
  constructor(params: SVGDebugDeviceParams) {
    const where = 'SVGDebugDevice.create';
    const { width, height, lineWidth = 1, background = '', title = '' } = options(where, params, true);
    this.width = positive(where, 'width', width);
    this.height = positive(where, 'height', height);
    this.lineWidth = positive(where, 'lineWidth', lineWidth);
    this.background = escaped(where, 'background', background);
    this.title = escaped(where, 'title', title);
  }

  /** Makes a device that collects what is drawn as a picture. */
  static create(params: SVGDebugDeviceParams): SVGDebugDevice {
    return new SVGDebugDevice(params);
  }

  /** Adds the lines to the document, over what is there. */
  drawLines(lines: DebugLines): void {
    const { cutter, paths } = this;
    const { ends } = cutter;
    cutter.begin(lines, this.width, this.height);
    let color = -1;
    let path = '';
    let at = '';
    for (let i = 0; i < lines.segmentCount; i += 1) {
      if (cutter.cut(lines, i)) {
        const next = packedColor(lines, i);
        if (next !== color) {
          paths.push(pathElement(color, path));
          color = next;
          path = '';
          at = '';
        }
        const from = `${short(ends[0]!)} ${short(ends[1]!)}`;
        const to = `${short(ends[2]!)} ${short(ends[3]!)}`;
        path += `${from === at ? '' : `M${from}`}L${to}`;
        at = to;
      }
    }
    paths.push(pathElement(color, path));
  }

  /** Empties the document. */
  clear(): void {
    this.paths = [];
  }

  /** The document. */
  toString(): string {
    const { width, height, background, title } = this;
    const name = title === '' ? '' : `<title>${title}</title>\n`;
    const back = background === '' ? '' : `<rect width="${width}" height="${height}" fill="${background}"/>\n`;
    const size = `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"`;
    const pen = `fill="none" stroke-width="${this.lineWidth}" stroke-linejoin="round"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size}>\n${name}${back}<g ${pen}>\n${this.paths.join('')}</g>\n</svg>\n`;
  }
}

/** A text with the special characters of XML escaped. */
function escaped(where: string, name: string, value: unknown): string {
  if (typeof value !== 'string') {
    throw typeError(where, name, 'a string', value);
  }
  return value.replace(/[<>&"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
}

function pathElement(color: number, path: string): string {
  if (path === '') {
    return '';
  }
  const alpha = alphaOf(color);
  const opacity = alpha === 1 ? '' : ` stroke-opacity="${alpha}"`;
  return `<path stroke="rgb(${redGreenBlue(color)})"${opacity} d="${path}"/>\n`;
}

/** A length in px, to two decimals. */
function short(px: number): string {
  return String(Math.round(100 * px) / 100);
}
