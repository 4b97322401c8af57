// The advice for a file that is not there.
//
//   near_file("models/sizi.glb")   // "did you mean 'models/suzi.glb'?"
#pragma once

#include <string>

namespace patina {

// Nothing if no file of the folder has the same ending and nearly this name.
std::string near_file(const std::string& path);

}  // namespace patina
