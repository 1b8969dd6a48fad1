// SPDX-License-Identifier: Apache-2.0
// The search of the site: ranks the entries of search_index.js, and shows them below the field.
"use strict";

// Kinds in the order of their weight among equally good hits.
const kinds = ["page", "term", "equation", "command", "note", "field", "material", "solution", "exit status", "guide", "notebook",
  "theory", "verification", "python", "C", "C++", "option", "decision", "result"];

function score(entry, query, words) {
  let best = 0;
  for (const given of entry.n) {
    const name = given.toLowerCase();
    const own = given === entry.n[0] ? 1 : 0;  // its title counts more than its other names
    if (name === query) best = Math.max(best, 90 + 5 * own);
    else if (name.startsWith(query)) best = Math.max(best, 60 + 5 * own - Math.min(name.length - query.length, 40) / 4);
    else if (words.every((word) => name.includes(word))) best = Math.max(best, 40 + 5 * own - Math.min(name.length, 80) / 8);
  }
  if (best === 0) {
    entry.text ??= (entry.n.join(" ") + " " + entry.t).toLowerCase();
    // A text that has the words together counts more, and one where they begin early.
    if (words.every((word) => entry.text.includes(word))) {
      const place = entry.text.indexOf(query);
      best = place < 0 ? 10 : 20 - Math.min(place, 2000) / 250;
    }
  }
  return best === 0 ? 0 : best + (kinds.length - kinds.indexOf(entry.k)) / 10;
}

// The entries that fit a query, best first.
function find(index, query, most = 20) {
  const asked = query.trim().toLowerCase();
  const words = asked.split(/[\s.]+/).filter(Boolean);
  if (words.length === 0) return [];
  const hits = index.map((entry) => [score(entry, asked, words), entry]).filter(([points]) => points > 0)
    .sort((a, b) => b[0] - a[0] || a[1].n[0].length - b[1].n[0].length).slice(0, most).map(([, entry]) => entry);
  // A word that looks like an option may be none: --mesh asks for mesh.
  return hits.length === 0 && asked.startsWith("-") ? find(index, asked.replace(/^-+/, ""), most) : hits;
}

// The part of a text about the first word that was asked for.
function excerpt(text, query, most = 160) {
  const word = query.trim().toLowerCase().split(/\s+/)[0];
  const place = Math.max(0, text.toLowerCase().indexOf(word));
  const start = place < most / 2 ? 0 : text.lastIndexOf(" ", place - most / 3) + 1;
  return (start > 0 ? "… " : "") + text.slice(start, start + most) + (start + most < text.length ? " …" : "");
}

function attach(field, list) {
  let chosen = -1;
  const up = field.dataset.up;
  const choose = (place) => {
    chosen = Math.max(-1, Math.min(place, list.children.length - 1));
    [...list.children].forEach((item, at) => item.classList.toggle("chosen", at === chosen));
    if (chosen >= 0) list.children[chosen].scrollIntoView({ block: "nearest" });
  };
  const show = () => {
    const found = find(searchIndex, field.value);
    list.replaceChildren(...found.map((entry) => {
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = up + entry.u;
      link.textContent = entry.n[0];
      const about = document.createElement("small");
      about.textContent = ` ${entry.k}: ${excerpt(entry.t, field.value)}`;
      item.append(link, about);
      return item;
    }));
    list.hidden = found.length === 0;
    choose(-1);
  };
  field.addEventListener("input", show);
  field.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") choose(chosen + 1);
    else if (event.key === "ArrowUp") choose(chosen - 1);
    else if (event.key === "Escape") list.hidden = true;
    else if (event.key === "Enter" && list.children.length > 0) list.children[Math.max(chosen, 0)].querySelector("a").click();
    else return;
    event.preventDefault();
  });
}

if (typeof document !== "undefined") attach(document.getElementById("search"), document.getElementById("found"));
if (typeof module !== "undefined") module.exports = { find, excerpt };
