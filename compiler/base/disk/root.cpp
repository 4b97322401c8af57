#include "compiler/base/disk/root.h"

#include <deque>
#include <filesystem>

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as many as Linux follows

// The rest of a path that begins with the folder; nothing for another one.
std::optional<fs::path> rest_below(const fs::path& path, const fs::path& folder) {
    auto part = path.begin();
    for (const fs::path& each : folder) {
        if (each.empty()) continue;  // behind the last '/'
        if (part == path.end() || *part != each) return {};
        ++part;
    }
    fs::path rest;
    for (; part != path.end(); ++part) rest /= *part;
    return rest;
}

}  // namespace

Root::Root(const std::string& folder) : name_(folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !fs::is_directory(real, error)) return;
    real_ = real.string();
    given_ = fs::absolute(folder, error).lexically_normal().string();
}

std::optional<std::string> Root::find(const std::string& path) const {
    if (real_.empty() || path.find('\0') != path.npos) return {};
    const auto below = [&](const fs::path& each) {
        std::optional<fs::path> rest = rest_below(each, real_);
        return rest ? rest : rest_below(each, given_);
    };
    std::error_code error;
    const std::optional<fs::path> wanted = below(fs::absolute(path, error).lexically_normal());
    if (!wanted) return {};
    std::deque<fs::path> parts(wanted->begin(), wanted->end());
    const fs::path top(real_);
    fs::path at = top;
    for (int links = 0; !parts.empty();) {
        const fs::path part = parts.front();
        parts.pop_front();
        if (part.empty() || part == ".") continue;
        if (part == "..") {
            if (at == top) return {};
            at = at.parent_path();
            continue;
        }
        const fs::path next = at / part;
        if (!fs::is_symlink(fs::symlink_status(next, error))) {
            at = next;
            continue;
        }
        if (++links > kMostLinks) return {};
        fs::path target = fs::read_symlink(next, error);
        if (target.is_absolute()) {
            // Not made normal: "/home/../art" would ask whether there is a /home.
            const std::optional<fs::path> inside = below(target);
            if (!inside) return {};
            target = *inside;
            at = top;
        }
        parts.insert(parts.begin(), target.begin(), target.end());
    }
    return at.string();
}

bool Root::holds(const std::string& real_path) const {
    return !real_.empty() && rest_below(fs::path(real_path), real_).has_value();
}

// By its text; links on the way are not followed.
bool Root::has_name(const std::string& path) const {
    if (real_.empty()) return false;
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    return rest_below(whole, real_) || rest_below(whole, given_);
}

// The system goes from folder to folder: with ".." it leaves the target of a link, where the text leaves the link.
bool Root::lets_write(const std::string& path) const {
    const bool is_ours = has_name(path);
    if (is_ours && !find(path)) return false;
    std::error_code error;
    const fs::path whole = fs::absolute(path, error), names = whole.relative_path();
    std::deque<fs::path> parts(names.begin(), names.end());
    fs::path at = whole.root_path();
    for (int links = 0; !parts.empty();) {
        const fs::path part = parts.front();
        parts.pop_front();
        if (part.empty() || part == ".") continue;
        const fs::path next = part == ".." ? at.parent_path() : at / part;
        if (part == ".." || !fs::is_symlink(fs::symlink_status(next, error))) {
            at = next;
        } else if (holds(next.string())) {
            const std::optional<std::string> inside = find(next.string());
            if (!inside) return false;
            at = *inside;
        } else {
            if (++links > kMostLinks) return !is_ours;  // the system says that when the file is opened
            const fs::path target = fs::read_symlink(next, error);
            if (target.is_absolute()) at = target.root_path();
            const fs::path rest = target.relative_path();
            parts.insert(parts.begin(), rest.begin(), rest.end());
        }
    }
    return !is_ours || holds(at.string());
}

}  // namespace patina
