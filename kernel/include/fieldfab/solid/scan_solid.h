/// Scans as solids, and as files of distances.
#pragma once

#include <filesystem>
#include <vector>

#include "fieldfab/asdf/import.h"
#include "fieldfab/solid/solid.h"
#include "fieldfab/volume/scan.h"

namespace fieldfab {

/// Writes the .asdf file of a scan, in as much memory as the settings say, whatever its size (see import_asdf()); its levels are
/// halved volumes.
ImportCounts import_scan(const Scan& scan, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress = Progress::none());

/// The lattices that import_scan() reads: the scan's, and halves of it.
std::vector<LatticeSource> lattices_of(const Scan& scan, int levels);

/// A scan as a solid in memory.
std::shared_ptr<OpenedSolid> opened_scan(const Scan& scan, Progress& progress = Progress::none());

}  // namespace fieldfab
