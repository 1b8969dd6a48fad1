// SPDX-License-Identifier: Apache-2.0
// Asks the search of the site: node tests/structure/site_search.js FOLDER
"use strict";
const fs = require("fs");
const path = require("path");

const folder = process.argv[2];
const { find, excerpt } = require(path.resolve(folder, "search.js"));
const text = fs.readFileSync(path.join(folder, "search_index.js"), "utf8");
const index = JSON.parse(text.slice("const searchIndex = ".length, -2));

// What is asked, and the address of the first hit.
const first = [
  ["lost motion", "docs/guide/glossary.html#term-lost-motion"],
  ["FR-9", "docs/theory/FR.html#FR-9"],
  ["fr-9", "docs/theory/FR.html#FR-9"],
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
  ["install", "index.html#install"],
  ["notebooks", "examples/notebooks/index.html"],
  ["verification", "verification.html"],
  ["completion", "commands/completion.html"],
  ["strainwave merge", "commands/merge.html"],
  ["fe tabulate", "commands/fe_tabulate.html"],
  ["strainwave fe", "commands/fe.html"],
  ["StiffnessResult", "python_results.html#StiffnessResult"],
  ["Solution", "python.html#Solution"],
  ["pickle", "docs/guide/python.html#change-a-drive"],  // only in the middle of a section
  ["aluminium", "docs/theory/references.html"],
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
if (find(index, "--mesh").length === 0) {
  console.log("--mesh has no hits");
  ++faults;
}
for (const word of ["pickle", "aluminium"]) {
  const [hit] = find(index, word);
  if (!excerpt(hit.t, word).toLowerCase().includes(word)) {
    console.log(`${word}: the line of the hit does not show the word`);
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
