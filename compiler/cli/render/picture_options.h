// The room `cli/render` holds the commands that draw, and the program that runs them, `patina-render`. Of the compiler
// they use the public headers, and of the runtime whatever they need.
//
// The options for the picture of a graph: mesh, size, lights, camera, property values. `patina render`,
// `patina trace` and `patina bake` share them.
//
//   add_picture_options(command, arguments->set, arguments->request);
//   take_overrides(arguments->set, arguments->path, arguments->request);   // once the command line is parsed
#pragma once

#include "compiler/cli/program.h"
#include "runtime/render/render_request.h"

namespace patina::cli {

// Some of them: --set; --mesh and --segments; --light, --env and --ambient; --camera; --via and --device.
void add_set_option(CLI::App& command, std::vector<std::string>& set);
void add_mesh_options(CLI::App& command, runtime::RenderRequest& request);
void add_light_options(CLI::App& command, runtime::RenderRequest& request);
void add_camera_option(CLI::App& command, runtime::RenderRequest& request);
void add_device_options(CLI::App& command, runtime::RenderRequest& request);

// All: --set, --mesh, --segments, --size, --width, --height, --samples, --light, --ambient, --background, --camera and
// -I.
void add_picture_options(CLI::App& command, std::vector<std::string>& set, runtime::RenderRequest& request);

bool is_scene(const std::string& graph);
// By its name; a model is drawn as the scene that its import gives.
bool is_model(const std::string& graph);
// Throw the usage error if one of the graphs is a scene or a model, and the command line sets a mesh; or if an option
// for scenes is used with a graph.
void refuse_mesh(const std::vector<std::string>& graphs, bool has_mesh);
void refuse_object(const std::string& graph, const std::string& option, const std::string& value);

// A check for options whose value is a name. Returns nothing, or what is wrong with the word.
std::string is_not_empty(const std::string& word);
// A check for --time. Returns nothing, or what is wrong with the word.
std::string is_time_word(const std::string& word);

// Enters "_Roughness=0.2" and so on into the request, and the path with its -D. Throws the usage error if a text is not
// of that form or a name has two values.
void take_overrides(const std::vector<std::string>& set, const PathOptions& path, runtime::RenderRequest& request);

}  // namespace patina::cli
