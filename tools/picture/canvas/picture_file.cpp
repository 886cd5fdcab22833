#include "tools/picture/canvas/picture_file.h"

#include "model/names.h"
#include "studies/io/output.h"
#include "studies/report/html.h"

#include <fmt/format.h>
#include <unistd.h>
#include <vtkGL2PSExporter.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

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

// A chart finds its final place only when it is rendered for the second time.
void write_png(vtkRenderWindow* window, const fs::path& file) {
  window->SetMultiSamples(8);
  window->Render();
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
std::string svg_of(vtkRenderWindow* window, const std::vector<PageImage>& images,
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
  for (const auto& [image, x, y] : images)
    all += svg_image(image, x, size[1] - y - image->GetDimensions()[1]);
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

void write_picture(vtkRenderWindow* window, const std::vector<PageImage>& images,
                   const fs::path& stem, const Output& output) {
  const std::string name = stem.filename().string();
  const auto wants = [&](Format format) {
    return std::ranges::find(output.formats, format) != output.formats.end();
  };
  const auto temporary = [&](const std::string& kind) {
    return stem.parent_path() / fmt::format(".{}-{}.{}", name, getpid(), kind);
  };
  const auto put_text = [&](const std::string& kind, const std::string& text) {
    std::ofstream(temporary(kind), std::ios::binary) << text;
    put(temporary(kind), fs::path(stem) += "." + kind);
  };
  if (wants(Format::svg) || wants(Format::pdf)) {
    const fs::path draft = temporary("svg");
    const std::string svg = svg_of(window, images, draft, name, output.width);
    std::error_code ignored;
    fs::remove(draft, ignored);
    constexpr double points_per_mm = 72.0 / 25.4;
    const double width =
        output.width > 0.0 ? points_per_mm * output.width : double(window->GetSize()[0]);
    if (wants(Format::svg)) put_text("svg", svg);
    if (wants(Format::pdf)) put_text("pdf", pdf_of(svg, images, width));
  }
  if (wants(Format::png)) {
    write_png(window, temporary("png"));
    put(temporary("png"), fs::path(stem) += ".png");
  }
}

}  // namespace sbeh::picture
