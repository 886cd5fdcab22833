#include "tools/picture/canvas/pdf.h"

#include "tools/picture/canvas/outlines.h"

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkZLibDataCompressor.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace sbeh::picture {
namespace {

// ---- SVG ----------------------------------------------------------------------------------------

// Of an element in one line; empty where it has none of that name.
std::string_view attribute(std::string_view line, std::string_view name) {
  const std::string begin = fmt::format(" {}=\"", name);
  const std::size_t at = line.find(begin);
  if (at == std::string_view::npos) return {};
  line.remove_prefix(at + begin.size());
  return line.substr(0, line.find('"'));
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char *at = text.data(), *end = at + text.size();
  while (at != end) {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error == std::errc()) numbers.push_back(value);
    at = error == std::errc() ? next : at + 1;
  }
  return numbers;
}

double number_in(std::string_view text, double otherwise = 0.0) {
  const std::vector<double> all = numbers_in(text);
  return all.empty() ? otherwise : all.front();
}

std::string colour_of(std::string_view hex) {  // "#rrggbb"
  std::string channels;
  for (std::size_t k = 1; k + 1 < hex.size(); k += 2) {
    int value = 0;
    std::from_chars(hex.data() + k, hex.data() + k + 2, value, 16);
    channels += fmt::format("{:.4f} ", value / 255.0);
  }
  return channels;
}

std::string plain(std::string_view escaped) {
  constexpr std::array<std::pair<std::string_view, char>, 4> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}}};
  std::string text;
  for (std::size_t i = 0; i < escaped.size(); ++i) {
    text += escaped[i];
    for (const auto& [entity, letter] : entities)
      if (escaped.substr(i).starts_with(entity)) {
        text.back() = letter;
        i += entity.size() - 1;
        break;
      }
  }
  return text;
}

// ---- what is drawn ------------------------------------------------------------------------------

std::string path_of(const std::vector<double>& xy, bool backwards = false) {
  std::string path;
  const std::size_t n = xy.size() / 2;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = backwards ? n - 1 - k : k;
    path += fmt::format("{:.3f} {:.3f} {} ", xy[2 * i], xy[2 * i + 1], k == 0 ? "m" : "l");
  }
  return path;
}

double signed_area(const std::vector<double>& xy) {
  double sum = 0.0;
  const std::size_t n = xy.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    sum += xy[2 * i] * xy[2 * next + 1] - xy[2 * next] * xy[2 * i + 1];
  }
  return sum / 2;
}

std::string text_of(std::string_view line) {
  const std::size_t begin = line.find('>') + 1;
  const double size = number_in(attribute(line, "font-size"), 1.0);
  const double x = number_in(attribute(line, "x")), y = number_in(attribute(line, "y"));
  const double angle = number_in(attribute(line, "transform")) * std::acos(-1.0) / 180.0;
  const double down = number_in(attribute(line, "dy")) / size;
  const std::string_view anchor = attribute(line, "text-anchor");
  const Outlines letters = outlines_of(plain(line.substr(begin, line.rfind('<') - begin)));
  const double left = anchor == "middle" ? -0.5 * letters.width
                    : anchor == "end"    ? -letters.width
                                         : 0.0;
  const double c = size * std::cos(angle), s = size * std::sin(angle);
  return fmt::format(
      "q {:.4f} {:.4f} {:.4f} {:.4f} {:.3f} {:.3f} cm 1 0 0 1 {:.4f} {:.4f} cm {}rg\n{}f Q\n", c, s,
      s, -c, x, y, left, -down, colour_of(attribute(line, "fill")), letters.path);
}

// Polygons of one colour that follow each other are one: between two, the ground would be seen. The white ones at the
// beginning are the ground, which a page has.
std::string drawing_of(std::string_view svg) {
  std::string drawing, fill;
  bool on_ground = true;
  const auto end_fill = [&] {
    if (!fill.empty()) drawing += "f\n";
    fill.clear();
  };
  for (std::size_t from = 0; from < svg.size();) {
    const std::size_t end = std::min(svg.find('\n', from), svg.size());
    const std::string_view line = svg.substr(from, end - from);
    from = end + 1;
    const bool is_polygon = line.starts_with("<polygon"), is_line = line.starts_with("<polyline"),
               is_text = line.starts_with("<text");
    if (!is_polygon && !is_line && !is_text) continue;
    on_ground = on_ground && is_polygon && attribute(line, "fill") == "#ffffff";
    if (on_ground) continue;
    if (is_polygon) {
      const std::string colour = colour_of(attribute(line, "fill"));
      if (colour != fill) {
        end_fill();
        fill = colour;
        drawing += colour + "rg\n";
      }
      const std::vector<double> xy = numbers_in(attribute(line, "points"));
      drawing += path_of(xy, signed_area(xy) < 0) + "h\n";
      continue;
    }
    end_fill();
    drawing += is_text ? text_of(line)
                       : fmt::format("{}RG {:.3f} w {}S\n", colour_of(attribute(line, "stroke")),
                                     number_in(attribute(line, "stroke-width"), 1.0),
                                     path_of(numbers_in(attribute(line, "points"))));
  }
  end_fill();
  return drawing;
}

// ---- PDF ----------------------------------------------------------------------------------------

std::string compressed(const unsigned char* data, std::size_t size) {
  vtkNew<vtkZLibDataCompressor> compressor;
  const auto packed = vtk::TakeSmartPointer(compressor->Compress(data, size));
  return {packed->Begin(), packed->End()};
}

class Document {
 public:
  /// The number of the object.
  int add(const std::string& object) {
    places_.push_back(text_.size());
    text_ += fmt::format("{} 0 obj\n{}\nendobj\n", places_.size(), object);
    return int(places_.size());
  }
  int add_stream(const std::string& entries, const std::string& packed) {
    return add(
        fmt::format("<< {} /Filter /FlateDecode /Length {} >>\nstream\n", entries, packed.size())
        + packed + "\nendstream");
  }
  std::string finished(int catalog) const {
    std::string text = text_ + fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1);
    for (const std::size_t place : places_) text += fmt::format("{:010} 00000 n \n", place);
    return text
         + fmt::format("trailer\n<< /Size {} /Root {} 0 R >>\nstartxref\n{}\n%%EOF\n",
                       places_.size() + 1, catalog, text_.size());
  }

 private:
  std::string text_ = "%PDF-1.4\n";
  std::vector<std::size_t> places_;
};

}  // namespace

std::string pdf_of(std::string_view svg, const std::vector<PageImage>& images, double width) {
  const std::vector<double> box = numbers_in(attribute(svg.substr(0, 1000), "viewBox"));
  if (box.size() != 4) throw std::runtime_error("the SVG has no viewBox");
  const double pixels = box[2], scale = width / pixels, height = box[3] * scale;
  Document document;
  std::string names, placed;
  for (std::size_t k = 0; k < images.size(); ++k) {
    vtkImageData* image = images[k].image;
    const int* size = image->GetDimensions();
    std::string rows;  // from the top
    const auto* bytes = static_cast<const char*>(image->GetScalarPointer());
    const std::size_t row = 3 * std::size_t(size[0]);
    for (int j = size[1] - 1; j >= 0; --j) rows.append(bytes + std::size_t(j) * row, row);
    const int number = document.add_stream(
        fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /ColorSpace /DeviceRGB "
                    "/BitsPerComponent 8",
                    size[0], size[1]),
        compressed(reinterpret_cast<const unsigned char*>(rows.data()), rows.size()));
    names += fmt::format("/I{} {} 0 R ", k, number);
    placed += fmt::format("q {} 0 0 {} {} {} cm /I{} Do Q\n", size[0], -size[1], images[k].x,
                          box[3] - images[k].y, k);
  }
  const std::string drawing =
      fmt::format("{0:.6f} 0 0 {1:.6f} 0 {2:.4f} cm 1 j\n", scale, -scale, height) + placed
      + drawing_of(svg);
  const int content = document.add_stream(
      "", compressed(reinterpret_cast<const unsigned char*>(drawing.data()), drawing.size()));
  const int page = content + 1, pages = content + 2;
  document.add(
      fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {:.2f} {:.2f}] /Contents {} "
                  "0 R /Resources << /XObject << {}>> >> >>",
                  pages, width, height, content, names));
  document.add(fmt::format("<< /Type /Pages /Kids [{} 0 R] /Count 1 >>", page));
  return document.finished(document.add(fmt::format("<< /Type /Catalog /Pages {} 0 R >>", pages)));
}

}  // namespace sbeh::picture
