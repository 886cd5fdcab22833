// The one off-screen window in which every picture is composed, and its way to PNG and SVG.
// Positions and lengths are pixels from the lower left corner; what is drawn later lies on top.
#pragma once

#include "tools/picture/canvas/geometry.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class vtkContextItem;
class vtkImageData;
class vtkTextProperty;

namespace sbeh::picture {

struct Colour {
  unsigned char red = 0;
  unsigned char green = 0;
  unsigned char blue = 0;
};

inline constexpr Colour black{0, 0, 0};
inline constexpr Colour white{255, 255, 255};
inline constexpr Colour dark_grey{90, 90, 90};
inline constexpr Colour light_grey{222, 222, 222};
inline constexpr Colour red{214, 28, 28};

enum class Pattern { solid, dashed, dotted, dash_dotted };

struct LineStyle {
  Colour colour = black;
  double width = 1.5;
  Pattern pattern = Pattern::solid;
};

enum class Align { left, centre, right };

struct TextStyle {
  double size = 20.0;  ///< height of the letters' line
  Align align = Align::centre;
  Colour colour = black;
  bool upward = false;  ///< turned by 90°, reads from below
};

enum class Format { png, svg, pdf };
constexpr auto names(Format) { return std::array{"png", "svg", "pdf"}; }

/// How a picture is written.
struct Output {
  std::vector<Format> formats{Format::svg, Format::png};
  double width = 0.0;     ///< of the page in mm; 0: a pixel is a point
  bool must_fit = false;  ///< a size was asked for: what does not fit into it is refused
};

class Canvas {
 public:
  Canvas();
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Begins an empty picture. Widths of lines are given for the usual size of letters and multiplied by `unit`.
  void start(double width, double height, double unit = 1.0);
  double unit() const;

  void fill(const Rect& rect, Colour colour);
  void line(const Points& points, const LineStyle& style);
  /// Many separate lines at once, each between two successive points.
  void segments(const Points& ends, const LineStyle& style);
  /// `y` is the middle of the letters; with `upward`, (x, y) is the middle of the text.
  void text(double x, double y, const std::string& text, const TextStyle& style);
  double text_width(const std::string& text, double size) const;

  /// An item of VTK's own, for example a chart.
  void add(vtkContextItem* item);

  /// An image with its lower left corner at (x, y), pixel by pixel; in the SVG it is embedded as PNG and lies
  /// below everything that is drawn.
  void image(vtkImageData* image, double x, double y);

  /// Writes `stem`.png and so on, each under a temporary name first; throws std::runtime_error, and InputError where
  /// a text is cut off at an edge of a size that was asked for.
  void write(const std::filesystem::path& stem, const Output& output);

 private:
  struct Window;
  std::unique_ptr<Window> window_;
};

/// Sets the letters of any text that VTK draws, axes included.
void set_font(vtkTextProperty* property, double size);

/// Throws InputError where the place for what is to be drawn is less than these.
void require_room(const Rect& place, double width, double height);

/// The size of letters, at most `size`, at which all texts are at most `room` wide.
double fitted_size(const Canvas& canvas, const std::vector<std::string>& texts, double room,
                   double size);

/// The text in lines of at most `room`, broken between words.
std::vector<std::string> in_lines(const Canvas& canvas, const std::string& text, double room,
                                  double size);

/// The pieces of a line in pixels that are drawn. Not left to VTK, whose patterns are of a fixed size.
std::vector<Points> drawn_pieces(const Points& line, const LineStyle& style);

/// The font of the pictures; empty where none is installed.
const std::string& font_file();

/// Letters that the font at hand does not have, spelled out.
std::string displayable(const std::string& text);

}  // namespace sbeh::picture
