#pragma once

#include <filesystem>
#include <string>

namespace enfilade {

/// The path of the file `name` that a model names, proved to lie inside the model's own folder,
/// symbolic links resolved; the file need not be there.  Either system's separators.  Throws Error
/// (kBadInput) that names the model: an address, no file name, outside the folder.
std::filesystem::path fileInModelFolder(const std::string& model_file, const std::string& name);

}  // namespace enfilade
