// Notes values of a file that are there and that their reader cannot take: of the wrong type, or out of range. The
// functions of documents.h note them and give what stands for them; whoever asked for the values takes the notes and
// says them in the report.
//
//   Misreads misreads(documents);                    // of this thread, until it is destroyed
//   const double wear = number_of(json, "m_Value");
//   const std::string wrong = take_misreads();       // "'m_Value' (3:9) is \"NaN\", not a number: 0 is taken"
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/importers/shadergraph/read/documents.h"

namespace patina::importers::shadergraph {

class Misreads {
public:
    explicit Misreads(const Documents& documents);
    ~Misreads();
    Misreads(const Misreads&) = delete;
    Misreads& operator=(const Misreads&) = delete;

    std::string take();  // what was noted since the last time
    // The first list or id that cannot be read, with its place: without it the graph is not known. Empty: all could be.
    const std::string& broken() const { return broken_; }

private:
    friend void note_misread(const Json& value, std::string_view key, std::string_view wanted, std::string_view taken);
    friend void note_broken(const Json& value, std::string_view key, std::string_view wanted);

    const Documents& documents_;
    Misreads* outer_;  // of the graph that uses this one as a sub-graph
    std::vector<std::pair<const Json*, std::string>> notes_{};
    std::string broken_{};
};

// `wanted`: "a number"; `taken`: what stands for it.
void note_misread(const Json& value, std::string_view key, std::string_view wanted, std::string_view taken);
// The same of a list or an id.
void note_broken(const Json& value, std::string_view key, std::string_view wanted);
// Of the file that is being read.
std::string take_misreads();

}  // namespace patina::importers::shadergraph
