// SPDX-License-Identifier: Apache-2.0
// Asks the search of the site: node tests/structure/site_search.js FOLDER
"use strict";
const fs = require("fs");
const path = require("path");

const folder = process.argv[2];
const { find } = require(path.resolve(folder, "search.js"));
const text = fs.readFileSync(path.join(folder, "search_index.js"), "utf8");
const index = JSON.parse(text.slice("const searchIndex = ".length, -2));

// What is asked, and the address of the first hit.
const first = [
  ["lost motion", "docs/guide/glossary.html#term-lost-motion"],
  ["FR-9", "docs/theory/manual.html#FR-9"],
  ["fr-9", "docs/theory/manual.html#FR-9"],
  ["K_Ic", "docs/guide/glossary.html#term-fracture-toughness"],
  ["exit status", "exit_status.html"],
  ["exit code", "exit_status.html"],
  ["stiffness", "commands/stiffness.html"],
  ["sif eval", "commands/sif_eval.html"],
  ["crack.closed", "notes.html#crack.closed"],
  ["drive.ratio", "docs/guide/input_file.html#drive.ratio"],
  ["output_shaft.crack.depth", "docs/guide/input_file.html#output_shaft.crack.annular.depth"],
  ["17-4PH H900", "libraries.html#material-17-4PH-H900"],
  ["tube-through-inclined", "libraries.html#sif-tube-through-inclined"],
  ["Drive.batch", "python.html#Drive.batch"],
  ["  energy   release rate ", "docs/guide/glossary.html#term-energy-release-rate"],
];
let faults = 0;
for (const [query, want] of first) {
  const [hit] = find(index, query);
  if (hit === undefined || hit.u !== want) {
    console.log(`${query}: the first hit is ${hit === undefined ? "none" : hit.u}, not ${want}`);
    ++faults;
  }
}
for (const query of ["", "   ", "no such thing anywhere"]) {
  if (find(index, query).length !== 0) {
    console.log(`"${query}" has hits`);
    ++faults;
  }
}
process.exit(faults > 0 ? 1 : 0);
