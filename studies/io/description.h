// A run.toml as text: the remarks at its head, and in what two of them differ.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// A value that is not the same in two places, as it stands in files.
struct Difference {
  std::string name, first, second;
};
/// "material.L1: 0.05 there, 0.08 here; model: …"
std::string text_of(const std::vector<Difference>& differences);

/// The text of a description with remarks, each a comment, below its first line, which names the version.
std::string with_remarks(const std::string& description, const std::vector<std::string>& remarks);

/// Its remarks.
std::vector<std::string> remarks_in(const std::string& description);

/// The values that are not the same, named as in "time.end", but for some names and for [units], on which no number depends.
std::vector<Difference> differences(const std::string& before, const std::string& after,
                                    const std::vector<std::string_view>& without = {});

/// Why what `before` describes is not gone on with as `after` says: "holds `what` with other parameters: …", or
/// of another version, or something else. Empty where it is.
std::string mismatch(const std::string& before, const std::string& after, std::string_view what,
                     const std::vector<std::string_view>& without = {});

}  // namespace sbeh::studies
