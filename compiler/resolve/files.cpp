#include "compiler/resolve/files.h"

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>

#include "compiler/base/disk/near_file.h"
#include "compiler/base/file_names.h"
#include "compiler/json/json.h"

namespace patina::resolve {
namespace {

const DiskPart kWholeDisk{.root = nullptr, .most_bytes = json::kMaxJsonBytes};

// The result of a function of the program's. If it throws, that is a result without a value.
template <class Call>
auto answer_of(std::string& why, const Call& call) -> decltype(call()) {
    decltype(call()) answer{};
    succeeds([&] { answer = call(); }, why, "the program's file system failed");
    return answer;
}

}  // namespace

bool succeeds(const std::function<void()>& call, std::string& why, std::string_view unknown) {
    try {
        call();
        return true;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& exception) {
        why = exception.what();
    } catch (...) {
        why = unknown;
    }
    return false;
}

std::optional<std::string> ReadFromDisk::operator()(const std::string& path) const {
    DiskFile file = read_disk(path, part.most_bytes, part.root.get());
    if (!file.bytes && !file.why.empty()) throw std::runtime_error(file.why);
    return std::move(file.bytes);
}

bool FindOnDisk::operator()(const std::string& path) const {
    return is_on_disk(path, part.root.get());
}

const DiskPart* Files::part_that_is_read() const {
    if (!options_.files.read) return &kWholeDisk;
    const ReadFromDisk* const read = options_.files.read.target<ReadFromDisk>();
    return read ? &read->part : nullptr;
}

const DiskPart* Files::part_that_is_searched() const {
    if (!options_.files.exists) return options_.files.read ? nullptr : &kWholeDisk;
    const FindOnDisk* const find = options_.files.exists.target<FindOnDisk>();
    return find ? &find->part : nullptr;
}

Files::Path Files::resolve(const std::string& from, const std::string& name) {
    Path made;
    if (options_.files.resolve)
        made.path = answer_of(made.why, [&] { return options_.files.resolve(from, name); });
    else
        made.path = join_names(from, name);
    resolved_.push_back({.from = from, .name = name, .path = made});
    return made;
}

const Files::Answer& Files::read(const std::string& path) {
    Answer& answer = answers_[path];
    if (answer.is_read) return answer;
    answer.is_read = true;
    if (const DiskPart* const part = part_that_is_read()) {
        const std::size_t most = options_.limits.source_bytes, left = most - std::min(bytes_, most);
        DiskFile file = read_disk(path, std::min(left, part->most_bytes), part->root.get());
        answer.text = std::move(file.bytes);
        answer.why = std::move(file.why);
        if (file.is_too_large) answer.too_large = static_cast<std::size_t>(file.size);
    } else {
        answer.text = answer_of(answer.why, [&] { return options_.files.read(path); });
    }
    if (answer.text) bytes_ += answer.text->size();
    return answer;
}

const Files::Answer& Files::find(const std::string& path) {
    Answer& answer = answers_[path];
    if (answer.exists) return answer;
    if (const DiskPart* const part = part_that_is_searched()) {
        answer.exists = is_on_disk(path, part->root.get());
        if (!*answer.exists) answer.why = look_on_disk(path, part->root.get()).why;
    } else if (options_.files.exists) {
        answer.exists = answer_of(answer.why, [&] { return options_.files.exists(path); });
    } else {
        answer.exists = read(path).text.has_value();
    }
    return answer;
}

std::string Files::advice_for(const std::string& path) const {
    const DiskPart* const part = part_that_is_read();
    return part ? near_file(path, part->root.get()) : std::string();
}

void Files::give_part(const std::string& path, std::string text) {
    const Path found = resolve(path, "./" + path.substr(path.rfind('/') + 1));
    if (!found.path.empty()) answers_[found.path] = {.exists = true, .is_read = true, .text = std::move(text)};
}

}  // namespace patina::resolve
