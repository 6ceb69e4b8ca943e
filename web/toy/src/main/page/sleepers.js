// The circles that sleep, on a layer of pixels that stays: only what is near to those that fall asleep or wake is drawn again.
import { Discs } from './discs.js';

const TILE = 64; // pixels
const STRIDE = 5; // numbers a circle

export class Sleepers {
  constructor(ground, outside) {
    this.colours = [ground, outside];
    this.numbers = new Float32Array(0); // by id: x, y, radius, shade and angle
    this.isHere = new Uint8Array(0); // by id
    this.tiles = []; // the ids of the circles that reach into each, and whether one has come or gone
  }

  /** Takes the circles that have fallen asleep, each behind its id, and the ids of those that have woken; all, if the world is another. */
  take({ fresh, rested, woken }) {
    if (fresh) {
      this.isHere.fill(0);
      this.tiles = [];
      this.layout = undefined;
    }
    for (const id of woken) {
      this.isHere[id] = 0;
      this.mark(id);
    }
    for (let k = 0; k < rested.length; k += STRIDE + 1) {
      const id = rested[k];
      this.reserve(id);
      this.numbers.set(rested.subarray(k + 1, k + 1 + STRIDE), STRIDE * id);
      this.isHere[id] = 1;
      this.mark(id);
    }
  }

  reserve(id) {
    if (id >= this.isHere.length) {
      const [numbers, isHere] = [this.numbers, this.isHere];
      const room = Math.max(1024, 2 * id);
      this.numbers = new Float32Array(STRIDE * room);
      this.numbers.set(numbers);
      this.isHere = new Uint8Array(room);
      this.isHere.set(isHere);
    }
  }

  /** The layer as it is now. A drawing knows where circles are on it, and draws them. */
  pixels(drawing, palette, marks) {
    const { width, height } = drawing.canvas;
    const layout = [width, height, drawing.scale, drawing.left, drawing.bottom, ...drawing.arena].join();
    if (layout !== this.layout) {
      this.lay(drawing, width, height);
      this.layout = layout;
    }
    const box = drawing.arena.map(Math.round);
    this.tiles.forEach((tile, k) => {
      if (tile.isOld) {
        const [left, top] = [k % this.columns * TILE, Math.floor(k / this.columns) * TILE];
        this.layer.clip(left, top, left + TILE, top + TILE);
        this.layer.clear(...box);
        tile.ids = [...new Set(tile.ids)].filter(id => this.isHere[id]);
        for (const id of tile.ids) {
          drawing.drawCircle(this.layer, this.numbers, STRIDE * id, palette, marks);
        }
        tile.isOld = false;
      }
    });
    return this.layer.pixels;
  }

  /** Begins the layer anew, as when the window has another size. */
  lay(drawing, width, height) {
    if (this.layer?.image.width !== width || this.layer.image.height !== height) {
      this.layer = new Discs(width, height, ...this.colours);
    }
    this.place = { x: drawing.left, y: drawing.bottom, scale: drawing.scale };
    this.columns = Math.ceil(width / TILE);
    this.rows = Math.ceil(height / TILE);
    this.tiles = Array.from({ length: this.columns * this.rows }, () => ({ ids: [], isOld: true }));
    this.isHere.forEach((isHere, id) => {
      if (isHere) {
        this.mark(id);
      }
    });
  }

  /** A circle has come to the tiles that it reaches into, or has gone. */
  mark(id) {
    if (this.tiles.length === 0) {
      return; // the layer will be laid out
    }
    const { x, y, scale } = this.place;
    const [centreX, centreY] = [x + this.numbers[STRIDE * id] * scale, y - this.numbers[STRIDE * id + 1] * scale];
    const reach = this.numbers[STRIDE * id + 2] * scale + 1;
    const right = Math.min(this.columns - 1, Math.floor((centreX + reach) / TILE));
    const bottom = Math.min(this.rows - 1, Math.floor((centreY + reach) / TILE));
    for (let row = Math.max(0, Math.floor((centreY - reach) / TILE)); row <= bottom; row++) {
      for (let column = Math.max(0, Math.floor((centreX - reach) / TILE)); column <= right; column++) {
        const tile = this.tiles[row * this.columns + column];
        tile.isOld = true;
        tile.ids.push(id);
      }
    }
  }
}
