// Discs as pixels. A canvas fills thousands of paths, or copies thousands of pictures, in more time than a frame has.
const LEVELS = 32; // between the colour of a disc and that of its rim
const RIM = 0.62; // of the colour's light
const INNER = 0.86; // of the radius: the rim is outside

/** Opaque, as a little-endian machine has the four bytes of a pixel. */
const pixel = (red, green, blue) => 0xff000000 | blue << 16 | green << 8 | red;

/** All shades of some colours, which are arrays of red, green and blue: for each colour from that of its rim to its own. */
export function shadesOf(colours) {
  const shades = new Int32Array(colours.length * (LEVELS + 1));
  colours.forEach((colour, k) => {
    for (let level = 0; level <= LEVELS; level++) {
      const light = RIM + (1 - RIM) * level / LEVELS;
      shades[k * (LEVELS + 1) + level] = pixel(...colour.map(part => Math.round(part * light)));
    }
  });
  return shades;
}

export class Discs {
  constructor(width, height, ground, outside) {
    this.image = new ImageData(width, height);
    this.pixels = new Int32Array(this.image.data.buffer);
    this.ground = pixel(...ground);
    this.outside = pixel(...outside);
    this.clip(0, 0, width, height);
  }

  /** Leaves all as it is but a box, whose numbers are whole. */
  clip(left, top, right, bottom) {
    const { width, height } = this.image;
    [this.left, this.top, this.right, this.bottom] = [left, top, Math.min(right, width), Math.min(bottom, height)];
  }

  /** Leaves ground in a box, whose numbers are whole, and what is outside around it. */
  clear(left, top, right, bottom) {
    const { width } = this.image;
    const inside = x => Math.max(this.left, Math.min(x, this.right));
    for (let row = this.top; row < this.bottom; row++) {
      this.pixels.fill(this.outside, row * width + this.left, row * width + this.right);
      if (row >= top && row < bottom) {
        this.pixels.fill(this.ground, row * width + inside(left), row * width + inside(right));
      }
    }
  }

  /** Fills a polygon, whose points are an array of x and y one behind the other, with an opaque colour. */
  fill(points, colour) {
    const { width } = this.image;
    const own = pixel(...colour);
    const heights = points.filter((_, k) => k % 2 === 1);
    const bottom = Math.min(this.bottom, Math.ceil(Math.max(...heights) - 0.5));
    for (let row = Math.max(this.top, Math.ceil(Math.min(...heights) - 0.5)); row < bottom; row++) {
      const crossings = [];
      for (let k = 0; k < points.length; k += 2) {
        const [x, y, toX, toY] = [points[k], points[k + 1], points[(k + 2) % points.length], points[(k + 3) % points.length]];
        if (y <= row + 0.5 !== toY <= row + 0.5) {
          crossings.push(x + (row + 0.5 - y) / (toY - y) * (toX - x));
        }
      }
      crossings.sort((a, b) => a - b);
      for (let k = 0; k < crossings.length; k += 2) {
        const [from, to] = [crossings[k], crossings[k + 1]].map(x => Math.max(this.left, Math.min(Math.ceil(x - 0.5), this.right)));
        this.pixels.fill(own, row * width + from, row * width + to);
      }
    }
  }

  /** Draws a disc about (x, y) in a colour of the shades. Lengths are in pixels, and y points down. */
  draw(x, y, radius, shades, colour) {
    const { pixels } = this;
    const { width } = this.image;
    const first = colour * (LEVELS + 1);
    const own = shades[first + LEVELS];
    const outer = radius + 0.5; // nothing is drawn from here on
    const inner = INNER * radius;
    const solid = Math.max(0, inner - 0.5); // own colour up to here
    const bottom = Math.min(this.bottom, Math.ceil(y + outer - 0.5));
    for (let row = Math.max(this.top, Math.ceil(y - outer - 0.5)); row < bottom; row++) {
      const dy = row + 0.5 - y;
      const half = Math.sqrt(Math.max(0, outer * outer - dy * dy));
      const solidHalf = dy * dy < solid * solid ? Math.sqrt(solid * solid - dy * dy) : 0;
      const line = row * width;
      const end = line + Math.min(this.right, Math.ceil(x + half - 0.5));
      const solidBegin = line + Math.max(this.left, Math.ceil(x - solidHalf - 0.5));
      const solidEnd = line + Math.min(this.right, Math.ceil(x + solidHalf - 0.5));
      let at = line + Math.max(this.left, Math.ceil(x - half - 0.5));
      while (at < end) {
        if (at === solidBegin && solidEnd > solidBegin) {
          while (at < solidEnd) {
            pixels[at++] = own;
          }
          continue;
        }
        const dx = at - line + 0.5 - x;
        const distance = Math.sqrt(dx * dx + dy * dy);
        const lit = Math.min(1, Math.max(0, inner - distance + 0.5));
        const shade = shades[first + (lit * LEVELS | 0)];
        const cover = outer - distance;
        pixels[at] = cover >= 1 ? shade : blend(pixels[at], shade, cover * 256 | 0);
        at++;
      }
    }
  }
}

/** A pixel under another that covers a part of it, in 256ths. */
function blend(below, above, part) {
  const redBlue = below & 0xff00ff;
  const green = below & 0xff00;
  return 0xff000000
    | redBlue + (Math.imul((above & 0xff00ff) - redBlue, part) >> 8) & 0xff00ff
    | green + (Math.imul((above & 0xff00) - green, part) >> 8) & 0xff00;
}
