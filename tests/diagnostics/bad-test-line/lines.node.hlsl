/// A test line must be a call, two equals signs and a constant.
///
/// test: Doubel(2) == 4
/// test: Double(2) = 4
/// test: Double(uv0.x) == 4
/// test: Double(2)
/// test: Double(2) == 4 within abc
/// test: Double(2) == 4 within 0
[node("Test/Double")]
float Double(float a = 1) {
    return a * 2;
}
