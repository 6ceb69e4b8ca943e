// The picture on the canvas: what the worker has sent, and how places of the world and of the canvas belong together.
import { Discs, shadesOf } from './discs.js';
import { Sleepers } from './sleepers.js';

const SHADES = 24;
const GROUND = '#131922';
const OUTSIDE = '#0b0e13';
const EDGE = '#3b4756';
const STATIC = '#5a6878';
const BELT = '#8a6a3a';
const WARM = '#ffb454';
const STRIDE = 5; // numbers a circle: x, y, radius, shade and angle
const PIECE_STRIDE = 13; // numbers a piece: form, shade, ends and thickness of lines, then centre, radius, angles and side of arcs
const [SEGMENT, ARC] = [1, 3]; // forms
const JOINT_STRIDE = 5; // numbers a joint: ends and shade
const POINT_STRIDE = 3; // numbers a point of an outline: x, y and the number of the body
const FILLING = 0.6; // the part of its colour in the inside of a soft body; the rest is ground
const TENSION = ['#6f8aa3', '#b9c7d3', '#ffd166', '#ff7a45', '#e8505b'];
const DOT = 2.5; // pixels: the radius of a joint without length
const BAND = 4; // pixels of the solid side of a chain
const MARK = 0.3; // of the colour's light
const ASLEEP = 0.5; // the part of its colour in a circle that sleeps; the rest is ground
const MARK_AT = 0.52; // in radii of the circle, from its centre
const MARK_RADIUS = 0.26; // likewise
const MARK_FROM = 2.5; // pixels: the mark on a smaller circle would be a speck
const BLAST_MILLIS = 400;
const BLAST_REACH = 22.5; // radii of usual circles
const RAMPS = [
  ['#4aa8d8', '#5bc0be', '#7fb7e6', '#9b8cf0', '#6d9eeb', '#48c9b0', '#8fd3f4', '#74a9cf'],
  ['#5c83bd', '#4597cf', '#35b6c4', '#9fdc7c', '#ffd166', '#ff7a45', '#ffe9dc'],
  ['#4f7398', '#6a66bd', '#b04bb0', '#e0526f', '#ff9a56', '#fff1b8'],
];

const rgb = colour => [16, 8, 0].map(shift => parseInt(colour.slice(1), 16) >> shift & 255);

/** The colours of static circles and of belts, then those of a ramp. */
function coloursOf(ramp) {
  const stops = ramp.map(rgb);
  const colours = Array.from({ length: SHADES }, (_, k) => {
    const place = k / (SHADES - 1) * (stops.length - 1);
    const stop = Math.min(Math.floor(place), stops.length - 2);
    return stops[stop].map((part, channel) => part + (stops[stop + 1][channel] - part) * (place - stop));
  });
  return [rgb(STATIC), rgb(BELT), ...colours];
}

const onGround = (colour, part) => colour.map((own, channel) => part * own + (1 - part) * rgb(GROUND)[channel]);
const asleep = colour => onGround(colour, ASLEEP);
const marked = colour => colour.map(part => MARK * part);

const palettes = RAMPS.map(coloursOf).map(colours => ({
  circles: shadesOf(colours),
  marks: shadesOf(colours.map(marked)),
  sleepers: shadesOf(colours.map(asleep)),
  marksOfSleepers: shadesOf(colours.map(asleep).map(marked)),
}));
const fillings = RAMPS[0].map(colour => onGround(rgb(colour), FILLING));

export class Drawing {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', { alpha: false });
    this.sleepers = new Sleepers(rgb(GROUND), rgb(OUTSIDE));
    this.fit([0, 0, 1, 1], [false, false]);
  }

  /** Chooses the scale at which a part of the world is whole on the canvas, in its middle. An axis that is open has no edges. */
  fit([minX, minY, maxX, maxY], [openX, openY]) {
    const { width, height } = this.canvas;
    this.scale = Math.min(width / (maxX - minX), height / (maxY - minY));
    this.left = (width - this.scale * (minX + maxX)) / 2;
    this.bottom = (height + this.scale * (minY + maxY)) / 2;
    this.arena = [openX ? 0 : this.x(minX), openY ? 0 : this.y(maxY), openX ? width : this.x(maxX), openY ? height : this.y(minY)];
  }

  // From the world to the canvas, on which y points down.
  x(x) {
    return this.left + x * this.scale;
  }
  y(y) {
    return this.bottom - y * this.scale;
  }

  /** Where in the world a pointer is. */
  place(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width * this.canvas.width;
    const y = (event.clientY - box.top) / box.height * this.canvas.height;
    return { x: (x - this.left) / this.scale, y: (this.bottom - y) / this.scale };
  }

  /** Draws a picture in the colours of a mode, with the line of a joint that is being drawn, and explosions. Says whether one goes on. */
  draw(picture, mode, line, blasts) {
    const { canvas, context } = this;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width === 0 || height === 0) {
      return true; // the page is hidden, or not laid out yet
    }
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
      this.discs = new Discs(width, height, rgb(GROUND), rgb(OUTSIDE));
    }
    this.fit(picture.view, picture.open);
    const palette = palettes[mode];
    this.discs.pixels.set(this.sleepers.pixels(this, palette.sleepers, palette.marksOfSleepers));
    this.fillBlobs(picture.blobs);
    for (let k = 0; k < picture.circles.length; k += STRIDE) {
      this.drawCircle(this.discs, picture.circles, k, palette.circles, palette.marks);
    }
    context.putImageData(this.discs.image, 0, 0);
    const [left, top, right, bottom] = this.arena;
    context.strokeStyle = EDGE;
    context.lineWidth = ratio;
    context.strokeRect(left - ratio, top - ratio, right - left + 2 * ratio, bottom - top + 2 * ratio);
    this.drawJoints(picture.joints, ratio);
    this.drawTerrain(picture.pieces, ratio);
    if (line) {
      context.strokeStyle = WARM;
      context.lineWidth = 2 * ratio;
      this.stroke(line.x, line.y, line.toX, line.toY);
    }
    return this.drawBlasts(blasts, BLAST_REACH * picture.view[4], ratio);
  }

  stroke(x, y, toX, toY) {
    this.context.beginPath();
    this.context.moveTo(this.x(x), this.y(y));
    this.context.lineTo(this.x(toX), this.y(toY));
    this.context.stroke();
  }

  /** Fills the outlines of soft bodies. Numbers of bodies that follow each other differ. */
  fillBlobs(blobs) {
    let points = [];
    for (let k = 0; k < blobs.length; k += POINT_STRIDE) {
      const number = blobs[k + 2];
      points.push(this.x(blobs[k]), this.y(blobs[k + 1]));
      if (blobs[k + POINT_STRIDE + 2] !== number) { // the last point
        this.discs.fill(points, fillings[(number * 5 + (number >>> 3)) % fillings.length]);
        points = [];
      }
    }
  }

  /** Draws one of some circles. */
  drawCircle(discs, circles, k, palette, marks) {
    const shade = circles[k + 3];
    const colour = shade < 0 ? -1 - shade : 2 + Math.round(shade * (SHADES - 1));
    const x = this.x(circles[k]);
    const y = this.y(circles[k + 1]);
    const radius = circles[k + 2] * this.scale;
    discs.draw(x, y, radius, palette, colour);
    const angle = circles[k + 4]; // NaN if the circle has no mark
    if (angle === angle && radius >= MARK_FROM) {
      const reach = MARK_AT * radius;
      discs.draw(x + reach * Math.cos(angle), y - reach * Math.sin(angle), MARK_RADIUS * radius, marks, colour);
    }
  }

  /** All joints of a colour at once. */
  drawJoints(joints, ratio) {
    const { context } = this;
    context.lineWidth = 1.5 * ratio;
    TENSION.forEach((colour, shade) => {
      context.strokeStyle = context.fillStyle = colour;
      context.beginPath();
      for (let k = 0; k < joints.length; k += JOINT_STRIDE) {
        if (Math.round(joints[k + 4] * (TENSION.length - 1)) === shade) {
          const [x, y, x2, y2] = [this.x(joints[k]), this.y(joints[k + 1]), this.x(joints[k + 2]), this.y(joints[k + 3])];
          if (Math.hypot(x2 - x, y2 - y) < DOT) {
            context.fillRect(x - DOT * ratio, y - DOT * ratio, 2 * DOT * ratio, 2 * DOT * ratio);
          }
          context.moveTo(x, y);
          context.lineTo(x2, y2);
        }
      }
      context.stroke();
    });
  }

  drawTerrain(pieces, ratio) {
    const { context, scale } = this;
    const band = BAND * ratio;
    context.lineCap = 'round';
    for (let k = 0; k < pieces.length; k += PIECE_STRIDE) {
      const [form, shade, x, y, x2, y2, thickness, centreX, centreY, r, from, to, inside] = pieces.subarray(k, k + PIECE_STRIDE);
      context.strokeStyle = shade === -2 ? BELT : STATIC;
      context.lineWidth = form === SEGMENT ? Math.max(2 * thickness * scale, band) : band;
      if (form === ARC) { // y points down, so angles do, too
        const radius = r * scale + (inside ? band / 2 : -band / 2);
        context.beginPath();
        context.arc(this.x(centreX), this.y(centreY), Math.max(radius, 0), -from, -to, true);
        context.stroke();
      } else { // a line of a chain is solid on its left
        const factor = form === SEGMENT ? 0 : band / 2 / scale / Math.hypot(x2 - x, y2 - y);
        const [left, up] = [(y - y2) * factor, (x2 - x) * factor];
        this.stroke(x + left, y + up, x2 + left, y2 + up);
      }
    }
  }

  drawBlasts(blasts, reach, ratio) {
    const { context } = this;
    let goesOn = false;
    for (const blast of blasts) {
      const age = (performance.now() - blast.at) / BLAST_MILLIS;
      if (age < 1) {
        goesOn = true;
        context.strokeStyle = `rgba(255,180,84,${1 - age})`;
        context.lineWidth = 3 * ratio;
        context.beginPath();
        context.arc(this.x(blast.x), this.y(blast.y), reach * Math.sqrt(age) * this.scale, 0, 7);
        context.stroke();
      }
    }
    return goesOn;
  }
}
