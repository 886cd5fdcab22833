#include "studies/report/html.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace sbeh::studies::html {

namespace {

// Colours of both themes; widths for reading; wide tables scroll by themselves.
constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #1c2024; --soft: #5b6570; --paper: #ffffff;
  --line: #d9dee3; --shade: #f4f6f8; --c0: #00549f; --c1: #c4560a; --c2: #007a5a; --c3: #8a3ffc; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e7eb; --soft: #9aa5b1; --paper: #14171a;
  --line: #353c43; --shade: #1e2328; --c0: #6cb2f5; --c1: #f29a55; --c2: #4fc9a2; --c3: #be95ff; } }
body { margin: 0 auto; padding: 2rem 1.2rem 4rem; max-width: 68rem; color: var(--ink);
  background: var(--paper); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .2rem; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .8rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.6rem 0 .4rem; }
p { margin: .5rem 0; } p.note, figcaption { color: var(--soft); font-size: .9rem; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: .6rem;
  margin: 0; }
dl div { background: var(--shade); border-radius: .4rem; padding: .5rem .8rem; }
dt { color: var(--soft); font-size: .85rem; } dd { margin: 0; font-variant-numeric: tabular-nums; }
figure { margin: 1.2rem 0; }
a { color: var(--c0); } ul.files { columns: 14rem; padding-left: 1.2rem; margin: 0; }
figure img { max-width: 100%; height: auto; background: #fff; border: 1px solid var(--line);
  border-radius: .4rem; box-sizing: border-box; padding: .4rem; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(29rem, 100%), 1fr));
  gap: 1rem; } .charts figure { margin: 0; } svg { width: 100%; height: auto; }
svg.key { width: 2em; height: .5em; }
.wide { overflow-x: auto; border: 1px solid var(--line); border-radius: .4rem; max-height: 34rem;
  content-visibility: auto; contain-intrinsic-size: auto 34rem; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; text-align: left; white-space: nowrap;
  border-bottom: 1px solid var(--line); } td.n, th.n { text-align: right; }
thead th { position: sticky; top: 0; background: var(--shade); }
pre { background: var(--shade); border-radius: .4rem; padding: .8rem 1rem; overflow-x: auto;
  font: .85rem/1.45 ui-monospace, monospace; } code { font-family: ui-monospace, monospace; }
.cut { display: none; background: #8a1c1c; color: #fff; padding: .6rem .9rem; border-radius: .4rem; }
@supports selector(:has(a)) { .cut { display: block; animation: arrive 0s 2s backwards; }
  body:has(#end-of-page) .cut { display: none; } }
@keyframes arrive { from { visibility: hidden; } }
@media print { .wide { max-height: none; } }
)";

// Whether all that stands in the column are numbers.
bool is_numeric(const CsvTable& table, std::size_t column) {
  bool any = false;
  double value = 0;
  for (const auto& row : table.rows) {
    if (row[column].empty()) continue;
    if (!parse_number(row[column], value)) return false;
    any = true;
  }
  return any;
}

std::vector<std::size_t> spread(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(size, count);
  for (std::size_t i = 0; i < n; ++i)
    chosen.push_back(n == 1 ? 0 : (i * (size - 1) + (n - 1) / 2) / (n - 1));
  return chosen;
}

// The rows that are shown, whole reduced volumes at a time, and what is said of them.
struct Shown {
  std::vector<std::size_t> rows;
  std::string remark;
};
Shown shown_rows(const CsvTable& table, std::size_t most) {
  Shown shown;
  const std::size_t all = table.rows.size();
  const auto column = table.find("reduced_volume");
  if (all <= most || !column || table.find("time")) {
    shown.rows = spread(all, most);
    if (all > most) shown.remark = fmt::format("{} of {} rows, evenly spread", most, all);
    return shown;
  }
  std::map<double, std::vector<std::size_t>> volumes;
  for (std::size_t row = 0; row < all; ++row)
    volumes[table.number(row, "reduced_volume")].push_back(row);
  std::vector<std::vector<std::size_t>> groups;
  std::size_t largest = 1;
  for (const auto& [volume, rows] : volumes) {
    groups.push_back(rows);
    largest = std::max(largest, rows.size());
  }
  const auto chosen = spread(groups.size(), most / largest);
  for (const std::size_t k : chosen)
    shown.rows.insert(shown.rows.end(), groups[k].begin(), groups[k].end());
  std::ranges::sort(shown.rows);
  shown.remark = chosen.empty()
                   ? fmt::format("{} rows, too many to show those of one reduced volume", all)
                   : fmt::format("{} of {} rows: those of {} of {} reduced volumes, evenly spread",
                                 shown.rows.size(), all, chosen.size(), groups.size());
  return shown;
}

}  // namespace

std::string escaped(std::string_view text) {
  static const std::map<char, const char*> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string result;
  for (const char c : text)
    if (const auto entity = entities.find(c); entity != entities.end())
      result += entity->second;
    else if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
      result += "&#xfffd;";
    else
      result += c;
  return result;
}

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                             reinterpret_cast<unsigned char*>(text.data()));
  return text;
}

std::string value(std::string_view text) {
  double number = 0;
  if (!parse_number(text, number) || !std::isfinite(number)) return escaped(text);
  return fmt::format("<data value=\"{}\">{:.9g}</data>", escaped(text), number);
}

std::string element(std::string_view name, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>\n", name, escaped(text));
}

std::string facts(const std::vector<Fact>& facts) {
  std::string text = "<dl>\n";
  for (const Fact& fact : facts)
    text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(fact.name), fact.value);
  return text + "</dl>\n";
}

std::string table(const CsvTable& table, std::size_t most, std::string_view file) {
  const Shown shown = shown_rows(table, most);
  std::string remark =
      shown.remark.empty()
          ? ""
          : fmt::format("<p class=\"note\">{}; all are in {}.</p>\n", shown.remark, link(file));
  if (shown.rows.empty()) return remark;
  std::string text = "<div class=\"wide\"><table>\n<thead><tr>";
  std::vector<const char*> classes;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    classes.push_back(is_numeric(table, k) ? " class=\"n\"" : "");
    text += fmt::format("<th{}>{}</th>", classes[k], escaped(table.columns[k]));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const std::size_t row : shown.rows) {
    text += "<tr>";
    for (std::size_t k = 0; k < classes.size(); ++k)
      text += fmt::format("<td{}>{}</td>", classes[k], value(table.rows[row][k]));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + remark;
}

std::string link(std::string_view file) {
  std::string address;
  for (const char c : file) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c))
                    || std::string_view("-._/~").find(c) != std::string_view::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return fmt::format("<a href=\"{}\">{}</a>", address, escaped(file));
}

std::string figure(const std::filesystem::path& picture, std::string_view caption) {
  const char* type = picture.extension() == ".svg" ? "image/svg+xml" : "image/png";
  return fmt::format(
      "<figure><img alt=\"{0}\" "
      "src=\"data:{1};base64,{2}\"><figcaption>{0} ({3})</figcaption></figure>\n",
      escaped(caption), type, base64(read_file(picture)), link(picture.filename().string()));
}

std::string section(std::string_view title, std::string_view content) {
  return fmt::format("<section>\n{}{}</section>\n", element("h2", title), content);
}

std::string page(std::string_view title, std::string_view generator, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"generator\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<p class=\"cut\" role=\"alert\">This file ends before the page does: it was cut off. Copy "
      "it "
      "again, or make it again with <code>sbeh report</code>.</p>\n"
      "{}<div id=\"end-of-page\"></div>\n</body>\n</html>\n",
      escaped(generator), escaped(title), style, body);
}

}  // namespace sbeh::studies::html
