// Messages and questions of the page. The browser's own ones stop the page, and tests and styles cannot reach them.
import { by, element } from "./elements";

/** Shows a line below the header until it is closed or replaced. `actions`: buttons, which close it as well. */
export function notice(words: string, actions: Record<string, () => void> = {}): void {
  by("notice").hidden = !words;
  by("notice-words").textContent = words;
  by("notice-actions").replaceChildren(...Object.entries(actions).map(([label, act]) => {
    const button = element("button", {}, label);
    button.onclick = () => { notice(""); act(); };
    return button;
  }));
}

let before: Promise<unknown> = Promise.resolve(); // the question that is open: the next one waits for its answer

function shown<T>(words: string, answers: string[], start: string | null,
    taken: (answer: number, text: string) => T): Promise<T> {
  const dialog = by<HTMLDialogElement>("question"), text = by<HTMLInputElement>("question-text");
  const asked = before.then(() => new Promise<T>((resolve) => {
    let chosen = answers.length - 1;
    by("question-words").textContent = words;
    text.hidden = start === null;
    text.value = start ?? "";
    const buttons = answers.map((label, i) => {
      const button = element("button", {}, label);
      button.onclick = () => { chosen = i; dialog.close(); };
      return button;
    });
    by("question-answers").replaceChildren(...buttons);
    text.onkeydown = (event) => { if (event.key === "Enter") { event.preventDefault(); buttons[0].click(); } };
    dialog.onclose = () => resolve(taken(chosen, text.value));
    dialog.showModal();
    if (start === null) buttons[buttons.length - 1].focus(); // the answer that loses nothing
    else text.select();
  }));
  before = asked;
  return asked;
}

/** Asks a question. Returns the index of the answer. Escape is the last one, which must lose nothing. */
export function question(words: string, ...answers: string[]): Promise<number> {
  return shown(words, answers, null, (answer) => answer);
}

/** Asks for a text. Returns null where it was cancelled. */
export function questionOfText(words: string, start: string, answer: string): Promise<string | null> {
  return shown(words, [answer, "Cancel"], start, (chosen, text) => (chosen === 0 ? text : null));
}

/** Shows a message that must be read before anything else is done. */
export async function message(words: string): Promise<void> { await question(words, "OK"); }

/** Returns the two answers to a conflict between this page's version of a document and its file. */
export function versions(mine: () => void, theirs: () => void): HTMLElement[] {
  return [["Keep mine", mine] as const, ["Take theirs", theirs] as const].map(([words, act]) => {
    const button = element("button", {}, words);
    button.onclick = act;
    return button;
  });
}
