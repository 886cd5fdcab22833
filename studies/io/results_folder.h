// Results that are in a folder already: they are not overwritten.
#pragma once

#include "studies/io/output.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace sbeh::studies {

/// Throws OutputError, "<folder>: <what it holds>; choose another folder with -o".
[[noreturn]] void refuse(const OutputFolder& folder, std::string_view holds);

/// Refuses a folder in which one of these files tells of earlier results: "results" that "are" there, or
/// "a run" that "is".
void refuse_results(const OutputFolder& folder, std::initializer_list<const char*> files,
                    std::string_view what = "results", std::string_view are = "are");

/// For a study that is completed row by row: writes its description to run.toml, or finds the same there.
/// Refuses a folder that holds `what` with other parameters, or the table without run.toml.
void begin_or_continue(const OutputFolder& folder, const std::string& description,
                       std::string_view table, std::string_view what);

}  // namespace sbeh::studies
