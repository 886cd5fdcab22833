// The letters: VTK's own font has no Greek and no subscripts, so a system font is taken if there is one.
#include "tools/picture/canvas/canvas.h"

#include <vtkTextProperty.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

// The first DejaVu Sans in the folders where systems keep their fonts; empty if there is none.
std::string find_font() {
  const char* home = std::getenv("HOME");
  const std::string user = home ? home : "";
  for (const fs::path& folder :
       {fs::path("/usr/share/fonts"), fs::path("/usr/local/share/fonts"),
        fs::path(user + "/.local/share/fonts"), fs::path(user + "/.fonts")}) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      if (entry->path().filename() == "DejaVuSans.ttf") return entry->path().string();
    }
  }
  return {};
}

}  // namespace

const std::string& font_file() {
  static const std::string file = find_font();
  return file;
}

void set_font(vtkTextProperty* property, double size) {
  property->SetFontSize(int(std::lround(size)));
  property->SetBold(false);
  property->SetItalic(false);
  property->SetShadow(false);
  if (font_file().empty()) {
    property->SetFontFamilyToArial();
  } else {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(font_file().c_str());
  }
}

std::string displayable(const std::string& text) {
  if (!font_file().empty()) {  // VTK takes "|" for a table in its language of formulas
    std::string shown;
    for (const char letter : text) shown += letter == '|' ? "∣" : std::string(1, letter);
    return shown;
  }
  static constexpr std::array<std::pair<const char*, const char*>, 14> spelled{{{"β", "beta"},
                                                                                {"π", "pi"},
                                                                                {"ᵣ", "r"},
                                                                                {"−", "-"},
                                                                                {"⁻", "^-"},
                                                                                {"…", "..."},
                                                                                {"⁰", "^0"},
                                                                                {"⁴", "^4"},
                                                                                {"⁵", "^5"},
                                                                                {"⁶", "^6"},
                                                                                {"⁷", "^7"},
                                                                                {"⁸", "^8"},
                                                                                {"⁹", "^9"},
                                                                                {"×", "x"}}};
  std::string result = text;
  for (const auto& [letter, plain] : spelled) {
    for (std::size_t at; (at = result.find(letter)) != std::string::npos;)
      result.replace(at, std::string(letter).size(), plain);
  }
  return result;
}

}  // namespace sbeh::picture
