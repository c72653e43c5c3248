// Links that contain a model.

async function packed(content: string): Promise<string> {
  const stream = new Blob([content]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return btoa(Array.from(bytes, (each) => String.fromCharCode(each)).join("")).replaceAll("+", "-").replaceAll("/", "_")
    .replaceAll("=", "");
}

async function unpacked(given: string): Promise<string> {
  const bytes = Uint8Array.from(atob(given.replaceAll("-", "+").replaceAll("_", "/")), (each) => each.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
}

export async function linkOf(name: string, text: string): Promise<string> {
  return `${location.origin}/#share=${await packed(JSON.stringify({ name, text }))}`;
}

/** Returns the document in a link; null if it has none. */
export async function documentIn(hash: string): Promise<{ name: string; text: string } | null> {
  try {
    const { name, text } = JSON.parse(await unpacked(hash.replace(/^share=/, "")));
    if (typeof text !== "string") return null;
    return { name: /^[A-Za-z0-9][\w .+-]{0,80}\.(frep|json)$/.test(name) ? name : "shared.frep", text };
  } catch {
    return null;
  }
}

/** Tells who can open a link to this server. */
export function reach(): string {
  const ours = ["127.0.0.1", "localhost", "[::1]"].includes(location.hostname);
  return ours ? `It names this machine (${location.host}): it opens here, and elsewhere only where fabserver runs at ` +
    "the same address." : `It opens wherever ${location.host} can be reached.`;
}
