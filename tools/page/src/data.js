// The data of the page: parts by name, as studies/report/bundle.h packs them.
import { csvParse } from "d3";

export class DamagedData extends Error {}

function bytes_of(base64) {
  let text;
  try {
    text = atob(base64);
  } catch {
    throw new DamagedData("they are no base64");
  }
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// zlib's stream ends with a checksum, so that damage is found here.
async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch (error) {
    throw new DamagedData(`they cannot be unpacked (${error.message})`);
  }
}

// The lowest bytes of all numbers, then the next.
function numbers_of(bytes, Type) {
  const numbers = new Type(bytes.length / Type.BYTES_PER_ELEMENT);
  for (let place = 0, from = 0; from < bytes.length; ++place, from += numbers.length)
    for (let i = 0; i < numbers.length; ++i) numbers[i] |= bytes[from + i] << (8 * place);
  return numbers;
}

const readers = {
  text: (bytes) => new TextDecoder().decode(bytes),
  u16: (bytes) => numbers_of(bytes, Uint16Array),
  u32: (bytes) => numbers_of(bytes, Uint32Array),
};

export class Parts {
  constructor(bytes) {
    let end = 0;
    while (end < bytes.length && !(bytes[end] === 10 && bytes[end + 1] === 10)) ++end;
    this.parts = new Map();
    let from = end + 2;
    for (const { name, type, bytes: size } of csvParse(readers.text(bytes.subarray(0, end)))) {
      this.parts.set(name, { type, bytes: bytes.subarray(from, from + Number(size)) });
      from += Number(size);
    }
    if (from !== bytes.length) throw new DamagedData("they are not as long as they should be");
  }
  has(name) {
    return this.parts.has(name);
  }
  get(name) {
    const { type, bytes } = this.parts.get(name);
    return readers[type](bytes);
  }
  // The rows of a table as texts; none where it is not there.
  table(name) {
    return this.has(name) ? csvParse(this.get(name)) : [];
  }
}

// The physical units of columns and fields; without units.csv there are none, and numbers are as in the tables.
export class Units {
  constructor(parts) {
    this.by_name = new Map(parts.table("units.csv").map(({ name, unit, factor }) => [name, { unit, factor: Number(factor) }]));
    this.there = this.by_name.size > 0;
  }
  // "energy (kT)"
  titled(name, title = name) {
    const found = this.by_name.get(name);
    return found ? `${title} (${found.unit})` : title;
  }
  // "2 kT", of a number that is in the unit already.
  after(name, number) {
    const found = this.by_name.get(name);
    return found && number !== "" ? `${number} ${found.unit}` : number;
  }
  // The ends of a range of a field as it is in the files.
  shown(name, range) {
    const factor = this.by_name.get(name)?.factor ?? 1;
    return range.map((value) => factor * value);
  }
}

export async function unpacked(script) {
  return new Parts(await inflated(bytes_of(script.textContent.trim())));
}

// Undoes `differences` of studies/report/bundle.h, in place.
export function summed(numbers, stride) {
  for (let i = stride; i < numbers.length; ++i) numbers[i] += numbers[i - stride];
  return numbers;
}

const unknown = 65535;

// Numbers in 16 bits as they were.
export function dequantised(numbers, low, high) {
  const step = (high - low) / (unknown - 1), values = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; ++i) values[i] = numbers[i] === unknown ? NaN : low + step * numbers[i];
  return values;
}
