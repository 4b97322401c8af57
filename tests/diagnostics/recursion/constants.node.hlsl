const float SELF = SELF;
const float THERE = BACK + 1;
const float BACK = 2 * THERE;
const float SIZES[SIZE] = { 1, 2 };
const int SIZE = SIZES[0];
[node("Test/F")]
float F(float a = 1) {
    return a + SELF + THERE + SIZES[0];
}
