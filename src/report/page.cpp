// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "markup.hpp"
#include "strainwave/report/report.hpp"

namespace strainwave {
namespace {

// The style must not contain `<` or `&`, because the page is XML as well.  The rules of a plot
// apply only inside plots (`.plot .tick`).  The rules for dark screens also name `svg`, so they
// take precedence.
constexpr std::string_view kPageStyle = R"css(
:root {
  color-scheme: light dark;
  --page: #ffffff; --text: #1b1f24; --muted: #57606a; --rule: #d0d7de; --soft: #f6f8fa;
  --link: #0550ae; --good: #1a7f37; --care: #9a6700; --bad: #cf222e;
  --ink: #1b1f24; --paper: #ffffff; --part: #f1f4f7; --thin: #7d8791; --hatch: #6e7781;
  --crack: #d1242f; --bar: #4a7fb5;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #14181d; --text: #e6edf3; --muted: #9aa4af; --rule: #3a424c; --soft: #1d232a;
    --link: #79b8ff; --good: #56d364; --care: #e3b341; --bad: #ff7b72;
    --ink: #e6edf3; --paper: #14181d; --part: #27303a; --thin: #8b97a5; --hatch: #75808c;
    --crack: #ff6b63; --bar: #6ea3d8;
  }
  .plot svg .ground { fill: var(--page); }
  .plot svg text { fill: var(--text); }
  .plot svg .small { fill: var(--muted); }
  .plot svg .axis { stroke: var(--text); }
  .plot svg .grid { stroke: var(--rule); }
  .plot svg .minor { stroke: var(--soft); }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1.2rem; background: var(--page);
  color: var(--text); font: 15px/1.5 system-ui, 'DejaVu Sans', Arial, sans-serif;
  overflow-wrap: break-word; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .2rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; padding-top: .6rem;
  border-top: 1px solid var(--rule); }
h3 { font-size: 1rem; margin: 1.1rem 0 .3rem; }
p, ul, dl { margin: .4rem 0 .8rem; }
a { color: var(--link); }
code { font: .88em/1.4 ui-monospace, 'DejaVu Sans Mono', monospace; }
small { display: block; color: var(--muted); font-size: .85em; }
.subtitle, .remark, figcaption, caption { color: var(--muted); }
.remark { font-size: .9em; }
.absent { padding: .6rem .9rem; background: var(--soft); border-left: 3px solid var(--muted); }
nav ol { columns: 16rem; padding-left: 1.4rem; margin: .4rem 0; }
.verdict { border: 1px solid var(--rule); border-left: .45rem solid var(--good);
  background: var(--soft); padding: .8rem 1rem; margin: 1rem 0; }
.verdict.care { border-left-color: var(--care); }
.verdict.bad { border-left-color: var(--bad); }
.verdict p { margin: 0 0 .4rem; }
.word { font-weight: 700; font-size: 1.15rem; color: var(--good); }
.care .word { color: var(--care); }
.bad .word { color: var(--bad); }
.key { display: grid; grid-template-columns: repeat(auto-fit, minmax(11.5rem, 1fr));
  gap: .7rem 1.2rem; margin: .8rem 0 0; }
.key dt { color: var(--muted); font-size: .85em; }
.key dd { margin: 0; }
.key b { font-size: 1.2rem; font-variant-numeric: tabular-nums; }
figure { margin: 1rem 0; }
figcaption, caption { font-size: .88em; text-align: left; padding: .3rem 0; }
.scroll { overflow-x: auto; }
.scroll:focus-visible { outline: 2px solid var(--link); }
svg { display: block; max-width: 100%; height: auto; }
.paper svg, .bars svg { width: 100%; }
table { border-collapse: collapse; width: 100%; font-size: .9em; margin: .4rem 0 .8rem; }
caption { caption-side: top; font-weight: 600; }
th, td { padding: .28rem .6rem .28rem 0; border-bottom: 1px solid var(--rule); text-align: left;
  vertical-align: top; }
thead th { border-bottom: 2px solid var(--rule); font-weight: 600; }
tbody th { font-weight: 400; }
.group th { font-weight: 600; padding-top: .8rem; }
.sum th, .sum td { font-weight: 600; }
.change th { padding-left: 1rem; }
.change th, .change td { color: var(--muted); }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.inputs th, .inputs td:nth-child(2), .giver { white-space: nowrap; }
.inputs { min-width: 44rem; }
.inputs .group th { white-space: normal; }
.giver { font-size: .85em; padding: 0 .4em; border: 1px solid var(--rule); border-radius: 3px; }
.g1, .g7 { color: var(--link); border-color: currentColor; }
.g2, .g3, .g4, .g5 { color: var(--care); border-color: currentColor; }
.g5 { font-weight: 700; }
.g6 { color: var(--muted); }
.crack-number { display: inline-block; min-width: 1.5em; text-align: center; font-size: .85em;
  color: var(--crack); border: 1px solid var(--crack); border-radius: 1em; }
.breaks, .breaks td, .breaks th { color: var(--bad); }
.verdicts { list-style: none; padding-left: 0; }
.verdicts li { margin: .25rem 0; }
.notes { padding-left: 1.2rem; }
.notes li { margin: .25rem 0; }
.critical li::marker, .critical { color: var(--bad); }
.equations { columns: 17rem; padding-left: 0; list-style: none; }
.equations li { break-inside: avoid; padding-left: 3.9rem; text-indent: -3.9rem; }
.equations b { display: inline-block; width: 3.9rem; text-indent: 0; }
dl:not(.key) { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1.2rem; }
dl:not(.key) dd { margin: 0; overflow-wrap: anywhere; }
dl:not(.key) dt { color: var(--muted); }
pre { overflow-x: auto; background: var(--soft); padding: .8rem; font: .8em/1.45 ui-monospace,
  'DejaVu Sans Mono', monospace; }
summary { cursor: pointer; }
.chart text { font: 3.1px 'DejaVu Sans', Arial, sans-serif; fill: var(--ink); }
.chart .small { font-size: 2.7px; fill: var(--muted); }
.chart .middle { text-anchor: middle; }
.chart .end { text-anchor: end; }
.chart .bar { fill: var(--bar); }
.chart .bar.crack { fill: var(--crack); }
.chart .bar.low { fill: var(--care); }
.chart .zero { stroke: var(--ink); stroke-width: .25; }
.chart .reference { stroke: var(--crack); stroke-width: .4; stroke-dasharray: 2 1; }
@media screen and (max-width: 44rem) {
  body { padding: .8rem; }
  .plot svg { width: 100%; }
  .scroll table:not(.inputs) { min-width: 36rem; }
  dl:not(.key) { grid-template-columns: 1fr; }
  dl:not(.key) dd { margin-bottom: .4rem; }
}
@page { size: A4; margin: 16mm 15mm 16mm 15mm;
  @bottom-left { content: "strainwave report"; font: 8pt sans-serif; color: #57606a; }
  @bottom-right { content: counter(page) " / " counter(pages); font: 8pt sans-serif;
    color: #57606a; } }
@media print {
  body { max-width: none; padding: 0; font-size: 9.5pt; }
  h2 { margin-top: 1.2rem; }
  h2, h2 + p, h3, caption, thead { break-after: avoid; }
  h2 + p, figure, tr, li, .verdict, .key div { break-inside: avoid; }
  thead { display: table-header-group; }
  .scroll { overflow: visible; }
  .results, .results tbody { break-inside: avoid; }
  .group { break-after: avoid; }
  .inputs { min-width: 0; font-size: .74em; }
  .inputs th, .inputs td { padding-top: .08rem; padding-bottom: .08rem; }
  .inputs .group th { padding-top: .4rem; }
  .inputs td:nth-child(2), .number, thead th { white-space: normal; }
  th, td, code, dd { overflow-wrap: break-word; }
  table { font-size: .82em; }
  pre { white-space: pre-wrap; overflow-wrap: anywhere; overflow: visible; font-size: 6.8pt; line-height: 1.35; }
  .plot svg { width: 165mm; }
  a { color: inherit; text-decoration: none; }
}
)css";

}  // namespace

std::string report_html(const Report& whole) {
  using report::escaped;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{0}: strainwave report</title>\n<style>{1}</style>\n</head>\n<body>\n<header>\n"
      "<h1>{0}</h1>\n<p class=\"subtitle\">{2}</p>\n</header>\n<main>\n{3}",
      escaped(whole.title), kPageStyle, escaped(whole.subtitle), whole.verdict);
  html += "<nav aria-label=\"Contents\">\n<ol>\n";
  for (const ReportSection& section : whole.sections)
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, escaped(section.title));
  html += "</ol>\n</nav>\n";
  for (const ReportSection& section : whole.sections)
    html += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id,
                        escaped(section.title), section.html);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace strainwave
