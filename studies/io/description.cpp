#include "studies/io/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace sbeh::studies {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

using Entries = std::vector<std::pair<std::string, std::string>>;

// Key and value of each line that is not a comment; a list may go on in lines that are set in.
Entries entries_of(const std::string& description) {
  std::istringstream text(description);
  Entries entries;
  std::string section;
  for (std::string line; std::getline(text, line);) {
    const std::size_t sign = line.find(" = ");
    if (line.starts_with('[') && line.ends_with(']'))
      section = line.substr(1, line.size() - 2) + ".";
    else if (line.starts_with("  ") && !entries.empty())
      entries.back().second += line.substr(1);
    else if (sign != std::string::npos && !line.starts_with('#'))
      entries.emplace_back(section + line.substr(0, sign), line.substr(sign + 3));
  }
  return entries;
}

const std::string* value_of(const Entries& entries, const std::string& key) {
  for (const auto& [name, value] : entries)
    if (name == key) return &value;
  return nullptr;
}

std::string shown(const std::string* value) {
  constexpr std::size_t most = 60;
  if (!value) return "nothing";
  return value->size() <= most ? *value : value->substr(0, most) + " …";
}

// The table that tells the kind of a description: its first one.
std::string kind_of(const std::string& description) {
  const std::size_t at = description.find("\n[");
  return at == std::string::npos ? "" : first_line(description.substr(at + 1));
}

}  // namespace

std::string text_of(const std::vector<Difference>& differences) {
  std::string text;
  for (const auto& [name, there, here] : differences)
    text += fmt::format("{}{}: {} there, {} here", text.empty() ? "" : "; ", name, there, here);
  return text;
}

std::string with_remarks(const std::string& description, const std::vector<std::string>& remarks) {
  const std::size_t rest = description.find('\n') + 1;
  std::string text = description.substr(0, rest);
  for (const std::string& remark : remarks) text += "# " + remark + "\n";
  return text + description.substr(rest);
}

std::vector<std::string> remarks_in(const std::string& description) {
  std::istringstream text(description);
  std::vector<std::string> remarks;
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line) && line.starts_with("# ")) remarks.push_back(line.substr(2));
  return remarks;
}

std::vector<Difference> differences(const std::string& before, const std::string& after,
                                    const std::vector<std::string_view>& without) {
  const Entries there = entries_of(before), here = entries_of(after);
  std::vector<Difference> found;
  const auto add = [&](const std::string& key) {
    const std::string *first = value_of(there, key), *second = value_of(here, key);
    const bool same = first && second && *first == *second;
    if (!same && !key.starts_with("units.") && std::ranges::find(without, key) == without.end())
      found.push_back({key, shown(first), shown(second)});
  };
  for (const auto& [key, value] : here) add(key);
  for (const auto& [key, value] : there)
    if (!value_of(here, key)) add(key);
  return found;
}

std::string mismatch(const std::string& before, const std::string& after, std::string_view what,
                     const std::vector<std::string_view>& without) {
  if (kind_of(before) != kind_of(after))
    return fmt::format("holds other results than {} (see its run.toml)", what);
  if (const auto changes = differences(before, after, without); !changes.empty())
    return fmt::format("holds {} with other parameters: {}", what, text_of(changes));
  if (first_line(before) != first_line(after))
    return fmt::format("holds {} of another version of sbeh (see the first line of its run.toml)",
                       what);
  return {};
}

}  // namespace sbeh::studies
