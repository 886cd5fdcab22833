#include "tools/picture/chart/legend.h"

#include <utility>

namespace sbeh::picture {
namespace {

constexpr double line_height = 1.7;  // all in text sizes
constexpr double sample_width = 2.4;
constexpr double sample_height = 1.0;
constexpr double sample_gap = 0.5;
constexpr double entry_gap = 1.8;

double entry_width(const Canvas& canvas, const LegendEntry& entry, double text_size) {
  return (sample_width + sample_gap) * text_size + canvas.text_width(entry.text, text_size);
}

struct Line {
  std::size_t begin = 0;
  std::size_t end = 0;
  double width = 0.0;
};

std::vector<Line> lines_of(const Canvas& canvas, const std::vector<LegendEntry>& entries,
                           double width, double text_size) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double own = entry_width(canvas, entries[i], text_size);
    const double longer = lines.empty() ? 0.0 : lines.back().width + entry_gap * text_size + own;
    if (lines.empty() || longer > width) {
      lines.push_back({i, i + 1, own});
    } else {
      lines.back().end = i + 1;
      lines.back().width = longer;
    }
  }
  return lines;
}

}  // namespace

LegendEntry line_entry(const LineStyle& style, std::string text) {
  return {[style](Canvas& canvas, const Rect& r) {
            canvas.line({{r.x, r.centre_y()}, {r.right(), r.centre_y()}}, style);
          },
          std::move(text)};
}

LegendEntry coloured_line_entry(const ColourMap& map, double width, std::string text) {
  return {
      [map, width](Canvas& canvas, const Rect& r) {
        constexpr int pieces = 24;
        const Rect place{r.x, r.centre_y() - 0.5 * width, r.width, width};
        canvas.line(place.outline(), {.colour = dark_grey, .width = 1.6});
        for (int i = 0; i < pieces; ++i) {
          const double value =
              map.scale().low + (i + 0.5) / pieces * (map.scale().high - map.scale().low);
          canvas.fill({r.x + i * r.width / pieces, place.y, r.width / pieces, width}, map(value));
        }
      },
      std::move(text)};
}

LegendEntry marker_entry(Marker marker, Colour colour, std::string text) {
  const auto sample = [=](Canvas& canvas, const Rect& r) {
    Chart(canvas, r, 1.0, {}, {}).markers({{0.5, 0.5}}, marker, colour, 0.6 * r.height);
  };
  return {sample, std::move(text)};
}

double legend_height(const Canvas& canvas, const std::vector<LegendEntry>& entries, double width,
                     double text_size) {
  return double(lines_of(canvas, entries, width, text_size).size()) * line_height * text_size;
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const Rect& place,
                 double text_size) {
  double y = place.top() - 0.5 * line_height * text_size;
  for (const Line& line : lines_of(canvas, entries, place.width, text_size)) {
    double x = place.centre_x() - 0.5 * line.width;
    for (std::size_t i = line.begin; i < line.end; ++i) {
      entries[i].sample(canvas, {x, y - 0.5 * sample_height * text_size, sample_width * text_size,
                                 sample_height * text_size});
      canvas.text(x + (sample_width + sample_gap) * text_size, y, entries[i].text,
                  {.size = text_size, .align = Align::left});
      x += entry_width(canvas, entries[i], text_size) + entry_gap * text_size;
    }
    y -= line_height * text_size;
  }
}

}  // namespace sbeh::picture
