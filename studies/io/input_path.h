// Files and folders that an input names.
#pragma once

#include <filesystem>
#include <string>

namespace sbeh::studies {

/// Where a path of an input leads: from the input's folder, if it is there, else as it stands, from the folder in
/// which the program was started.
std::string path_from(const std::filesystem::path& input, const std::string& path);

/// Throws InputError that says where it was looked for, unless there is something.
void require_there(const std::string& path);

}  // namespace sbeh::studies
