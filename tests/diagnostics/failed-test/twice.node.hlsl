/// Twice a value.
/// test: Twice(1) == 2
/// test: Twice(2) == 5
[node("Test")]
float Twice(float value) {
    return value * 2;
}
