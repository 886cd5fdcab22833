#include "tools/picture/canvas/canvas.h"

#include "model/names.h"
#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/report/html.h"
#include "tools/picture/canvas/pdf.h"

#include <fmt/format.h>
#include <unistd.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkGL2PSExporter.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLContextDevice2D.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

// The white ground, on which one unit is one pixel: VTK stretches a picture by one pixel over its width
// and its height, which blurs letters and, with smoothed edges, shows their upper edge once more below.
class Sheet : public vtkContextItem {
 public:
  static Sheet* New();

  bool Paint(vtkContext2D* painter) override {
    auto* device = vtkOpenGLContextDevice2D::SafeDownCast(painter->GetDevice());
    if (!device) return false;
    const int* size = device->GetRenderWindow()->GetSize();
    auto& projection =
        device->GetProjectionMatrix()->Element;  // set anew by VTK for every rendering
    for (int c = 0; c < 2; ++c) {
      projection[c][c] = 2.0 / size[c];
      projection[c][3] = -1.0;
    }
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColor(255, 255, 255, 255);
    painter->DrawRect(0.0f, 0.0f, float(size[0]), float(size[1]));
    return true;
  }
};

vtkStandardNewMacro(Sheet);

void set_text_style(vtkTextProperty* property, const TextStyle& style) {
  set_font(property, style.size);
  property->SetColor(style.colour.red / 255.0, style.colour.green / 255.0,
                     style.colour.blue / 255.0);
  property->SetOrientation(style.upward ? 90.0 : 0.0);
  property->SetVerticalJustificationToCentered();
  switch (style.align) {
    case Align::left:
      property->SetJustificationToLeft();
      break;
    case Align::centre:
      property->SetJustificationToCentered();
      break;
    case Align::right:
      property->SetJustificationToRight();
      break;
  }
}

// Rectangles, lines and texts at pixel positions: what stands between and beside the charts. They are given to
// VTK as shapes: GL2PS as Debian builds it leaves images out of an SVG.
class Layer : public vtkContextItem {
 public:
  static Layer* New();

  struct Line {
    std::vector<float> points;
    LineStyle style;
    bool joined;  // otherwise a segment between each two points
  };
  struct Text {
    float x, y;
    std::string text;
    TextStyle style;
  };
  std::map<unsigned, std::vector<float>> quads;  // by colour: one call draws many
  std::vector<Line> lines;
  std::vector<Text> texts;

  void add_line(const Points& points, const LineStyle& style, bool joined) {
    Line line{{}, style, joined};
    for (const auto& [x, y] : points) line.points.insert(line.points.end(), {float(x), float(y)});
    if (points.size() > 1) lines.push_back(std::move(line));
  }

  // Fills first, then lines, then texts.
  bool Paint(vtkContext2D* painter) override {
    for (auto& [key, corners] : quads) {
      painter->GetPen()->SetLineType(vtkPen::NO_PEN);
      painter->GetBrush()->SetColor(key >> 16u & 255u, key >> 8u & 255u, key & 255u);
      painter->GetBrush()->SetOpacity(255);
      painter->GetDevice()->DrawQuad(corners.data(), int(corners.size() / 2));
    }
    for (auto& [points, style, joined] : lines) {
      painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
      painter->GetPen()->SetWidth(float(style.width));
      painter->GetPen()->SetColor(style.colour.red, style.colour.green, style.colour.blue, 255);
      const int count = int(points.size() / 2);
      if (joined)
        painter->DrawPoly(points.data(), count);
      else
        painter->DrawLines(points.data(), count);
    }
    for (const Text& text : texts) {
      set_text_style(painter->GetTextProp(), text.style);
      painter->DrawString(text.x, text.y, text.text.c_str());
    }
    return true;
  }
};

vtkStandardNewMacro(Layer);

class Image : public vtkContextItem {
 public:
  static Image* New();

  vtkSmartPointer<vtkImageData> image;
  double x = 0.0, y = 0.0;

  bool Paint(vtkContext2D* painter) override {
    painter->DrawImage(float(x), float(y), image);
    return true;
  }
};

vtkStandardNewMacro(Image);

}  // namespace

struct Canvas::Window {
  vtkNew<vtkContextView> view;
  vtkSmartPointer<Layer> layer;                // the topmost item, if that is a layer
  std::vector<vtkSmartPointer<Image>> images;  // for the SVG
  double unit = 1.0;
  std::string cut_off;  // a text that is not whole

  Layer& top() {
    if (!layer) {
      layer = vtkSmartPointer<Layer>::New();
      view->GetScene()->AddItem(layer);
    }
    return *layer;
  }
  vtkRenderWindow* render_window() { return view->GetRenderWindow(); }
};

Canvas::Canvas() : window_(std::make_unique<Window>()) {
  window_->render_window()->SetOffScreenRendering(1);
  window_->view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
}

Canvas::~Canvas() = default;

std::vector<Points> drawn_pieces(const Points& line, const LineStyle& style) {
  const double w = std::max(style.width, 1.2);
  switch (style.pattern) {
    case Pattern::solid:
      return {line};
    case Pattern::dashed:
      return dashes(line, {4.5 * w, 3.0 * w});
    case Pattern::dotted:
      return dashes(line, {1.2 * w, 2.0 * w});
    case Pattern::dash_dotted:
      return dashes(line, {5.0 * w, 2.2 * w, 1.2 * w, 2.2 * w});
  }
  return {line};
}

double Canvas::unit() const { return window_->unit; }

void Canvas::start(double width, double height, double unit) {
  window_->unit = unit;
  window_->cut_off.clear();
  window_->view->GetScene()->ClearItems();
  window_->view->GetScene()->AddItem(vtkNew<Sheet>());
  window_->layer = nullptr;
  window_->images.clear();
  window_->render_window()->SetSize(int(std::round(width)), int(std::round(height)));
}

void Canvas::fill(const Rect& rect, Colour colour) {
  const Layer* layer = window_->layer;
  if (layer && !(layer->lines.empty() && layer->texts.empty())) window_->layer = nullptr;
  const unsigned key = colour.red << 16u | colour.green << 8u | colour.blue;
  const auto left = float(rect.x), right = float(rect.right());
  const auto bottom = float(rect.y), top = float(rect.top());
  auto& quads = window_->top().quads[key];
  quads.insert(quads.end(), {left, bottom, right, bottom, right, top, left, top});
}

void Canvas::line(const Points& points, const LineStyle& style) {
  const LineStyle drawn{style.colour, unit() * style.width, style.pattern};
  for (const Points& piece : drawn_pieces(points, drawn))
    window_->top().add_line(piece, drawn, true);
}

void Canvas::segments(const Points& ends, const LineStyle& style) {
  window_->top().add_line(ends, {style.colour, unit() * style.width}, false);
}

void Canvas::text(double x, double y, const std::string& text, const TextStyle& style) {
  if (text.empty()) return;
  const double length = text_width(text, style.size);
  const double before = style.align == Align::left   ? 0.0
                      : style.align == Align::centre ? 0.5 * length
                                                     : length;
  const double along = style.upward ? y : x, across = style.upward ? x : y;
  const int* size = window_->render_window()->GetSize();
  const double room = size[style.upward ? 1 : 0], depth = size[style.upward ? 0 : 1];
  constexpr double letters = 0.35,
                   slack = 1.0;  // of a line's height above and below its middle; pixels
  if (along - before < -slack || along - before + length > room + slack
      || across < letters * style.size - slack || across > depth - letters * style.size + slack)
    window_->cut_off = text;
  window_->top().texts.push_back(
      {float(std::round(x)), float(std::round(y)), displayable(text), style});
}

double Canvas::text_width(const std::string& text, double size) const {
  vtkNew<vtkTextProperty> property;
  set_font(property, size);
  int box[4] = {0, 0, 0, 0};
  const int dpi = window_->render_window()->GetDPI();
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, displayable(text), box, dpi);
  return box[1] - box[0] + 1;
}

double fitted_size(const Canvas& canvas, const std::vector<std::string>& texts, double room,
                   double size) {
  double widest = 0.0;
  for (const std::string& text : texts)
    if (!text.empty()) widest = std::max(widest, canvas.text_width(text, size));
  return widest > room ? size * room / widest : size;
}

void Canvas::add(vtkContextItem* item) {
  window_->view->GetScene()->AddItem(item);
  window_->layer = nullptr;
}

void Canvas::image(vtkImageData* image, double x, double y) {
  vtkNew<Image> item;
  item->image = image;
  item->x = x;
  item->y = y;
  add(item);
  window_->images.emplace_back(item);
}

namespace {

std::string svg_image(vtkImageData* image, double x, double top) {
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  const std::string bytes(png->Begin(), png->End());
  const int* size = image->GetDimensions();
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      x, top, size[0], size[1], studies::html::base64(bytes));
}

// GL2PS, as Debian builds it, leaves images out: puts them upon the white ground, which comes first.
std::string with_images(std::string text, const std::string& images) {
  if (images.empty()) return text;
  const std::string ground = "<polygon fill=\"#ffffff\"";
  std::size_t at = text.find("<g>\n");
  if (at == std::string::npos) throw std::runtime_error("the SVG has no group to put images into");
  at += 4;
  while (text.compare(at, ground.size(), ground) == 0) at = text.find('\n', at) + 1;
  return text.insert(at, images);
}

void write_png(vtkRenderWindow* window, const fs::path& file) {
  window->SetMultiSamples(8);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

// The exporter renders the window several times over, so without smoothing of the pixels.
void write_svg(vtkRenderWindow* window, fs::path file, const std::string& title) {
  window->SetMultiSamples(0);
  vtkNew<vtkGL2PSExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->UsePainterSettings();
  exporter->SetFileFormatToSVG();
  exporter->SetCompress(false);
  exporter->SetSilent(true);
  exporter->SetTitle(title.c_str());
  exporter->SetFilePrefix(file.replace_extension().c_str());
  exporter->Write();
}

// A picture's SVG with its images, in a unit of length where the page has one.
std::string svg_of(vtkRenderWindow* window, const std::vector<vtkSmartPointer<Image>>& images,
                   const fs::path& temporary, const std::string& title, double width) {
  write_svg(window, temporary, title);
  std::string text = studies::read_file(temporary);
  const int* size = window->GetSize();
  const std::string points = fmt::format("width=\"{}pt\" height=\"{}pt\"", size[0], size[1]);
  if (const std::size_t at = text.find(points); at != std::string::npos && width > 0.0)
    text.replace(
        at, points.size(),
        fmt::format("width=\"{:.4g}mm\" height=\"{:.4g}mm\"", width, width * size[1] / size[0]));
  std::string all;
  for (const auto& item : images)
    all += svg_image(item->image, item->x, size[1] - item->y - item->image->GetDimensions()[1]);
  return with_images(std::move(text), all);
}

// Whether the file ends as its kind does: a full disk goes unnoticed while it is written.
bool is_complete(const fs::path& file) {
  constexpr int length = 16;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(-length, std::ios::end);
  std::string end(length, ' ');
  stream.read(end.data(), length);
  return stream
      && (end.find("IEND") != std::string::npos || end.find("</svg>") != std::string::npos
          || end.find("%%EOF") != std::string::npos);
}

void put(const fs::path& temporary, const fs::path& target) {
  std::error_code error;
  const bool complete = is_complete(temporary);
  if (complete) fs::rename(temporary, target, error);
  if (!complete || error) {
    fs::remove(temporary, error);
    throw std::runtime_error(
        fmt::format("{}: cannot be written; free some space there or give "
                    "yourself the right to write.",
                    target.string()));
  }
  fmt::print("wrote {}\n", target.string());
}

}  // namespace

void Canvas::write(const fs::path& stem, const Output& output) {
  vtkRenderWindow* window = window_->render_window();
  const int* size = window->GetSize();
  if (output.must_fit && !window_->cut_off.empty())
    throw studies::InputError(fmt::format(
        "{}: \"{}\" does not fit into {} x {} pixels: choose a larger size, or less to show.",
        stem.string(), window_->cut_off, size[0], size[1]));
  const std::string name = stem.filename().string();
  const auto wants = [&](Format format) {
    return std::ranges::find(output.formats, format) != output.formats.end();
  };
  // First the SVG: a chart finds its final place only when it is rendered for the second time.
  std::string svg;
  for (const Format format : {Format::svg, Format::pdf, Format::png}) {
    if (!wants(format)) continue;
    const std::string kind = std::string(".") + sbeh::name(format);
    const fs::path temporary = stem.parent_path() / fmt::format(".{}-{}{}", name, getpid(), kind);
    const auto put_text = [&](const std::string& text) {
      std::ofstream(temporary, std::ios::binary) << text;
    };
    if (format != Format::png && svg.empty()) {
      const fs::path draft = stem.parent_path() / fmt::format(".{}-{}.svg", name, getpid());
      svg = svg_of(window, window_->images, draft, name, output.width);
      std::error_code ignored;
      fs::remove(draft, ignored);
    }
    if (format == Format::svg) put_text(svg);
    if (format == Format::pdf) {
      constexpr double points_per_mm = 72.0 / 25.4;
      std::vector<PageImage> images;
      for (const auto& item : window_->images) images.push_back({item->image, item->x, item->y});
      put_text(
          pdf_of(svg, images, output.width > 0.0 ? points_per_mm * output.width : double(size[0])));
    }
    if (format == Format::png) write_png(window, temporary);
    put(temporary, fs::path(stem) += kind);
  }
}

void require_room(const Rect& place, double width, double height) {
  if (place.width < width || place.height < height)
    throw studies::InputError(fmt::format(
        "there is no room in this size: a part of the picture would have {:.0f} x {:.0f} "
        "pixels and needs {:.0f} x {:.0f}; choose a larger size, or less to show.",
        std::max(place.width, 0.0), std::max(place.height, 0.0), width, height));
}

}  // namespace sbeh::picture
