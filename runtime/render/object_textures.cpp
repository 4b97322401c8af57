#include "runtime/render/object_textures.h"

#include <map>

#include "patina/complaints.h"

namespace patina::runtime {

ObjectTextures load_object_textures(const World& world) {
    ObjectTextures made;
    std::map<std::string, LoadedTexture> known;
    made.textures.resize(world.objects.size());
    const auto load = [&](std::size_t object, const std::string& name, const std::string& file,
                          const FileLocation& place, bool is_color) {
        if (file.empty()) return;
        const std::string key = (is_color ? "color " : "data ") + file;
        if (!known.contains(key)) {
            Outcome<Image> image = load_image(file);
            if (!image) {
                made.diagnostics.push_back(
                    diagnostic_at(place, std::string(code_of(Complaint::BadTexture)), image.error));
                made.ok = false;
                return;
            }
            made.files.push_back(file);
            if (is_color && image.value.bits <= 8) decode_srgb(image.value);
            TextureData data{.levels = mip_chain(std::move(image.value)), .sampler = {.wrap = Wrap::Clamp}};
            known[key] = {.data = std::make_shared<const TextureData>(std::move(data)), .format = TexelFormat::Float32};
        }
        made.textures[object].push_back(known[key]);
        made.textures[object].back().name = name + "Texture";
    };
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        const WorldObject& object = world.objects[i];
        load(i, "lightmap", object.lightmap, object.lightmap_place, true);
        load(i, "shadowMask", object.shadow_mask, object.shadow_mask_place, false);
    }
    return made;
}

}  // namespace patina::runtime
