// How fast a value changes on the screen: the difference to the next pixel. GPUs compute it in squares of two by two
// pixels, so both pixels of a pair get the same difference. A pixel stage is needed.

/// How much a value grows from one pixel to the next on the right.
[node("Math/Derivative/DDX")] [also("DFdx")]
floatN DDX(
    floatN value = 0  ///< a value that is computed in each pixel
) {
    return ddx(value);
}

/// How much a value grows from one pixel to the next row.
///
/// Rows count as the engine counts pixels: in most engines downwards. Unity's files count as Unity does.
[node("Math/Derivative/DDY")] [also("DFdy")]
floatN DDY(
    floatN value = 0  ///< a value that is computed in each pixel
) {
    return ddy(value);
}

/// How much a value changes from pixel to pixel, in either direction: the width of an anti-aliased edge.
///
/// formula: |ddx(value)| + |ddy(value)|
[node("Math/Derivative/DDXY")] [also("Fwidth")]
floatN DDXY(
    floatN value = 0  ///< a value that is computed in each pixel
) {
    return fwidth(value);
}
