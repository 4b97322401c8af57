// Keeps the lines that libpng prints about broken files off stderr: OpenImageIO reports the same as an error.
//
//   const QuietLibpng quiet;
//   input->read_image(...);
#pragma once

namespace patina::runtime {

// While one exists, stderr is collected; at the end of the last one, all but libpng's lines are printed. Any thread may
// have one.
class QuietLibpng {
public:
    QuietLibpng();
    ~QuietLibpng();
    QuietLibpng(const QuietLibpng&) = delete;
    QuietLibpng& operator=(const QuietLibpng&) = delete;
};

}  // namespace patina::runtime
