#include "tools/picture/canvas/image.h"

#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

namespace sbeh::picture {

namespace {

class ImageItem : public vtkContextItem {
 public:
  static ImageItem* New();
  void set(vtkImageData* image, double x, double y) {
    image_ = image;
    x_ = float(x);
    y_ = float(y);
  }
  bool Paint(vtkContext2D* painter) override {
    painter->DrawImage(x_, y_, image_);
    return true;
  }

 private:
  vtkSmartPointer<vtkImageData> image_;
  float x_ = 0.0f, y_ = 0.0f;
};

vtkStandardNewMacro(ImageItem);

}  // namespace

void draw_image(Canvas& canvas, vtkImageData* image, double x, double y) {
  vtkNew<ImageItem> item;
  item->set(image, x, y);
  canvas.add(item);
  canvas.embed(image, x, y);
}

}  // namespace sbeh::picture
