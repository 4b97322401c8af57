// The room `mesh`: vertices and triangles, and the meshes that need no file. It knows no scene and no material.
//
// The preview meshes, made in code: sphere, plane, cube, capsule, torus, and the quad that covers the screen. World
// space is right-handed with y up; front faces are counter-clockwise seen from outside. uv has its origin at the top
// left of the picture, v down. The tangent follows +u, and cross(normal, tangent) * w follows -v: up in the picture, so
// normal maps with y up (OpenGL style) are right.
//
//   std::optional<Mesh> mesh = make_mesh("torus");
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace patina::runtime {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;   // unit
    glm::vec4 tangent;  // unit xyz; w is the bitangent's sign, 1 or -1
    glm::vec2 uv0;
    glm::vec4 color = glm::vec4(1);
    // What a material reads as uv1 to uv3; lightmaps read the first of them. The preview meshes have uv0 here.
    glm::vec2 uv1{0}, uv2{0}, uv3{0};
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // three a triangle
};

// All are centred on the origin. Lengths are world units.
Mesh make_sphere(float radius = 1, int segments = 192, int rings = 96);
Mesh make_plane(float size = 2, int segments = 128);  // faces +z
Mesh make_cube(float size = 1.5f, int segments = 48);
Mesh make_capsule(float radius = 0.6f, float length = 1, int segments = 192, int rings = 48);   // along y
Mesh make_torus(float radius = 0.75f, float tube = 0.32f, int segments = 192, int sides = 72);  // its axis is z
// Positions are clip space: with Camera::clip_space it covers every pixel, uv0 at pixel centres is (x + 0.5) / width.
Mesh make_fullscreen();

std::span<const std::string_view> mesh_names();
// `segments`, 3 or more: around round meshes, and along the sides of flat ones; other numbers follow from it. 0: as
// above.
std::optional<Mesh> make_mesh(std::string_view name, int segments = 0);

// Radius about the origin of the sphere that holds every vertex.
float bounding_radius(const Mesh& mesh);

}  // namespace patina::runtime
