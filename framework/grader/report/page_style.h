#pragma once

namespace muelle::grader {

/// The page's style sheet: light and dark, screen and print, system fonts, no outside resource.
inline constexpr const char* pageStyle = R"css(
:root {
  --paper: #f6f7f9; --card: #ffffff; --ink: #1c2430; --soft: #5c6675; --line: #e2e6ec; --code: #f3f5f8;
  --accent: #2563a8; --good: #1c7f53; --part: #9a6700; --bad: #b3352b;
  --good-wash: #e4f4ec; --part-wash: #fdf3d9; --bad-wash: #fbe9e7; --track: #e2e6ec;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14181e; --card: #1c222b; --ink: #e4e8ee; --soft: #9aa5b4; --line: #2e3641; --code: #14191f;
    --accent: #7db3ea; --good: #5cc997; --part: #e0b04e; --bad: #f08a7e;
    --good-wash: #183229; --part-wash: #352c15; --bad-wash: #3a2220; --track: #333c48;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, "Segoe UI", Roboto,
  "Helvetica Neue", "Noto Sans", "DejaVu Sans", sans-serif; overflow-wrap: anywhere; }
main { max-width: 60rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1, h2, h3, p { margin: 0; }
h1 { font-size: 1.75rem; line-height: 1.25; letter-spacing: -.01em; }
h2 { font-size: 1.3rem; line-height: 1.3; }
h3 { font-size: 1rem; font-weight: 600; }
a { color: inherit; text-decoration: none; }
a:hover { color: var(--accent); text-decoration: underline; }
.soft { color: var(--soft); font-size: .875rem; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.bar { display: block; width: 100%; height: 8px; border-radius: 4px; }
.bar .track { fill: var(--track); }
.passed .bar .fill { fill: var(--good); } .part .bar .fill { fill: var(--accent); } .failed .bar .fill { fill: var(--bad); }
.points { font-variant-numeric: tabular-nums; white-space: nowrap; text-align: right; }
.points b { font-weight: 650; }

.total { display: grid; grid-template-columns: 1fr auto; gap: .25rem 2rem; align-items: end; margin-bottom: 1.5rem; }
.total .points { font-size: 1.1rem; color: var(--soft); }
.total .points b { font-size: 2.6rem; line-height: 1; color: var(--ink); letter-spacing: -.02em; }
.total .bar { grid-column: 1 / -1; margin-top: .75rem; height: 10px; }
.warning { border-left: 4px solid var(--part); background: var(--part-wash); padding: .75rem 1rem; border-radius: 6px;
  margin-bottom: 1.5rem; }

.overview { padding: .35rem 1.25rem; margin-bottom: 1.5rem; }
.overview a { display: grid; grid-template-columns: 1fr 12rem 6rem; gap: 1.25rem; align-items: center; padding: .5rem 0; }
.overview div + div { border-top: 1px solid var(--line); }
.overview ul { margin: 0 0 .5rem; font-size: .9rem; }

.exercise { margin-top: 2rem; overflow: hidden; }
.exercise > header { padding: 1.1rem 1.25rem; display: grid; grid-template-columns: 1fr auto; gap: .1rem 1.5rem;
  align-items: baseline; }
.exercise > header .points { font-size: 1.15rem; }
.exercise > header .bar { grid-column: 1 / -1; margin-top: .6rem; }
.block { border-top: 1px solid var(--line); padding: 1rem 1.25rem; display: grid; gap: .75rem; }

.criterion { border-top: 1px solid var(--line); padding: .7rem 1.25rem; display: grid;
  grid-template-columns: 1.6rem 1fr auto; gap: .1rem .75rem; align-items: baseline; }
.mark { display: inline-grid; place-items: center; width: 1.5rem; height: 1.5rem; border-radius: 50%; font-size: .85rem;
  font-weight: 700; line-height: 1; }
.passed .mark { color: var(--good); background: var(--good-wash); }
.failed .mark { color: var(--bad); background: var(--bad-wash); }
.part .mark { color: var(--part); background: var(--part-wash); }
.why { grid-column: 2 / -1; padding: .35rem 0 .5rem; display: grid; gap: .75rem; min-width: 0; }
.why > * { min-width: 0; }
.mistake { background: var(--part-wash); border-left: 4px solid var(--part); border-radius: 6px; padding: .7rem 1rem; }
.mistake .says { font-weight: 600; }
.label { font-size: .75rem; font-weight: 600; letter-spacing: .04em; color: var(--soft); }
.fault { background: var(--bad-wash); border-left: 4px solid var(--bad); border-radius: 6px; padding: .7rem 1rem; }
.mend { margin: 0; padding: 0; list-style: none; display: grid; gap: .75rem; }
.cause { color: var(--soft); font-size: .9rem; }
.cause::before { content: "Because: "; font-weight: 600; }
details.passed { border-top: 1px solid var(--line); }
details.passed > summary { padding: .7rem 1.25rem; color: var(--good); font-size: 1rem; }
.example { font: .875rem/1.5 ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.example::before { content: "For example: "; font-family: system-ui, sans-serif; font-weight: 600; color: var(--soft); }
.hint::before { content: "Hint: "; font-weight: 600; color: var(--accent); }
.test { display: grid; gap: .4rem; min-width: 0; }
.property::before { content: "Does not hold yet: "; color: var(--bad); font-weight: 600; }

pre { margin: 0; font: .8125rem/1.55 ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace;
  white-space: pre-wrap; background: var(--code); border: 1px solid var(--line); border-radius: 6px;
  padding: .6rem .8rem; overflow-wrap: anywhere; }
.values { background: var(--code); border: 1px solid var(--line); border-radius: 6px; padding: .6rem .8rem;
  font: .8125rem/1.55 ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.values .call { font-weight: 600; }
.values .what { color: var(--soft); }
.values > * + p { margin-top: .35rem; }
.values dl { margin: 0; display: grid; grid-template-columns: max-content 1fr; gap: 0 1rem; }
.values dt { color: var(--soft); } .values dd { margin: 0; white-space: pre-wrap; }
.values .got { color: var(--bad); font-weight: 600; } .values .wanted { color: var(--good); font-weight: 600; }
.values .rest { color: var(--soft); }
details summary { cursor: pointer; color: var(--soft); font-size: .875rem; }
details pre { margin-top: .4rem; max-height: 24rem; overflow: auto; }
.curves { display: grid; gap: 1.5rem; }
.curves img { display: block; width: 100%; max-width: 52rem; margin: 0 auto; background: #fff; border-radius: 6px; }
ul { margin: .3rem 0 0; padding-left: 1.2rem; }
footer { margin-top: 2rem; }
footer h2 { font-size: 1rem; }

@media (max-width: 40rem) {
  main { padding: 1.25rem .75rem 3rem; }
  .overview a { grid-template-columns: 1fr auto; } .overview .bar { display: none; }
}
@media print {
  :root { --paper: #fff; --card: #fff; --ink: #000; --soft: #444; --line: #ccc; --code: #fff; --accent: #1d4f87;
    --good: #146240; --part: #7a5200; --bad: #962b22; --good-wash: #fff; --part-wash: #fff; --bad-wash: #fff;
    --track: #ddd; }
  @page { margin: 14mm 13mm; }
  :root { font-size: 8.5pt; }
  body { font-size: 8.5pt; line-height: 1.35; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  main { max-width: none; padding: 0; }
  .card { border: 0; border-radius: 0; }
  .total .points b { font-size: 1.8rem; }
  .total, .overview { margin-bottom: .5rem; }
  .overview { padding: 0; } .overview a { padding: .15rem 0; }
  .exercise { margin-top: 1rem; border-top: 2px solid var(--line); }
  .exercise > header, .block { padding: .4rem 0; }
  .criterion { padding: .2rem 0; } .mark { width: 1.2rem; height: 1.2rem; }
  .block, .mend, .why, .curves { gap: .4rem; }
  .mistake, .fault, .values { padding: .2rem .6rem; }
  .curves { grid-template-columns: 1fr 1fr; align-items: start; }
  details:not([open]):not(.passed) { display: none; } /* of a closed fold only its title would be printed */
  .mistake, .fault, .curves img { break-inside: avoid; }
  .exercise > header, h3, .criterion > h3 { break-after: avoid; }
}
)css";

}  // namespace muelle::grader
