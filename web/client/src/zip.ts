// Archives without compression, of files that were chosen together. Their contents stay in the browser's files until
// they are sent.

const CRC = new Uint32Array(256).map((_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1;
  return n;
});

async function crc32(file: Blob): Promise<number> {
  const reader = file.stream().getReader();
  let crc = 0xffffffff;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return (crc ^ 0xffffffff) >>> 0;
    for (let i = 0; i < value.length; ++i) crc = CRC[(crc ^ value[i]) & 255] ^ crc >>> 8;
  }
}

/** Returns the files as a .zip archive, of less than 4 GB. */
export async function zip(files: File[], progress: (share: number) => void): Promise<Blob> {
  const parts: BlobPart[] = [], directory: BlobPart[] = [];
  let at = 0, listed = 0;
  for (const [i, file] of files.entries()) {
    progress(i / files.length);
    const name = new TextEncoder().encode(file.name), crc = await crc32(file);
    // Of both headers: version 2.0, names in UTF-8, stored, no time (1980-01-01), sizes, length of the name.
    const common = new DataView(new ArrayBuffer(26));
    common.setUint16(0, 20, true);
    common.setUint16(2, 0x800, true);
    common.setUint16(8, 0x21, true);
    common.setUint32(10, crc, true);
    common.setUint32(14, file.size, true);
    common.setUint32(18, file.size, true);
    common.setUint16(22, name.length, true);
    const end = new DataView(new ArrayBuffer(14));
    end.setUint32(10, at, true);
    parts.push("PK\x03\x04", common, name, file);
    directory.push("PK\x01\x02\x14\0", common, end, name);
    at += 30 + name.length + file.size;
    listed += 46 + name.length;
  }
  const last = new DataView(new ArrayBuffer(18));
  last.setUint16(4, files.length, true);
  last.setUint16(6, files.length, true);
  last.setUint32(8, listed, true);
  last.setUint32(12, at, true);
  return new Blob([...parts, ...directory, "PK\x05\x06", last]);
}
