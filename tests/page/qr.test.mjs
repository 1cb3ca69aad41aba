// The QR code of a link, read by another program than the one that writes it (jsQR).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import jsQR from 'jsqr';
import { MOST, qrModules } from '../../www/app/files/qr.js';

/** Of an address of that many letters. */
function link(length) {
  const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
  let text = 'https://kinematics.example/#d=1.';
  for (let at = 1; text.length < length; at = (at * 48271) % 2147483647) text += letters[at % 64];
  return text.slice(0, length);
}

/** Pixels with a quiet zone, three a module. */
function read(modules) {
  const [quiet, scale] = [4, 3];
  const side = (modules.length + 2 * quiet) * scale;
  const pixels = new Uint8ClampedArray(side * side * 4).fill(255);
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      if (modules[Math.floor(y / scale) - quiet]?.[Math.floor(x / scale) - quiet]) pixels.fill(0, (y * side + x) * 4, (y * side + x) * 4 + 3);
    }
  }
  return jsQR(pixels, side, side)?.data;
}

test('links of every length are read again as they were, up to the largest', () => {
  for (const length of [30, 90, 300, 800, 1500, 2300, MOST]) assert.equal(read(qrModules(link(length))), link(length), `${length} letters`);
  assert.equal(qrModules(link(MOST)).length, 177, 'version 40');
  assert.throws(() => qrModules(link(MOST + 1)));
});
