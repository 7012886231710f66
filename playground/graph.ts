import { pixelRatio } from './elements.js';
import type { Times } from './simulation.js';

/** Frames that are shown, and ms at the top: so many at least. */
const FRAMES = 150;
const LEAST_TOP = 4;

/** What is no phase of a step. */
export const DRAWING = 'drawing';

/** ms of the parts of the last frames, stacked; the newest on the right. */
export class Graph {
  /** Names in the order in which they came. */
  private readonly names: string[] = [];
  private readonly frames: number[][] = [];
  private readonly context: CanvasRenderingContext2D;
  /** ms. What the legend says: means of the last frames. */
  private readonly means = new Map<string, number>();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly legend: HTMLElement,
  ) {
    this.context = canvas.getContext('2d')!;
  }

  add(times: Times): void {
    for (const name of times.keys()) {
      if (!this.names.includes(name)) {
        this.names.push(name);
      }
    }
    this.frames.push(this.names.map((name) => times.get(name) ?? 0));
    if (this.frames.length > FRAMES) {
      this.frames.shift();
    }
    for (const name of this.names) {
      const value = times.get(name) ?? 0;
      this.means.set(name, 0.9 * (this.means.get(name) ?? value) + 0.1 * value);
    }
  }

  clear(): void {
    this.names.length = 0;
    this.frames.length = 0;
    this.means.clear();
  }

  draw(): void {
    const { canvas, context, frames } = this;
    const ratio = pixelRatio();
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const style = getComputedStyle(canvas);
    const accent = style.color;
    const faint = style.borderTopColor;
    const quiet = style.outlineColor;
    const sums = frames.map((frame) => frame.reduce((sum, value) => sum + value, 0)).sort((a, b) => a - b);
    // A frame that is late now and then may stand out.
    const most = Math.max(LEAST_TOP, sums[Math.floor(0.97 * sums.length)] ?? 0);
    const top = [4, 8, 16, 32, 64, 128, 256].find((value) => value >= most) ?? most;
    context.clearRect(0, 0, width, height);
    context.fillStyle = faint;
    for (const share of [0, 0.5]) {
      context.fillRect(0, Math.round(height * share), width, ratio);
    }
    const bar = width / FRAMES;
    frames.forEach((frame, i) => {
      const x = width - (frames.length - i) * bar;
      let y = height;
      frame.forEach((value, part) => {
        const size = (value / top) * height;
        const isDrawing = this.names[part] === DRAWING;
        context.fillStyle = isDrawing ? quiet : accent;
        context.globalAlpha = isDrawing ? 0.5 : strength(part);
        context.fillRect(x, y - size, Math.max(ratio, bar - ratio / 2), size);
        y -= size;
      });
    });
    context.globalAlpha = 1;
    this.write(top);
  }

  private write(top: number): void {
    const items = this.names.map((name, i) => {
      const item = document.createElement('li');
      const mark = document.createElement('i');
      mark.className = name;
      mark.style.opacity = name === DRAWING ? '' : String(strength(i));
      const value = document.createElement('b');
      value.textContent = (this.means.get(name) ?? 0).toFixed(2);
      const label = document.createElement('span');
      label.textContent = name;
      item.append(mark, label, value);
      return item;
    });
    const scale = document.createElement('li');
    scale.className = 'scale';
    scale.textContent = `ms; full height ${top.toFixed(0)}`;
    this.legend.replaceChildren(...items, scale);
  }
}

/** Of the colour of a part. */
function strength(part: number): number {
  return [1, 0.3, 0.6, 0.4, 0.85, 0.5, 0.25, 0.7, 0.4][part % 9]!;
}
