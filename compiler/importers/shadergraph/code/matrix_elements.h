// Elements of matrices by their names, "M._m01" and "M._12_13", as the node language says them: "M[0][1]",
// "float2(M[0][1], M[0][2])".
#pragma once

#include <string>

namespace patina::importers::shadergraph {

// `error`: what of them it cannot say; empty: nothing.
std::string with_matrix_elements(const std::string& code, std::string& error);

}  // namespace patina::importers::shadergraph
