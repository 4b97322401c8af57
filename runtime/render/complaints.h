// Warnings about compiled materials that can be drawn, but perhaps not as their author expects: textures that the CPU
// samples differently, too many cookies for a draw, values that the engine does not provide. It only reads reflections.
//
//   if (auto warning = anisotropy_warning(material.graph, reflection)) diagnostics.push_back(*warning);
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patina/complaints.h"
#include "patina/patina.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

// About a file as a whole: the reflection knows no lines.
Diagnostic complaint(const std::string& file, Severity severity, Complaint what,
                     std::initializer_list<std::string_view> words);
// What to do about one.
Diagnostic note(std::string message);

// The CPU reference samples without anisotropy. Of textures that `pass` reads; empty: that any pass reads.
std::optional<Diagnostic> anisotropy_warning(const std::string& graph, const Reflection& reflection,
                                             std::string_view pass = {});

// A draw binds one cookie (engine_values.h), regardless of its lights.
std::vector<Diagnostic> cookie_warnings(const std::string& graph, const Reflection& reflection, const Scene& view);

// A pass file may declare values of an engine that only its author's engine has.
std::vector<Diagnostic> unknown_value_warnings(const std::string& pass_file, const Reflection& reflection);

}  // namespace patina::runtime
