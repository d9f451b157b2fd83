#pragma once

namespace muelle::grader {

/// What the page of a class adds to page_style.h.
inline constexpr const char* classStyle = R"css(
.panel { padding: 1.1rem 1.25rem; margin-bottom: 1.5rem; }
.panel > h2 { margin-bottom: .6rem; }
.panel > .soft { margin-bottom: .6rem; }
.panel ul { list-style: none; padding: 0; margin: 0; }
.panel li { padding: .5rem 0; }
.panel li + li { border-top: 1px solid var(--line); }
.warning ul { list-style: none; padding: 0; }
.warning li { padding: .2rem 0; }
.warning a { text-decoration: underline; }

.histogram { display: block; width: 100%; height: auto; font: 13px system-ui, "Segoe UI", Roboto, "Noto Sans",
  "DejaVu Sans", sans-serif; }
.histogram text { fill: var(--ink); font-variant-numeric: tabular-nums; }
.histogram .x { text-anchor: middle; } .histogram .y { text-anchor: end; }
.histogram .label, .histogram .count, .histogram .y, .histogram .x { fill: var(--soft); }
.histogram .students { fill: var(--accent); }
.histogram .grid { stroke: var(--line); } .histogram .tic { stroke: var(--soft); }
.histogram .median { stroke: var(--ink); stroke-dasharray: 5 4; }
.histogram text.median { stroke: none; fill: var(--ink); font-weight: 600; }

.exercises li, .hardest li { display: grid; grid-template-columns: 1fr 10rem 6.5rem; gap: .1rem 1.25rem;
  align-items: center; }
.hardest li { grid-template-columns: 1fr 10rem 9rem; }
.exercises .soft, .hardest .soft { display: block; }
.mistakes li { display: grid; grid-template-columns: 3.5rem 1fr; gap: 1rem; align-items: baseline; }
.mistakes .points { font-size: 1.15rem; }
.exercises .bar .fill, .hardest .bar .fill { fill: var(--accent); }

.students-table { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .9375rem; }
th, td { padding: .3rem .6rem; text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap;
  border-top: 1px solid var(--line); }
thead th { border-top: 0; vertical-align: bottom; font-weight: 600; }
thead .topic { display: inline-block; writing-mode: vertical-rl; transform: rotate(180deg); text-align: left; }
thead .soft { display: block; font-weight: 400; }
th:first-child { text-align: left; font-weight: 400; white-space: normal; min-width: 11rem; }
thead th:first-child, th.sum { font-weight: 600; }
tbody a { color: var(--accent); }
td.passed { color: var(--good); background: var(--good-wash); }
td.failed { color: var(--bad); background: var(--bad-wash); }
td.missing { color: var(--soft); }
td.none { color: var(--part); background: var(--part-wash); }
td.sum { font-weight: 650; }

@media (max-width: 40rem) {
  .exercises li, .hardest li { grid-template-columns: 1fr auto; }
  .exercises .bar, .hardest .bar { display: none; }
}
@media print {
  .panel li, tr { break-inside: avoid; }
  thead { display: table-header-group; }
}
)css";

}  // namespace muelle::grader
