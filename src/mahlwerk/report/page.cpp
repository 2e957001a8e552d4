// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/page.hpp"

#include <fmt/format.h>

#include "mahlwerk/report/plot/picture_json.hpp"
#include "mahlwerk/report/scripts.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::string_view style = R"css(
:root{--ink:#1d2329;--soft:#59636e;--grid:#e3e6ea;--paper:#fff;--box:#f5f7f9;--edge:#d5dae0;--warn:#9a3412;--warnbox:#fff4ed;color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--ink:#e4e8ec;--soft:#a3adb8;--grid:#30363d;--paper:#14181c;--box:#1d2329;--edge:#39424b;--warn:#fdba74;--warnbox:#33200f}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
main{max-width:60rem;margin:0 auto;padding:2.2rem 1.4rem 3rem}
h1{font-size:1.75rem;line-height:1.2;margin:0 0 .5rem;text-wrap:balance}
h2{font-size:1.15rem;margin:2.2rem 0 .7rem}
.lead{font-size:1.08rem;margin:0 0 1.4rem;max-width:48rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums;font-size:.93rem}
.wide{overflow-x:auto}
th,td{padding:.38rem .7rem;border-bottom:1px solid var(--edge);text-align:left;vertical-align:baseline}
th{font-weight:600}thead th{color:var(--soft);font-size:.85rem;border-bottom:2px solid var(--edge)}
td.n,th.n{text-align:right}td.n{white-space:nowrap}
tbody th{font-weight:400}tbody th.group{font-weight:600;padding-top:1.1rem}tbody th small{display:block;color:var(--soft);font-size:.8rem;line-height:1.35}
.box{background:var(--box);border:1px solid var(--edge);border-radius:6px;padding:.9rem 1.1rem;margin:1.2rem 0}
.box h2{margin:0 0 .4rem}.box p{margin:.3rem 0}.box table td,.box table th{padding:.25rem .7rem .25rem 0}
.box tr:last-child td{border-bottom:0}
.warn{border-color:var(--warn);background:var(--warnbox);color:var(--warn)}
figure{margin:1.6rem 0;break-inside:avoid}figure>svg{max-width:100%;height:auto}
.panels{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(25rem,100%),1fr));gap:.4rem 1.6rem}.panels figure{margin:.8rem 0;min-width:0}
.laws{font-size:.82rem;margin:.3rem 0}.laws td,.laws th{padding:.2rem .5rem .2rem 0}.laws .best td{font-weight:600}figcaption p{margin:.2rem 0}figcaption summary{font-weight:400}
#points{font-size:.84rem}#points td,#points th{padding:.3rem .5rem}#points th{cursor:pointer}#points th[aria-sort=ascending]::after{content:" ↑"}#points th[aria-sort=descending]::after{content:" ↓"}td.failed{color:var(--warn)}
figcaption,footer{color:var(--soft);font-size:.86rem}figcaption{margin-top:.35rem;max-width:48rem}
pre{overflow-x:auto;background:var(--box);border:1px solid var(--edge);border-radius:6px;padding:.9rem;font:.82rem/1.45 ui-monospace,Menlo,Consolas,monospace}
code{font:.88em ui-monospace,Menlo,Consolas,monospace}
summary{cursor:pointer;font-weight:600}a{color:inherit}
footer{margin-top:2.5rem;border-top:1px solid var(--edge);padding-top:.8rem}
@media (max-width:36rem){.stacked thead{display:none}.stacked tr{display:block;border-bottom:1px solid var(--edge);padding:.3rem 0}.stacked th,.stacked td{display:flex;justify-content:space-between;gap:1rem;border:0;padding:.15rem 0}.stacked td:empty{display:none}.stacked td::before{content:attr(data-head);color:var(--soft)}
 .quantities tr{display:grid;grid-template-columns:1fr 1fr;border-bottom:1px solid var(--edge)}.quantities th,.quantities td{border:0}.quantities tbody th,.quantities thead th:first-child{grid-column:1/-1}.quantities thead th:first-child{display:none}.quantities th{padding-bottom:.1rem}.quantities td{padding-top:.1rem}.quantities td.n{white-space:normal}}
@media print{:root{--ink:#000;--soft:#444;--grid:#ddd;--paper:#fff;--box:#fff;--edge:#bbb}
 .panels{grid-template-columns:1fr 1fr}.wide{overflow:visible}#points{font-size:7pt}#points td,#points th{padding:.15rem .25rem}
 body{font-size:10.5pt}main{max-width:none;padding:0}tr{break-inside:avoid}h2{break-after:avoid}}
)css";

/// Instead of the pictures, where scripts do not run.
constexpr std::string_view without_scripts =
    "<noscript><section class=\"box\"><p>The pictures of this page are drawn by its script, which "
    "does not run here. Open the file in a browser; the tables beside it hold the "
    "numbers.</p></section></noscript>\n";

/// Replaces what stands between `begin` and `end`, searched from `from` on. Returns whether it did.
bool replace_between(std::string& text, std::size_t from, std::string_view begin,
                     std::string_view end, std::string_view by) {
  const std::size_t at = text.find(begin, from);
  if (at == std::string::npos) return false;
  const std::size_t start = at + begin.size(), stop = text.find(end, start);
  if (stop == std::string::npos) return false;
  text.replace(start, stop - start, by);
  return true;
}

std::string figure_of(const std::string& json, std::string_view caption) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", drawing(json),
                     escaped(caption));
}

}  // namespace

std::string page(std::string_view title, std::string_view body, std::string_view footer) {
  const bool pictures = body.find("class=\"picture\"") != std::string_view::npos;
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n{2}{3}"
      "<footer>{4}</footer>\n</main>\n{5}</body>\n</html>\n",
      escaped(title), style, pictures ? without_scripts : "", body, footer,
      pictures ? fmt::format("<script>{}</script>\n", plots_script()) : "");
}

std::optional<std::string> renewed_page(std::string_view old) {
  std::string made(old);
  if (!old.starts_with("<!doctype html>") ||
      old.find("<footer>Mahlwerk ") == std::string_view::npos)
    return std::nullopt;
  if (!replace_between(made, 0, "<style>", "</style>", style)) return std::nullopt;
  if (const std::size_t film = made.find("id=\"replay-data\""); film != std::string::npos)
    replace_between(made, film, "<script>", "</script>", replay_script());
  const std::size_t foot = made.find("</main>", made.rfind("<footer>Mahlwerk "));
  if (foot != std::string::npos)
    replace_between(made, foot, "<script>", "</script>", plots_script());
  return made;
}

std::string note_box(const std::string& words, bool warns) {
  return fmt::format("<section class=\"box{}\"><p>{}</p></section>\n", warns ? " warn" : "", words);
}

std::string figure(const Plot& plot, std::string_view caption) {
  return figure_of(picture_json(plot), caption);
}

std::string figure(const std::optional<ColourMap>& map, std::string_view caption) {
  return map ? figure_of(picture_json(*map), caption) : "";
}

}  // namespace mahlwerk::report
