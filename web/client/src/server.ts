// Requests to the server (docs/web.md).

export interface Mistake { message: string; line: number; column: number; offset: number; length: number }
export interface Parameter {
  name: string; value: number; range: [number, number] | null; comment: string; offset: number; length: number
}
export interface LibraryFunction {
  name: string; group: string; signature: string; meaning: string; any_number: boolean;
  parameters: { name: string; kind: string; default: number | null }[];
}
export type Box = [number, number, number, number, number, number];
export type Window4 = [number, number, number, number];

/** A picture, or facts about a text. */
export interface Answer {
  type: "picture" | "parameters" | "error"; number: number; view: string;
  quality?: "coarse" | "fine" | "smooth"; last?: boolean; mode?: string; window?: Window4; bounds?: Box; flat?: boolean;
  message?: string; kind?: string; mistakes?: Mistake[]; parameters?: Parameter[]; image?: Blob;
}

/** A refused request: its status, kind and message. */
export class Refusal extends Error {
  constructor(readonly status: number, readonly kind: string, message: string, readonly mistakes: Mistake[] = []) {
    super(message);
  }
}

/** Requests an address. Throws Refusal, or TypeError if the server cannot be reached. */
export async function ask(path: string, options: RequestInit = {}): Promise<Response> {
  const answer = await fetch(path, options);
  if (answer.ok) return answer;
  const { error } = await answer.json().catch(() => ({ error: { kind: "http", message: answer.statusText } }));
  throw new Refusal(answer.status, error.kind, error.message, error.mistakes);
}

export async function post<T>(path: string, body: unknown): Promise<T> {
  return (await ask(path, { method: "POST", body: JSON.stringify(body) })).json();
}

/** The WebSocket; reopened after it closes. */
export class Connection {
  private socket: WebSocket | null = null;
  private wait = 250;
  readonly listeners = new Map<string, (answer: Answer) => void>();
  onState: (open: boolean) => void = () => {};
  onOpen: (() => void)[] = [];

  constructor() { this.connect(); }

  private connect(): void {
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/socket`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.socket = socket;
      this.wait = 250;
      this.onState(true);
      for (const each of this.onOpen) each();
    };
    socket.onmessage = ({ data }) => this.take(data);
    socket.onclose = () => {
      this.socket = null;
      this.onState(false);
      setTimeout(() => this.connect(), this.wait);
      this.wait = Math.min(2 * this.wait, 2000);
    };
  }

  private take(data: string | ArrayBuffer): void {
    let answer: Answer;
    if (typeof data === "string") answer = JSON.parse(data);
    else {
      const length = new DataView(data).getUint32(0);
      answer = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
      answer.image = new Blob([new Uint8Array(data, 4 + length)], { type: "image/png" });
    }
    this.listeners.get(answer.view)?.(answer);
  }

  /** Sends a message. Returns false if the server cannot be reached. */
  send(message: object): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }
}
