// actions.js -- what can be done, each with its key, in menus and from the keyboard.
// @ts-check

/** @typedef {{ menu: string, name: string, key: string, act: () => unknown }} Action */

/** "Ctrl+Shift+Z" of an event. */
export function keyOf(/** @type {KeyboardEvent} */ event) {
  const held = (event.ctrlKey || event.metaKey ? "Ctrl+" : "") + (event.altKey ? "Alt+" : "") + (event.shiftKey && event.key.length > 1 || event.shiftKey && event.ctrlKey ? "Shift+" : "");
  return held + (event.key.length === 1 ? event.key.toUpperCase() : event.key);
}

export class Actions {
  /** @param {Action[]} list */
  constructor(list) {
    this.list = list;
    window.addEventListener("keydown", (event) => this.hear(event));
  }

  hear(/** @type {KeyboardEvent} */ event) {
    const { target } = event;
    const isTyping = target instanceof HTMLInputElement && target.type !== "checkbox" || target instanceof HTMLSelectElement;
    if (isTyping && !(event.ctrlKey || event.metaKey)) return;
    const action = this.list.find(({ key }) => key === keyOf(event));
    if (action === undefined) return;
    event.preventDefault();
    action.act();
  }

  /** Menus as <details>, which work by keyboard. */
  showMenus(/** @type {HTMLElement} */ place) {
    for (const menu of new Set(this.list.map((action) => action.menu))) {
      const details = document.createElement("details"), summary = document.createElement("summary"), body = document.createElement("div");
      details.className = "menu";
      summary.textContent = menu;
      for (const action of this.list.filter((one) => one.menu === menu)) {
        const button = document.createElement("button"), key = document.createElement("kbd");
        button.type = "button";
        button.textContent = action.name;
        key.textContent = action.key.replace("Arrow", "");
        button.append(key);
        button.addEventListener("click", () => {
          details.open = false;
          action.act();
        });
        body.append(button);
      }
      details.append(summary, body);
      place.append(details);
    }
    document.addEventListener("click", (event) => place.querySelectorAll("details[open]").forEach((details) => {
      if (!details.contains(/** @type {Node} */ (event.target))) /** @type {HTMLDetailsElement} */ (details).open = false;
    }));
  }

  showKeys(/** @type {HTMLElement} */ table) {
    table.replaceChildren(...this.list.filter(({ key }) => key !== "").map(({ name, key }) => {
      const row = document.createElement("tr");
      [name, key].forEach((text) => row.insertCell().append(text));
      return row;
    }));
  }
}

/** Hands a file to the person. */
export function download(/** @type {string} */ name, /** @type {BlobPart} */ content, /** @type {string} */ type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
