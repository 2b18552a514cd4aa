// What is copied: LaTeX, Python, a scene file, a link.

/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);

/** What is to be copied; nothing; or why there is nothing. @param {string} kind @param {string} [text] @param {string} [error] */
export function copied(kind, text, error = "") {
  at("copied").value = text ?? "";
  at("copied").hidden = !text;
  at("said").textContent = error;
  if (!text) return;
  at("copied").rows = Math.min(text.split("\n").length, 14);
  at("copied").scrollIntoView({ block: "nearest" });
  const done = `${document.querySelector(`[data-copy=${kind}]`)?.textContent}: copied`;
  navigator.clipboard?.writeText(text).then(() => { if (at("copied").value === text) at("said").textContent = done; }, () => {});
}
