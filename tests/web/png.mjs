// Just enough of PNG to say where two pictures differ.

import {inflateSync} from 'node:zlib';

/// Width, height, bytes a pixel, and rows of a PNG of 8 bits a channel without interlace; undefined for anything else.
export function readPng(bytes) {
    if (bytes.length < 33 || bytes.toString('latin1', 1, 4) !== 'PNG') return undefined;
    const parts = [];
    let width = 0, height = 0, channels = 0;
    for (let at = 8; at + 12 <= bytes.length;) {
        const length = bytes.readUInt32BE(at), kind = bytes.toString('latin1', at + 4, at + 8);
        const part = bytes.subarray(at + 8, at + 8 + length);
        if (kind === 'IHDR') [width, height, channels] = [part.readUInt32BE(0), part.readUInt32BE(4), {0: 1, 2: 3, 4: 2, 6: 4}[part[9]]];
        if (kind === 'IDAT') parts.push(part);
        at += 12 + length;
    }
    const packed = inflateSync(Buffer.concat(parts)), stride = width * channels, rows = [];
    for (let y = 0; y < height; ++y) {
        const filter = packed[y * (stride + 1)], row = Buffer.from(packed.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1)));
        for (let x = 0; x < stride; ++x) {
            const left = x < channels ? 0 : row[x - channels], up = y ? rows[y - 1][x] : 0, corner = y && x >= channels ? rows[y - 1][x - channels] : 0;
            const guess = left + up - corner, [a, b, c] = [left, up, corner].map(value => Math.abs(guess - value));
            row[x] += [0, left, up, (left + up) >> 1, a <= b && a <= c ? left : b <= c ? up : corner][filter];
        }
        rows.push(row);
    }
    return {width, height, channels, rows};
}

/// Where two pictures differ, as a sentence.
export function firstDifference(seen, expected) {
    const a = readPng(seen), b = readPng(expected);
    if (!a || !b) return `expected a PNG of ${expected.length} bytes, saw ${seen.length} bytes, which are ${a ? 'one' : 'none'}`;
    if (a.width !== b.width || a.height !== b.height) return `expected ${b.width} x ${b.height} pixels, saw ${a.width} x ${a.height}`;
    const pixel = (image, x, y) => [...image.rows[y].subarray(x * image.channels, (x + 1) * image.channels)].join(',');
    let count = 0, first = '';
    for (let y = 0; y < a.height; ++y) {
        for (let x = 0; x < a.width; ++x) {
            if (pixel(a, x, y) === pixel(b, x, y)) continue;
            if (!count++) first = `the first in row ${y}, column ${x}: expected ${pixel(b, x, y)}, saw ${pixel(a, x, y)}`;
        }
    }
    return count ? `${count} pixels are different, ${first}` : 'the pixels are the same, the bytes of the PNG are not';
}
