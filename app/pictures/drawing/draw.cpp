#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "app/pictures/drawing/internal/actors.hpp"
#include "app/pictures/drawing/internal/x_display.hpp"
#include "app/pictures/module.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Each pixel is the mean of so many by so many, which smooths lines, edges and text alike.
int samples_per_pixel(const PictureSize& size) {
  return std::max(size.width, size.height) <= 4096 ? 2 : 1;
}

double size_of(const Surface& surface) {
  return (surface.points.rowwise().maxCoeff() - surface.points.rowwise().minCoeff()).norm();
}

void aim(vtkCamera* camera, const Camera& wanted, double distance) {
  const Eigen::Vector3d eye = wanted.focus + distance * wanted.view.toward_eye;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(wanted.focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(wanted.view.up.data());
  camera->SetParallelScale(wanted.height / 2);
}

/// From above the left shoulder, a weaker one from the right, and one from the eye.
void add_lights(vtkRenderer* renderer) {
  constexpr std::array<std::array<double, 4>, 3> lights = {
      {{-0.6, 0.8, 1, 0.55}, {0.9, -0.2, 0.6, 0.2}, {0, 0, 1, 0.35}}};
  renderer->AutomaticLightCreationOff();
  for (const auto& [x, y, z, intensity] : lights) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
  }
}

void fill(vtkRenderer* renderer, const Picture& picture, double scale) {
  renderer->SetBackground(1, 1, 1);
  renderer->SetBackgroundAlpha(picture.transparent ? 0 : 1);
  renderer->AddActor(surface_actor(picture.surface, picture.palette));
  // In parallel projection this changes nothing but the depth.
  const Eigen::Vector3d shift = 1.5e-3 * size_of(picture.surface) * picture.camera.view.toward_eye;
  if (!picture.element_lines.segments.empty())
    renderer->AddActor(
        lines_actor(picture.element_lines, 0.5 * scale * picture.line_width, {90, 90, 90}, shift));
  if (!picture.patch_lines.segments.empty())
    renderer->AddActor(lines_actor(picture.patch_lines, scale * picture.line_width, {25, 25, 25}, shift));
  for (const ColouredLines& some : picture.coloured_lines)
    if (!some.lines.segments.empty())
      renderer->AddActor(lines_actor(some.lines, scale * some.width, some.colour, shift));
  if (!picture.polygons.empty()) renderer->AddActor2D(polygons_actor(picture.polygons, scale));
  for (const PictureText& text : picture.texts) renderer->AddActor2D(text_actor(text, scale));
  add_lights(renderer);
  aim(renderer->GetActiveCamera(), picture.camera, 2 * size_of(picture.surface));
  renderer->ResetCameraClippingRange();
}

/// Means over squares of pixels; colours count as much as they cover.
vtkSmartPointer<vtkImageData> reduced(vtkImageData* fine, int factor, bool transparent) {
  const int* size = fine->GetDimensions();
  const int channels = transparent ? 4 : 3;
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(size[0] / factor, size[1] / factor, 1);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  for (int y = 0; y < size[1] / factor; ++y)
    for (int x = 0; x < size[0] / factor; ++x) {
      std::array<int, 4> sum{};
      for (int j = 0; j < factor; ++j)
        for (int i = 0; i < factor; ++i) {
          const auto* pixel =
              static_cast<const unsigned char*>(fine->GetScalarPointer(x * factor + i, y * factor + j, 0));
          const int weight = transparent ? pixel[3] : 1;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * pixel[c];
          sum[3] += weight;
        }
      auto* pixel = static_cast<unsigned char*>(result->GetScalarPointer(x, y, 0));
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<unsigned char>(sum[3] ? (sum[c] + sum[3] / 2) / sum[3] : 255);
      if (transparent) pixel[3] = static_cast<unsigned char>(sum[3] / (factor * factor));
    }
  return result;
}

std::string png(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(9);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
    throw Error(ErrorCode::internal, "the picture could not be encoded");
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

std::string draw(const Picture& picture, const std::string& display_name) {
  vtkObject::GlobalWarningDisplayOff();
  const XDisplay display(display_name);
  const int scale = samples_per_pixel(picture.size);
  vtkNew<vtkRenderer> renderer;
  fill(renderer, picture, scale);
  vtkNew<vtkRenderWindow> window;
  window->SetDisplayId(display.get());
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(scale == 1 ? 8 : 4);
  window->SetAlphaBitPlanes(1);
  window->SetSize(picture.size.width * scale, picture.size.height * scale);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  if (picture.transparent) image->SetInputBufferTypeToRGBA();
  image->Update();
  return png(reduced(image->GetOutput(), scale, picture.transparent));
}

}  // namespace
}  // namespace isopatch::app

extern "C" {

void isopatch_display_problem(const std::string& display, std::string& problem) {
  problem = isopatch::app::XDisplay::problem(display);
}

void isopatch_draw(const isopatch::app::Picture& picture, const std::string& display, std::string& png) {
  png = isopatch::app::draw(picture, display);
}
}
