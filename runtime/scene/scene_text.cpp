#include "runtime/scene/scene_text.h"

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "patina/name_value.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

std::string quoted(std::string_view text) {
    return "'" + std::string(text) + "'";
}

// "point position=1,2,0 range=5": words before the first '=' are kinds, the others are settings.
struct Words {
    std::vector<std::string> plain;
    std::map<std::string, std::string, std::less<>> settings;
};

Outcome<Words> split_words(std::string_view text) {
    Words words;
    while (true) {
        std::size_t start = text.find_first_not_of(" \t");
        if (start == std::string_view::npos) return words;
        text.remove_prefix(start);
        std::string_view word = text.substr(0, text.find_first_of(" \t"));
        text.remove_prefix(word.size());
        const auto [name, value] = split_name_value(word);
        if (!value) {
            words.plain.emplace_back(word);
        } else if (!words.settings.emplace(name, *value).second) {
            return Failure{quoted(name) + " is given twice"};
        }
    }
}

// Takes settings out of Words one by one. Remaining settings at the end are an error that lists the known names. The
// first error is kept.
class Settings {
public:
    explicit Settings(Words words, std::string what) : words_(std::move(words)), what_(std::move(what)) {}

    void number(const char* name, float& target, float lowest, float highest) {
        std::optional<std::string> text = take(name);
        if (!text) return;
        int count = 0;
        Outcome<glm::vec4> value = parse_numbers(*text, count);
        if (!value || count != 1) return fail(name, *text, "one number");
        if (value.value.x < lowest || value.value.x > highest)
            return fail(name, *text, "between " + trimmed(lowest) + " and " + trimmed(highest));
        target = value.value.x;
    }

    void vector(const char* name, glm::vec3& target, bool may_be_zero) {
        std::optional<std::string> text = take(name);
        if (!text) return;
        int count = 0;
        Outcome<glm::vec4> value = parse_numbers(*text, count);
        if (!value || count != 3) return fail(name, *text, "three numbers, like 0,1,0");
        if (!may_be_zero && glm::length(glm::vec3(value.value)) == 0) return fail(name, *text, "longer than zero");
        target = glm::vec3(value.value);
    }

    void color(const char* name, glm::vec3& target) {
        std::optional<std::string> text = take(name);
        if (!text) return;
        Outcome<glm::vec4> value = parse_color(*text);
        if (!value) return fail(name, *text, "#rrggbb, one number or three");
        target = glm::vec3(value.value);
    }

    bool has(const char* name) const { return words_.settings.contains(name); }

    std::string error() const {
        if (!error_.empty()) return error_;
        if (words_.settings.empty()) return "";
        return what_ + " has no " + quoted(words_.settings.begin()->first) + "; it has " + asked_;
    }

    static Outcome<glm::vec4> parse_color(std::string_view text) {
        if (text.starts_with('#')) return parse_hex_color(text);
        int count = 0;
        Outcome<glm::vec4> value = parse_numbers(text, count);
        if (value && count == 1) return glm::vec4(glm::vec3(value.value.x), 1);
        if (value && count == 3) return glm::vec4(glm::vec3(value.value), 1);
        return Failure{quoted(text) + " is not a colour: write #rrggbb, one number or three"};
    }

private:
    std::optional<std::string> take(const char* name) {
        asked_ += (asked_.empty() ? "" : ", ") + std::string(name);
        auto found = words_.settings.find(name);
        if (found == words_.settings.end()) return std::nullopt;
        std::string text = std::move(found->second);
        words_.settings.erase(found);
        return text;
    }
    void fail(const char* name, const std::string& text, const std::string& wanted) {
        if (error_.empty()) error_ = what_ + ": " + name + " must be " + wanted + ", not " + quoted(text);
    }
    static std::string trimmed(float value) {
        std::string text = std::to_string(value);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }

    Words words_;
    std::string what_;
    std::string asked_;
    std::string error_;
};

}  // namespace

SphericalHarmonics ambient_of(std::optional<glm::vec3> sky, std::optional<glm::vec3> horizon,
                              std::optional<glm::vec3> ground) {
    const glm::vec3 above = sky ? *sky : horizon ? *horizon : ground.value_or(glm::vec3(0));
    const glm::vec3 below = ground ? *ground : horizon ? *horizon : above;
    return gradient_ambient(above, horizon.value_or((above + below) / 2.0f), below);
}

void set_cone(Light& light, std::optional<float> inner, std::optional<float> outer) {
    if (inner) light.inner_angle = *inner;
    if (outer) light.outer_angle = *outer;
    if (inner && !outer) light.outer_angle = std::max(light.outer_angle, light.inner_angle + 1);
    if (outer && !inner) light.inner_angle = std::min(light.inner_angle, light.outer_angle * 2 / 3);
}

Outcome<glm::vec4> parse_numbers(std::string_view text, int& count) {
    glm::vec4 value(0);
    count = 0;
    Failure wrong{quoted(text) + " is not one to four numbers with commas"};
    const char* at = text.data();
    const char* end = at + text.size();
    while (true) {
        while (at != end && *at == ' ') at++;
        float number = 0;
        auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc{} || !std::isfinite(number) || count == 4) return wrong;
        value[count++] = number;
        at = next;
        while (at != end && *at == ' ') at++;
        if (at == end) return value;
        if (*at++ != ',') return wrong;
    }
}

Outcome<glm::vec4> parse_hex_color(std::string_view text) {
    Failure wrong{quoted(text) + " is not a colour: write #rgb, #rrggbb or #rrggbbaa"};
    if (!text.starts_with('#')) return wrong;
    std::string_view digits = text.substr(1);
    if (digits.size() != 3 && digits.size() != 6 && digits.size() != 8) return wrong;
    std::size_t width = digits.size() == 3 ? 1 : 2;

    glm::vec4 color(0, 0, 0, 1);
    for (std::size_t i = 0; i * width < digits.size(); i++) {
        unsigned value = 0;
        const char* begin = digits.data() + i * width;
        auto [next, error] = std::from_chars(begin, begin + width, value, 16);
        if (error != std::errc{} || next != begin + width) return wrong;
        float channel = float(width == 1 ? value * 17 : value) / 255;
        color[int(i)] = i == 3 ? channel : srgb_decode(channel);
    }
    return color;
}

Outcome<Light> parse_light(std::string_view text) {
    Outcome<Words> words = split_words(text);
    if (!words) return Failure{"light: " + words.error};
    const std::string word = words.value.plain.empty() ? "" : words.value.plain.front();
    const std::optional<LightKind> kind = from_word<LightKind>(word);
    if (words.value.plain.size() != 1 || !kind)
        return Failure{"a light is 'directional', 'point' or 'spot' and its settings, not " + quoted(text)};

    Light light;
    Settings settings(std::move(words.value), "a " + word + " light");
    light.kind = *kind;
    if (light.kind == LightKind::Spot) light.direction = {0, -1, -1};
    float intensity = 1;
    settings.color("color", light.color);
    settings.number("intensity", intensity, 0, 1e6f);
    if (light.kind != LightKind::Directional) {
        settings.vector("position", light.position, true);
        settings.number("range", light.range, 1e-3f, 1e6f);
    }
    if (light.kind != LightKind::Point) settings.vector("direction", light.direction, false);
    if (light.kind == LightKind::Spot) {
        const bool has_inner = settings.has("inner"), has_outer = settings.has("outer");
        float inner = light.inner_angle, outer = light.outer_angle;
        settings.number("inner", inner, 0, 89);
        settings.number("outer", outer, 0.1f, 90);
        set_cone(light, has_inner ? std::optional(inner) : std::nullopt,
                 has_outer ? std::optional(outer) : std::nullopt);
    }
    if (std::string error = settings.error(); !error.empty()) return Failure{error};
    if (light.inner_angle > light.outer_angle) return Failure{"a spot light: inner must not be larger than outer"};
    light.color *= intensity;
    return light;
}

Outcome<SphericalHarmonics> parse_ambient(std::string_view text) {
    Outcome<Words> words = split_words(text);
    if (!words) return Failure{"ambient light: " + words.error};
    if (words.value.plain.size() == 1 && words.value.settings.empty()) {
        if (words.value.plain.front() == "none") return SphericalHarmonics{};
        Outcome<glm::vec4> color = Settings::parse_color(words.value.plain.front());
        if (!color) return Failure{"ambient light: " + color.error};
        return constant_ambient(glm::vec3(color.value));
    }
    if (!words.value.plain.empty() || words.value.settings.empty())
        return Failure{"ambient light is 'none', a colour, or sky=... horizon=... ground=..., not " + quoted(text)};
    const bool has_horizon = words.value.settings.contains("horizon");
    const bool has_sky = words.value.settings.contains("sky"), has_ground = words.value.settings.contains("ground");
    glm::vec3 sky(0), horizon(0), ground(0);
    Settings settings(std::move(words.value), "ambient light");
    settings.color("sky", sky);
    settings.color("horizon", horizon);
    settings.color("ground", ground);
    if (std::string error = settings.error(); !error.empty()) return Failure{error};
    const auto given = [](bool is_given, glm::vec3 color) { return is_given ? std::optional(color) : std::nullopt; };
    return ambient_of(given(has_sky, sky), given(has_horizon, horizon), given(has_ground, ground));
}

namespace {

// "rotation=90", "rotate=90": a name and a number, as no file is called.
bool is_setting(std::string_view word) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos || equals == 0 || equals + 1 == word.size()) return false;
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto is_of_number = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e'; };
    return std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals), is_letter) &&
           (std::all_of(word.begin() + static_cast<std::ptrdiff_t>(equals) + 1, word.end(), is_of_number) ||
            word.starts_with("rotation=") || word.starts_with("intensity="));
}

}  // namespace

Outcome<EnvironmentChoice> parse_environment(std::string_view text) {
    EnvironmentChoice choice;
    std::string given;  // the settings
    // Settings stand at the end: all before them is the file.
    while (true) {
        const std::size_t space = text.find_last_of(" \t");
        const std::string_view word = space == text.npos ? text : text.substr(space + 1);
        if (!is_setting(word)) break;
        given += " " + std::string(word);
        text = space == text.npos ? std::string_view() : text.substr(0, text.find_last_not_of(" \t", space) + 1);
    }
    choice.path = text;
    if (choice.path.empty()) return Failure{"the environment is a picture, studio or none, and the value is empty"};
    Outcome<Words> words = split_words(given);
    if (!words) return Failure{"the environment: " + words.error};
    Settings settings(std::move(words.value), "the environment");
    float rotation = 0, intensity = 1;
    settings.number("rotation", rotation, -kMostDegrees, kMostDegrees);
    settings.number("intensity", intensity, 0, kMostIntensity);
    if (std::string error = settings.error(); !error.empty()) return Failure{error};
    if (!given.empty() && from_word<SceneEnvironment>(choice.path))
        return Failure{"the environment " + quoted(choice.path) + " has no settings: only a picture has"};
    choice.rotation = rotation;
    choice.intensity = intensity;
    return choice;
}

bool is_picture(std::string_view environment) {
    const Outcome<EnvironmentChoice> choice = parse_environment(environment);
    return choice && !from_word<SceneEnvironment>(choice.value.path);
}

std::string set_environment(Scene& scene, const EnvironmentChoice& choice, const EnvironmentProgress& progress) {
    scene.picture_intensity.reset();
    const std::optional<SceneEnvironment> word = from_word<SceneEnvironment>(choice.path);
    if (word == SceneEnvironment::None) {
        scene.environment = nullptr;
        return "";
    }
    scene.environment = studio_environment();
    if (!word) {
        Outcome<std::shared_ptr<const Environment>> loaded = load_environment(choice, progress);
        if (!loaded) return loaded.error;
        scene.environment = std::move(loaded.value);
        scene.picture_intensity = float(choice.intensity);
    }
    scene.ambient = scene.environment->ambient();
    return "";
}

Outcome<Background> parse_background(std::string_view text) {
    if (text == "none") return Background{.color = glm::vec4(0)};
    if (const std::optional<SceneBackdrop> word = from_word<SceneBackdrop>(text)) return Background{.backdrop = *word};
    Outcome<glm::vec4> color = Settings::parse_color(text);
    if (!color) return Failure{"the background: " + color.error + ", or none, env or blur"};
    return Background{.color = color.value};
}

Outcome<Camera> parse_camera(std::string_view text, const Camera& base) {
    Outcome<Words> words = split_words(text);
    if (!words) return Failure{"camera: " + words.error};
    if (!words.value.plain.empty())
        return Failure{"the camera is described by name=value, and " + quoted(words.value.plain.front()) + " has no ="};
    Camera camera = base;
    Settings settings(std::move(words.value), "the camera");
    settings.vector("position", camera.position, true);
    settings.vector("target", camera.target, true);
    const bool has_up = settings.has("up");
    settings.vector("up", camera.up, false);
    settings.number("fov", camera.fov, 1, 170);
    bool orthographic = settings.has("orthographic");
    float height = 2;
    settings.number("orthographic", height, 1e-3f, 1e6f);
    if (orthographic) camera.orthographic_height = height;
    settings.number("near", camera.near_plane, 1e-4f, 1e6f);
    settings.number("far", camera.far_plane, 1e-3f, 1e7f);
    if (std::string error = settings.error(); !error.empty()) return Failure{error};
    if (camera.far_plane <= camera.near_plane) return Failure{"the camera: far must be larger than near"};
    if (camera.position == camera.target) return Failure{"the camera: position and target must differ"};
    if (has_up && glm::cross(camera.target - camera.position, camera.up) == glm::vec3(0))
        return Failure{"the camera: up must be a direction across the view"};
    return camera;
}

}  // namespace patina::runtime
