// Textures of a glTF file: which picture's file a graph names, and how it is sampled. A picture that is a file of its
// own stays where it is; one that lies inside the model is written next to the graphs.
//
//   Pictures pictures(context);
//   const TextureFile& wood = pictures.texture(3, "table_baseColor");   // "./table_baseColor.png"
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <optional>

#include "compiler/importers/gltf/gltf_object.h"
#include "compiler/importers/gltf/own_names.h"
#include "compiler/importers/imported_graph.h"

namespace patina::importers::gltf {

// The file that is imported, as JSON and as tinygltf has read and runtime/gltf has checked it.
struct Context {
    const tinygltf::Model& file;
    const Json& root;
    Report& report;
    std::string path;    // of the file
    std::string folder;  // that the graphs are for
};

// The element of a list of the file; without it, an object that does not exist.
Object element(const Context& context, std::string_view list, std::size_t index);
std::size_t count_of(const Context& context, std::string_view list);

// How a graph or a scene in the output folder names the file: "./wood.png", "../textures/wood.png".
std::string reference_to(const Context& context, const std::string& file);

// For names of files: some systems do not tell capitals.
inline OwnNames names_of_files() {
    return OwnNames('-', false);
}
// A name that a file can have on every system, and that no other has: "Blue glass" is "Blue_glass", and the next one
// "Blue_glass-2".
std::string file_name(std::string_view name, std::string_view otherwise, OwnNames& taken);

struct TextureFile {
    std::string file{};      // as the graph names it; empty: the texture cannot be read
    GraphMembers sampler{};  // keys of a property's "sampler" that are not the default
};

class Pictures {
public:
    explicit Pictures(const Context& context) : context_(context) {}

    // `name`: of a picture that has none. Remarks and errors are those of the texture, its sampler and its picture, and
    // come once.
    const TextureFile& texture(std::size_t index, const std::string& name);
    std::vector<BinaryFile> copies;

private:
    std::optional<std::size_t> picture_of(Object& texture);
    GraphMembers sampler_of(std::size_t index);
    std::string file_of(std::size_t image, const std::string& name);

    const Context& context_;
    std::map<std::size_t, TextureFile> textures_{};
    std::map<std::size_t, std::string> files_{};  // by image
    std::map<std::size_t, GraphMembers> samplers_{};
    OwnNames names_ = names_of_files();
};

}  // namespace patina::importers::gltf
