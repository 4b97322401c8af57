// The advice for a file that is not there.
//
//   near_file("models/sizi.glb")   // "did you mean 'models/suzi.glb'?"
#pragma once

#include <string>

namespace patina {

class Root;

// Nothing if no file of the folder has the same ending and nearly this name, or if the folder must not be listed
// (disk/disk.h).
std::string near_file(const std::string& path, const Root* root = nullptr);

}  // namespace patina
