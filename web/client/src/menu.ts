// Menus of actions: a button that opens a list. Arrows, Home, End and letters move in it, Escape closes it.
import { element } from "./elements";

export interface Action { words: string; keys?: string; act: () => void }

/** Makes a button open a menu. `actions`: called each time that it opens. */
export function menu(button: HTMLElement, actions: () => Action[]): void {
  button.setAttribute("aria-haspopup", "menu");
  button.setAttribute("aria-expanded", "false");
  let list: HTMLElement | null = null;

  const close = (back: boolean): void => {
    list?.remove();
    list = null;
    button.setAttribute("aria-expanded", "false");
    document.removeEventListener("pointerdown", away, true);
    removeEventListener("resize", away);
    if (back) button.focus();
  };
  const away = (event: Event): void => {
    const target = event.target as Node;
    if (event.type === "resize" || !(list?.contains(target) || button.contains(target))) close(false);
  };

  const open = (): void => {
    const items = actions().map(({ words, keys, act }) => {
      const item = element("button", { tabIndex: -1 }, element("span", {}, words),
        ...(keys ? [element("small", {}, keys)] : []));
      item.setAttribute("role", "menuitem");
      item.onclick = () => { close(true); act(); };
      return item;
    });
    const made = list = element("div", { className: "menu-list" }, ...items);
    made.setAttribute("role", "menu");
    made.setAttribute("aria-label", button.getAttribute("aria-label") ?? button.textContent ?? "");
    made.onkeydown = (event) => {
      const at = items.indexOf(document.activeElement as HTMLButtonElement), count = items.length;
      const to: Record<string, number> = { ArrowDown: (at + 1) % count, ArrowUp: (at + count - 1) % count, Home: 0,
        End: count - 1 };
      if (event.key === "Escape" || event.key === "Tab") close(true);
      else if (event.key in to) items[to[event.key]].focus();
      else if (event.key.length === 1 && event.key !== " ") {
        const rest = [...items.slice(at + 1), ...items.slice(0, at + 1)];
        rest.find((each) => each.textContent.toLowerCase().startsWith(event.key.toLowerCase()))?.focus();
      } else return;
      event.preventDefault();
      event.stopPropagation();
    };
    (button.closest("dialog") ?? document.body).append(made); // what is outside of a modal dialog cannot be used
    const box = button.getBoundingClientRect();
    made.style.left = `${Math.max(4, Math.min(box.left, innerWidth - made.offsetWidth - 4))}px`;
    const below = box.bottom + 4;
    made.style.top = `${Math.max(4, Math.min(below, innerHeight - made.offsetHeight - 4))}px`;
    button.setAttribute("aria-expanded", "true");
    document.addEventListener("pointerdown", away, true);
    addEventListener("resize", away);
    items[0]?.focus();
  };
  button.onclick = () => (list ? close(true) : open());
  button.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowDown" || list) return;
    event.preventDefault();
    event.stopPropagation();
    open();
  });
}
