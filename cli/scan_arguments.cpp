#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "fieldfab/core/error.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

/// Parses 2G, 512M, 100000K or a number of bytes.
std::size_t bytes(const std::string& text) {
  double number = 0;
  const auto [next, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string unit(next, text.data() + text.size());
  const double factor = unit.empty()                 ? 1
                        : unit == "K" || unit == "k" ? 1024.0
                        : unit == "M" || unit == "m" ? 1048576.0
                        : unit == "G" || unit == "g" ? 1073741824.0
                                                     : 0;
  if (failure != std::errc{} || factor == 0 || !(number * factor >= 1 << 20) || number * factor > 1e15)
    throw Error(ErrorKind::bad_input, "--memory",
                fmt::format("'{:.40}' is not an amount such as 512M or 2G, at least 1M", text));
  return static_cast<std::size_t>(number * factor);
}

}  // namespace

void ScanArguments::declare(CLI::App& verb) {
  const char* const group = "CT volumes";
  verb.add_option("--threshold", threshold,
                  "threshold density of the solid: a number, a percentile such as 90%, otsu, or halfway (the default: "
                  "between the "
                  "two most frequent densities)")
      ->group(group);
  verb.add_flag("--below", below, "densities below the threshold are solid")->group(group);
  verb.add_option("--dims", size, "samples X,Y,Z of a .raw or .vol file; otherwise from its name or .vgi")
      ->group(group);
  verb.add_option("--type", type, "type of the samples: uint8 int8 uint16 int16 uint32 int32 float32 float64")
      ->group(group);
  verb.add_option("--byte-order", byte_order, "byte order of the samples")
      ->check(CLI::IsMember({"little", "big"}))
      ->group(group);
  verb.add_option("--skip", skip, "bytes before the samples")->group(group);
  verb.add_option("--spacing", spacing, "mm between samples, X,Y,Z; otherwise as the file says, or 1")->group(group);
  verb.add_option("--series", series, "of a DICOM folder with several: its identifier, a part of it, or its number")
      ->group(group);
  verb.add_option("--crop", crop, "only these samples: first X,Y,Z and last X,Y,Z, six numbers from 0")->group(group);
  verb.add_option("--denoise", denoise,
                  "median[:RADIUS in samples], gaussian[:SIGMA in mm] or anisotropic[:CONDUCTANCE]")
      ->group(group);
  verb.add_flag("--keep-largest", keep_largest, "keep the largest piece only")->group(group);
  verb.add_option("--min-island", least_island, "remove pieces smaller than this many mm3")->group(group);
  verb.add_option("--min-hole", least_hole, "fill cavities smaller than this many mm3")->group(group);
  verb.add_flag("--fill-holes", fill_holes, "fill all cavities")->group(group);
  verb.add_option("--memory", memory, "memory limit of reading, such as 2G")->capture_default_str()->group(group);
}

std::vector<frep::OpenOption> ScanArguments::options() const {
  std::vector<frep::OpenOption> given;
  for (const auto& [name, text] : {std::pair("threshold", &threshold),
                                   {"dims", &size},
                                   {"type", &type},
                                   {"byte_order", &byte_order},
                                   {"spacing", &spacing},
                                   {"series", &series},
                                   {"crop", &crop},
                                   {"denoise", &denoise}}) {
    if (text->empty()) continue;
    double number = 0;  // a plain number is printed as a number
    const auto [end, failure] = std::from_chars(text->data(), text->data() + text->size(), number);
    if (failure == std::errc{} && end == text->data() + text->size() && std::isfinite(number))
      given.push_back({name, number});
    else
      given.push_back({name, *text});
  }
  for (const auto& [name, flag] :
       {std::pair("below", below), {"keep_largest", keep_largest}, {"fill_holes", fill_holes}})
    if (flag) given.push_back({name, 1.0});
  if (skip) given.push_back({"skip", static_cast<double>(*skip)});
  if (least_island) given.push_back({"min_island", *least_island});
  if (least_hole) given.push_back({"min_hole", *least_hole});
  return given;
}

ScanOptions ScanArguments::parsed() const {
  ScanOptions options = scan_options(this->options());
  options.memory = bytes(memory);
  return options;
}

}  // namespace fieldfab::cli
