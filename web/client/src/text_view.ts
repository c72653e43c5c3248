// The .frep text: an editor with completion, marked errors, and sliders for its parameters.
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, type CompletionContext,
  type CompletionResult } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyField, historyKeymap, indentWithTab, redo, undo } from "@codemirror/commands";
import { javascript } from "@codemirror/lang-javascript";
import { bracketMatching, HighlightStyle, indentOnInput, StreamLanguage,
  syntaxHighlighting } from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState, type Extension } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap,
  lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { by, element, slider } from "./elements";
import { type History, MOST } from "./history";
import { Histogram } from "./scan";
import { type Mistake, type Parameter, post } from "./server";

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--code-comment)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--code-string)" },
  { tag: tags.number, color: "var(--code-number)" },
  { tag: [tags.standard(tags.name), tags.function(tags.variableName)], color: "var(--code-function)" },
  { tag: [tags.keyword, tags.operator], color: "var(--code-operator)" },
  { tag: [tags.definition(tags.variableName), tags.propertyName], color: "var(--code-name)" },
]);

const words = new Set<string>();

export function knowWords(names: string[]): void { for (const name of names) words.add(name); }

const frep = StreamLanguage.define({
  token(stream) {
    if (stream.eatSpace()) return null;
    if (stream.match(/^(#|\/\/).*/)) return "comment";
    if (stream.match(/^"(\\.|[^"\\])*"?/)) return "string";
    if (stream.match(/^(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?/)) return "number";
    if (stream.match(/^[A-Za-z_]\w*/))
      return words.has(stream.current()) ? "variableName.function"
        : stream.match(/^\s*=(?!=)/, false) ? "variableName.definition" : null;
    stream.next();
    return "operator";
  },
  languageData: { commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", '"'] } },
});

async function complete(context: CompletionContext): Promise<CompletionResult | null> {
  if (!context.explicit && !context.matchBefore(/\w+/)) return null;
  try {
    const found = await post<{ from: number; to: number;
      entries: { kind: string; name: string; signature: string; meaning: string; insert: string }[] }>(
        "/api/words", { text: context.state.doc.toString(), offset: context.pos });
    const options = found.entries.map((each) => ({
      label: each.name, detail: each.signature.replace(each.name, ""), info: each.meaning || undefined, type: each.kind,
      apply: (view: EditorView, _: unknown, from: number, to: number) => {
        const at = from + (each.insert.endsWith("()") ? each.insert.length - 1 : each.insert.length);
        view.dispatch({ changes: { from, to, insert: each.insert }, selection: { anchor: at },
          userEvent: "input.complete" });
      },
    }));
    return { from: found.from, options, validFor: /^\w*$/ };
  } catch {
    return null;
  }
}

const nonce = document.querySelector<HTMLMetaElement>('meta[name="style-nonce"]')!.content;

/** Returns the extensions common to all editors of the page. */
function common(changed: (text: string, byHand: boolean) => void): Extension[] {
  return [
    EditorView.cspNonce.of(nonce), lineNumbers(), highlightActiveLineGutter(), highlightActiveLine(),
    history({ minDepth: 100_000 }), drawSelection(), indentOnInput(), bracketMatching(),
    closeBrackets(), highlightSelectionMatches(), syntaxHighlighting(colours), EditorView.lineWrapping,
    EditorState.tabSize.of(2),
    keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap,
      indentWithTab]),
    EditorView.updateListener.of((update) => {
      if (update.docChanged)
        changed(update.state.doc.toString(), !update.transactions.some((each) => each.isUserEvent("slider")));
    }),
    EditorView.contentAttributes.of({ "aria-label": "Text" }),
  ];
}

/** Marks errors of a text in its editor. */
function markIn(editor: EditorView, mistakes: Mistake[]): void {
  const end = editor.state.doc.length;
  editor.dispatch(setDiagnostics(editor.state, mistakes.map((each) => {
    const from = Math.min(each.offset, end);
    return { from, to: Math.min(end, from + Math.max(1, each.length)), severity: "error" as const,
      message: each.message };
  })));
}

/** Shows a mistake in its box: as a button, if there is a place to go to. */
export function showMistake(box: HTMLElement, words: string | null, go: (() => void) | null): void {
  box.hidden = words === null;
  if (words !== null && box.textContent === words && Boolean(go) === Boolean(box.querySelector("button"))) {
    if (go) box.querySelector("button")!.onclick = go;
    return; // the same: keeps the focus
  }
  const line = go ? element("button", { title: "Go there (F8)" }, words ?? "") : element("p", {}, words ?? "");
  if (go) line.onclick = go;
  box.replaceChildren(...(words === null ? [] : [line]));
}

/** The text that a sheet makes, which follows its changes. */
export class MadeText {
  private editor: EditorView | null = null;
  private mistakes: Mistake[] = [];

  constructor(private host: HTMLElement) {}

  get isShown(): boolean { return !this.host.hidden; }

  show(on: boolean, text: string): void {
    this.host.hidden = !on;
    this.editor?.destroy();
    this.editor = null;
    if (!on) return;
    this.editor = new EditorView({ parent: this.host, state: EditorState.create({ doc: text, extensions: [
      ...common(() => {}), frep, lintGutter(), EditorState.readOnly.of(true),
      EditorView.contentAttributes.of({ "aria-readonly": "true" })] }) });
    markIn(this.editor, this.mistakes);
  }

  follow(text: string): void {
    if (!this.editor || this.editor.state.doc.toString() === text) return;
    this.editor.dispatch({ changes: { from: 0, to: this.editor.state.doc.length, insert: text } });
  }

  mark(mistakes: Mistake[]): void {
    this.mistakes = mistakes;
    if (this.editor) markIn(this.editor, mistakes);
  }
}

export class TextView {
  private readOnly = new Compartment();
  private mistakes: Mistake[] = [];
  readonly editor: EditorView;
  private parameters: Parameter[] = [];
  private rows = "";
  private histogram = new Histogram();
  onChange: (text: string) => void = () => {};

  constructor() {
    this.editor = new EditorView({ parent: by("editor"), state: this.state("", false) });
    this.histogram.onLevel = (name, value) => this.set({ [name]: value });
  }

  private quiet = false;

  /** Whether the text can be changed. */
  allow(changes: boolean): void {
    this.editor.dispatch({ effects: this.readOnly.reconfigure(EditorState.readOnly.of(!changes)) });
  }

  private state(text: string, plain: boolean): EditorState {
    return EditorState.create({ doc: text, extensions: this.extensions(plain) });
  }

  private extensions(plain: boolean): Extension[] {
    return [
      ...common((now, byHand) => {
        if (byHand) this.parameters = [];
        if (!this.quiet) this.onChange(now);
      }),
      ...(plain ? [] : [frep, autocompletion({ override: [complete] })]), lintGutter(),
      this.readOnly.of(EditorState.readOnly.of(false)),
    ];
  }

  /** Shows another document. `kept`: its undo history; another text than the history's becomes a step of it. */
  open(text: string, language: string, kept: History | null = null): void {
    this.parameters = [];
    this.rows = "";
    by("sliders").replaceChildren();
    void this.histogram.follow("", []);
    const plain = language !== "frep";
    this.editor.setState((kept && this.stateOf(kept, plain)) ?? this.state(text, plain));
    const now = this.editor.state.doc;
    if (now.toString() === text) return;
    this.quiet = true;
    this.editor.dispatch({ changes: { from: 0, to: now.length, insert: text } });
    this.quiet = false;
  }

  private stateOf(kept: History, plain: boolean): EditorState | null {
    try {
      return EditorState.fromJSON(kept.past, { extensions: this.extensions(plain) }, { history: historyField });
    } catch {
      return null;  // of another version of the page
    }
  }

  /** Returns the undo history for storage, without its oldest steps where it is long. */
  history(): History {
    const past = this.editor.state.toJSON({ history: historyField });
    let size = JSON.stringify(past.history).length;
    while (size > MOST && past.history.done.length) {
      past.history.done.splice(0, Math.ceil(past.history.done.length / 2));
      size = JSON.stringify(past.history).length;
    }
    if (size > MOST) past.history.undone = [];
    return { now: past.doc, past };
  }

  /** The parameters of the text as it is now. */
  get known(): Parameter[] { return this.parameters; }

  undo(): void { undo(this.editor); }
  redo(): void { redo(this.editor); }

  /** Marks errors of the text in the editor. */
  mark(mistakes: Mistake[], message: string | null): void {
    this.mistakes = mistakes;
    markIn(this.editor, mistakes);
    const first = mistakes[0], others = mistakes.length > 1 ? ` (and ${mistakes.length - 1} more)` : "";
    showMistake(by("message"),
      first ? `Line ${first.line}, column ${first.column}: ${first.message}${others}` : message,
      first ? () => this.go(first) : null);
  }

  private go(mistake: Mistake): void {
    const anchor = Math.min(mistake.offset, this.editor.state.doc.length);
    this.editor.dispatch({ selection: { anchor }, scrollIntoView: true });
    this.editor.focus();
  }

  /** Goes to the mistake after the cursor, after the last one to the first. */
  nextMistake(): void {
    const at = this.editor.state.selection.main.head;
    const sorted = [...this.mistakes].sort((a, b) => a.offset - b.offset);
    const next = sorted.find((each) => each.offset > at) ?? sorted[0];
    if (next) this.go(next);
  }

  /** Shows sliders for the parameters of the text in the editor. */
  follow(parameters: Parameter[]): void {
    const text = this.editor.state.doc.toString();
    if (parameters.some((each) => Number(text.slice(each.offset, each.offset + each.length)) !== Math.abs(each.value) &&
        Number(text.slice(each.offset, each.offset + each.length)) !== each.value)) return;
    this.parameters = parameters;
    void this.histogram.follow(text, parameters);
    const rows = JSON.stringify(parameters.map(({ name, range, comment }) => [name, range, comment]));
    const sliding = by("sliders").contains(document.activeElement);
    if (rows === this.rows && sliding) return;
    this.rows = rows;
    by("sliders").replaceChildren(...parameters.map((each) => slider(
      each.name, each.value, each.range ?? [Math.min(0, 2 * each.value), Math.max(0, 2 * each.value) || 1],
      each.comment, (value) => this.set({ [each.name]: value }), () => {})));
  }

  /** Writes the values of parameters into the text. */
  set(values: Record<string, number>): void {
    const found = this.parameters.filter((each) => each.name in values).sort((a, b) => a.offset - b.offset);
    if (!found.length) return;
    const changes = found.map(({ name, offset, length }) =>
      ({ from: offset, to: offset + length, insert: String(values[name]) }));
    this.editor.dispatch({ changes, userEvent: "slider" });
    for (const each of found) {
      const longer = String(values[each.name]).length - each.length;
      each.length += longer;
      each.value = values[each.name];
      for (const other of this.parameters) if (other.offset > each.offset) other.offset += longer;
    }
  }
}

/** Returns a small editor for a node's JavaScript. */
export function codeEditor(parent: HTMLElement, text: string, changed: (text: string) => void): EditorView {
  return new EditorView({ parent,
    state: EditorState.create({ doc: text, extensions: [...common((now) => changed(now)), javascript()] }) });
}

export function markLine(editor: EditorView, line: number | null, message: string | null): void {
  const at = line !== null && line >= 1 && line <= editor.state.doc.lines ? editor.state.doc.line(line) : null;
  editor.dispatch(setDiagnostics(editor.state, message === null ? []
    : [{ from: at?.from ?? 0, to: at?.to ?? editor.state.doc.length, severity: "error", message }]));
}
