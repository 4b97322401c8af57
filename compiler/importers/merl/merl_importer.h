// Measured isotropic BRDFs in the form of the MERL database (.binary): the table becomes a picture, and the graph a
// material with the library's model for such tables. runtime/lighting/merl.h knows the format.
#pragma once

#include "compiler/importers/importer.h"

namespace patina::importers {

Importer merl_importer();

}  // namespace patina::importers
