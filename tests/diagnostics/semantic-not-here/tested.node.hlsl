/// Reads what only a renderer has.
/// test: Timed(1) == 2
[node("Test/Timed")]
float Timed(float x) {
    return x * time;
}
