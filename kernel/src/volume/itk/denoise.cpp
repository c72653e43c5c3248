// Noise reduction, by ITK's filters.
#include <itkCurvatureAnisotropicDiffusionImageFilter.h>
#include <itkDiscreteGaussianImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>
#include <itkMedianImageFilter.h>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "volume/parts.h"

namespace fieldfab {
namespace {

using Image = itk::Image<float, 3>;

Image::Pointer image_of(const Volume& volume, Progress& progress) {
  const SampleLattice& lattice = volume.lattice();
  auto image = Image::New();
  Image::SizeType size;
  Image::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<std::size_t>(lattice.size[axis]);
    spacing[axis] = lattice.spacing[static_cast<Eigen::Index>(axis)];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->Allocate();
  for (int k = 0; k < lattice.size[2]; ++k) {
    progress.check();
    volume.read(k, 1, image->GetBufferPointer() + static_cast<std::size_t>(k) * lattice.slice());
  }
  return image;
}

/// Runs a filter; a cancelled Progress aborts it.
template <class Filter>
std::vector<float> run(Filter& filter, const Image::Pointer& image, std::size_t count, Progress& progress) {
  filter.SetInput(image);

  filter.AddObserver(itk::ProgressEvent(), [&](const itk::EventObject&) {
    progress.report(filter.GetProgress(), "denoising");
    if (progress.cancelled()) filter.AbortGenerateDataOn();
  });
  try {
    filter.Update();
  } catch (const itk::ProcessAborted&) {
    progress.check();
  }
  const float* const made = filter.GetOutput()->GetBufferPointer();
  return {made, made + count};
}

}  // namespace

VolumePtr itk_denoised(const VolumePtr& volume, const Denoising& denoising, Progress& progress) {
  using Kind = Denoising::Kind;
  const SampleLattice lattice = volume->lattice();
  require_memory(4 * lattice.count() * sizeof(float), "volume");
  const Image::Pointer image = image_of(*volume, progress);
  std::vector<float> densities;
  if (denoising.kind == Kind::median) {
    const auto filter = itk::MedianImageFilter<Image, Image>::New();
    Image::SizeType radius;
    radius.Fill(static_cast<std::size_t>(std::max(1.0, std::round(denoising.amount))));
    filter->SetRadius(radius);
    densities = run(*filter, image, lattice.count(), progress);
  } else if (denoising.kind == Kind::gaussian) {
    const auto filter = itk::DiscreteGaussianImageFilter<Image, Image>::New();
    filter->SetVariance(denoising.amount * denoising.amount);
    filter->SetMaximumKernelWidth(65);
    densities = run(*filter, image, lattice.count(), progress);
  } else {
    const auto filter = itk::CurvatureAnisotropicDiffusionImageFilter<Image, Image>::New();
    filter->SetNumberOfIterations(5);
    filter->SetConductanceParameter(denoising.amount);
    filter->SetTimeStep(0.0625 * lattice.spacing.minCoeff());
    densities = run(*filter, image, lattice.count(), progress);
  }
  return volume_of(std::move(densities), lattice, volume->own_threshold());
}

}  // namespace fieldfab
