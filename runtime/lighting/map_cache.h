// Prefiltered environments in files, so that the next start finds them.
//
//   const std::string name = MapCache::name_of(bytes_of_the_picture, rotation);
//   if (auto kept = MapCache().read(name)) use(kept->ambient, kept->map);
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "patina/interpret.h"
#include "runtime/lighting/harmonics.h"

namespace patina::runtime {

struct KeptEnvironment {
    SphericalHarmonics ambient{};
    TextureData map{};  // with all its levels
};

class MapCache {
public:
    // Of the folder that the environment variables name; of none, nothing is found and nothing kept.
    MapCache();

    static std::string name_of(std::string_view picture, double rotation);

    // Nothing if it is not there, or is not whole.
    std::optional<KeptEnvironment> read(const std::string& name) const;
    // At most kMostKept files are kept: the oldest go. Failures are no errors: the next start computes it again.
    void write(const std::string& name, const KeptEnvironment& environment) const;

    static constexpr std::size_t kMostKept = 32;

private:
    std::string path_of(const std::string& name) const;

    std::string folder_;
};

}  // namespace patina::runtime
