// What a path is that was given to a command which is not for it.
#pragma once

#include <filesystem>
#include <string_view>

namespace sbeh::studies {

/// For a command that found nothing of use in a path: throws InputError where the path is a mesh, a profile, an input, a
/// folder of results or a table out of one, and `command`, as in "mesh file" or "picture scan", is not for that; the
/// error says what it is, and which commands are.
void refuse_other_kind(const std::filesystem::path& path, std::string_view command);

}  // namespace sbeh::studies
