#include "tools/picture/canvas/canvas.h"

#include "studies/io/errors.h"
#include "tools/picture/canvas/items.h"
#include "tools/picture/canvas/picture_file.h"

#include <fmt/format.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace sbeh::picture {

struct Canvas::Window {
  vtkNew<vtkContextView> view;
  vtkSmartPointer<Layer> layer;   // the topmost item, if that is a layer
  std::vector<PageImage> images;  // those of the view's items
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
  window_->view->GetScene()->AddItem(vtkNew<Ground>());
  window_->layer = nullptr;
  window_->images.clear();
  window_->render_window()->SetSize(int(std::round(width)), int(std::round(height)));
}

void Canvas::fill(const Rect& rect, Colour colour) {
  if (window_->layer && !window_->layer->has_only_fills()) window_->layer = nullptr;
  window_->top().add_fill(rect, colour);
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
  window_->top().add_text(x, y, text, style);
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

std::vector<std::string> in_lines(const Canvas& canvas, const std::string& text, double room,
                                  double size) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && canvas.text_width(lines.back() + ' ' + word, size) <= room)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
  }
  return lines;
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
  window_->images.push_back({image, x, y});
}

void Canvas::write(const std::filesystem::path& stem, const Output& output) {
  const int* size = window_->render_window()->GetSize();
  if (output.must_fit && !window_->cut_off.empty())
    throw studies::InputError(fmt::format(
        "{}: \"{}\" does not fit into {} x {} pixels: choose a larger size, or less to show.",
        stem.string(), window_->cut_off, size[0], size[1]));
  write_picture(window_->render_window(), window_->images, stem, output);
}

void require_room(const Rect& place, double width, double height) {
  if (place.width < width || place.height < height)
    throw studies::InputError(fmt::format(
        "there is no room in this size: a part of the picture would have {:.0f} x {:.0f} "
        "pixels and needs {:.0f} x {:.0f}; choose a larger size, or less to show.",
        std::max(place.width, 0.0), std::max(place.height, 0.0), width, height));
}

}  // namespace sbeh::picture
