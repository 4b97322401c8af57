// Texture reads in the code of custom functions: the engine's macros and the members of its structs, as methods of the
// node language.
//
//   with_texture_reads("SAMPLE_TEXTURE2D(T.tex, S.samplerstate, UV)", {"S"});
//   // "T.Sample(S, float2(0, 1) + float2(1, -1) * (UV))": the engine counts v from the bottom
#pragma once

#include <set>
#include <string>

namespace patina::importers::shadergraph {

// `samplers`: parameters that are samplers, beside those that the code itself declares.
std::string with_texture_reads(std::string code, std::set<std::string, std::less<>> samplers);

}  // namespace patina::importers::shadergraph
