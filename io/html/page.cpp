// SPDX-License-Identifier: Apache-2.0
#include "io/html/page.h"

#include <fmt/format.h>

namespace twinray::html {
namespace {

/// A word that may go on in the next line behind its slashes and underscores.
std::string breakable(const std::string& word) {
  std::string html;
  for (const char c : escaped(word)) {
    html += c;
    if (c == '/' || c == '_') html += "<wbr>";
  }
  return html;
}

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "Segoe UI", Roboto, "Noto Sans", sans-serif; color: #1c1c1e;
  background: #fafaf8; max-width: 76rem; margin: 2.5rem auto; padding: 0 1.5rem; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; } h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; }
h3 { font-size: 1.02rem; margin: 1.8rem 0 .4rem; } p { max-width: 52rem; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .6rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; border-bottom: 1.5px solid #888; } td { border-bottom: 1px solid #e4e4df; }
th:first-child, td:first-child { text-align: left; } td small { color: #777; }
tr.base td { background: #f0f0ea; } .scroll { overflow-x: auto; }
.facts td { text-align: left; white-space: normal; overflow-wrap: anywhere; }
.facts td:first-child { color: #666; white-space: nowrap; }
figure { margin: .6rem 0; background: #fff; border: 1px solid #e4e4df; border-radius: 6px; padding: .7rem; }
figure.wide { max-width: 56rem; } figcaption { font-weight: 600; margin-bottom: .2rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(27rem, 100%), 1fr)); gap: .8rem; }
svg { width: 100%; height: auto; display: block; } svg text { font-size: 11.5px; fill: #333; }
.plots svg text { font-size: 12.5px; } line.grid { stroke: #e8e8e4; }
line.one { stroke: #333; stroke-dasharray: 4 3; }
.legend { margin: .2rem 0 .4rem; font-size: 13px; max-width: none; } .legend span { margin-right: 1.1rem;
  white-space: nowrap; } .legend i { display: inline-block; width: .75rem; height: .75rem; border-radius: 50%;
  margin-right: .35rem; vertical-align: -1px; } .bad { color: #b00020; font-weight: 600; }
code, pre { font: 12px/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { background: #f0f0ea; border-radius: 6px; padding: .7rem; overflow-x: auto; }
nav a { display: inline-block; margin: .1rem 1.1rem .1rem 0; } a { color: #0072b2; }
img { max-width: 100%; height: auto; }
.notes { border-left: 3px solid #d9d9d2; padding-left: 1rem; margin: .8rem 0 1.4rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(13.5rem, 100%), 1fr));
  gap: .8rem; align-items: start; margin: 0 0 .8rem; }
.pictures figure { margin: 0; } .pictures img { display: block; width: 100%; border-radius: 3px;
  background: #000; }
.pictures img + img { margin-top: .3rem; }
.pictures figcaption { margin: .4rem 0 .2rem; }
.command { display: block; text-align: left; white-space: normal; overflow-wrap: anywhere; }
.words span { display: inline-block; max-width: 100%; } td code.command { min-width: 26rem; }
.pictures code.command { background: #f4f4f0; border-radius: 4px; padding: .35rem .45rem; }
.measured { display: grid; grid-template-columns: 1fr auto; margin: .4rem 0 0; font-size: 13px;
  font-variant-numeric: tabular-nums; }
.measured dt { color: #666; } .measured dd { margin: 0; text-align: right; }
.missing { background: #fff6e0; border: 1px solid #ecd9a8; border-radius: 6px; padding: .5rem .8rem;
  max-width: 52rem; }
.slider figcaption { display: flex; justify-content: space-between; gap: 1rem; }
.pair { position: relative; --at: 50%; overflow: hidden; background: #000; }
.pair img, .plots img { display: block; width: 100%; } img.fine { image-rendering: pixelated; }
.pair img.left { position: absolute; inset: 0; height: 100%; clip-path: inset(0 calc(100% - var(--at)) 0 0); }
.pair i { position: absolute; top: 0; bottom: 0; left: calc(var(--at) - 1px); width: 2px; background: #fff;
  box-shadow: 0 0 3px #000; pointer-events: none; }
.pair input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0;
  appearance: none; cursor: ew-resize; } .pair input:focus-visible { opacity: 1; background: none;
  outline: 3px solid #0072b2; outline-offset: -3px; }
.pair input::-webkit-slider-thumb { appearance: none; width: 1px; height: 1px; }
.pair input::-moz-range-thumb { width: 1px; height: 1px; border: 0; }
img.scale { width: 100%; height: .8rem; }
.plots figure small { display: flex; justify-content: space-between; }
@media (max-width: 40rem) { body { margin: 1rem auto; padding: 0 .8rem; }
  .facts td:first-child { white-space: normal; } svg.curves text { font-size: 17px; }
  td code.command { white-space: nowrap; } td .words span { max-width: none; } }
@media print { figure { break-inside: avoid; } }
)";

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      escaped(title), style, body);
}

std::string facts(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string html = "<table class=\"facts\">\n";
  for (const auto& [name, value] : rows)
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(name), escaped(value));
  return html + "</table>\n";
}

std::string row(const std::vector<std::string>& cells, const std::string& kind) {
  std::string html = kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", kind);
  for (const std::string& cell : cells) html += fmt::format("<td>{}</td>", cell);
  return html + "</tr>\n";
}

std::string whole_words(const std::string& text) {
  std::string html = "<span class=\"words\"><span>";
  bool is_option = false;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(' ', begin);
    const std::string word = text.substr(begin, end - begin);
    const bool is_value = is_option && !word.starts_with('-');
    if (begin > 0) html += is_value ? " " : "</span> <span>";
    html += breakable(word);
    is_option = word.starts_with('-') || is_value;
  }
  return html + "</span></span>";
}

std::string table(const std::vector<std::string>& heads, const std::string& rows) {
  std::string html = "<div class=\"scroll\"><table>\n<tr>";
  for (const std::string& head : heads) html += fmt::format("<th>{}</th>", head);
  return html + "</tr>\n" + rows + "</table></div>\n";
}

}  // namespace twinray::html
