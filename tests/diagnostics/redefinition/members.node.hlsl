struct Pair { float a; float a; };
enum Side { Left, Right, Left };
[node("Test/F")]
float F(float2 uv = 1, out float uv) {
    uv = 1;
    return 2;
}
