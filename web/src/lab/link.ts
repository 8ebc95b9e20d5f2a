// A scenario in the address, after `#`: a version, a point, the scenario file deflated, in base64 for addresses.

import { Inflate, deflateSync, strFromU8, strToU8 } from "fflate";

const VERSION = "1";
/** No scenario is longer, deflated or not. */
const LONGEST = 1 << 16;
const LONGEST_TEXT = 1 << 18;

export function encode(text: string): string {
  const bytes = deflateSync(strToU8(text), { level: 9 });
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return `${VERSION}.${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

/** What a link holds: a scenario file, nothing at all, or what is wrong with it. */
export type Decoded = { text: string } | { wrong: "broken" | "huge" | "newer" } | undefined;

export function decode(hash: string): Decoded {
  const body = hash.replace(/^#/, "");
  if (body === "") return undefined;
  const [, version, payload] = /^(\d{1,6})\.(.*)$/s.exec(body) ?? [];
  if (version === undefined || payload === undefined) return { wrong: "broken" };
  if (Number(version) > Number(VERSION)) return { wrong: "newer" };
  if (payload.length > LONGEST) return { wrong: "huge" };
  if (version !== VERSION || !/^[\w-]+$/.test(payload)) return { wrong: "broken" };
  try {
    const binary = atob(payload.replaceAll("-", "+").replaceAll("_", "/"));
    return inflated(Uint8Array.from(binary, (c) => c.charCodeAt(0)));
  } catch {
    return { wrong: "broken" };
  }
}

/** Inflates piece by piece, so that a small link never becomes a huge text. */
function inflated(bytes: Uint8Array): Decoded {
  const chunks: Uint8Array[] = [];
  let size = 0;
  let ended = false;
  const inflate = new Inflate((chunk, final) => {
    size += chunk.length;
    ended ||= final;
    if (size <= LONGEST_TEXT) chunks.push(chunk);
  });
  const PIECE = 256;
  for (let at = 0; at < bytes.length && size <= LONGEST_TEXT; at += PIECE) {
    inflate.push(bytes.subarray(at, at + PIECE), at + PIECE >= bytes.length);
  }
  if (size > LONGEST_TEXT) return { wrong: "huge" };
  const whole = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    whole.set(chunk, at);
    at += chunk.length;
  }
  const text = strFromU8(whole);
  return (ended as boolean) && text.includes("precess") ? { text } : { wrong: "broken" };
}
