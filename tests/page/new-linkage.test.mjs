// The sizes of a new linkage as they are typed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sizeOf } from '../../www/panels/types/size-of.js';

test('a size is a number with a comma or a point, nothing, or the text that Rust is to refuse', () => {
  for (const [typed, size] of [['350', 350], [' 0,35 ', 0.35], ['1e3', 1000], ['-2', -2], ['', undefined], ['  ', undefined], ['wide', 'wide'], ['1,2,3', '1,2,3'], ['Infinity', 'Infinity']]) {
    assert.equal(sizeOf(typed), size, typed);
  }
});
