// Statements of HLSL that hand-written node files do not have.
#pragma hlsl

static const float kWeights[3] = { 1, 2, 4 };
static const float kA = 2, kB = 3;

/// Two files' worth of constants in one line.
/// test: Constants(1) == 7
[node("Test/Constants")]
float Constants(float x) {
    float sum = 0;
    for (int i = 0; i < 3; ++i) sum += kWeights[i] * x;
    return sum;
}

/// test: Several(1) == 6
[node("Test/Several")]
float Several(float x) {
    float a = x, b = a + 1, c = b + 1;
    return a + b + c;
}

/// The value of x++ is that of before, and that of ++x is the new one.
/// test: Steps(1) == float4(1, 2, 3, 3)
[node("Test/Steps")]
float4 Steps(float x) {
    float before = x++;
    float now = x;
    float next = ++x;
    return float4(before, now, next, x);
}

/// test: Chain(5) == float3(5, 5, 10)
[node("Test/Chain")]
float3 Chain(float x) {
    float a, b;
    a = b = x;
    float c = (a += b);
    return float3(b, x, c);
}

/// Counts down, and by two.
/// test: Down(0) == 30
[node("Test/Down")]
float Down(float x) {
    float sum = x;
    for (int i = 10; i > 0; i -= 2) sum += i;
    return sum;
}

/// A counter that is a float.
/// test: FloatCounter(0) == 6
[node("Test/FloatCounter")]
float FloatCounter(float x) {
    float sum = x;
    for (float f = 0.5; f < 4; f += 1) sum++;
    for (float g = 0; g <= 1; g += 1) sum += 1;
    return sum;
}

/// The powers of two below a number.
/// test: While(100) == float2(128, 7)
/// test: While(0.5) == float2(1, 0)
[node("Test/While")]
float2 While(float limit) {
    float power = 1;
    int count = 0;
    while (power < limit) {
        power *= 2;
        count++;
    }
    return float2(power, count);
}

/// The body of do runs once in any case.
/// test: Do(100) == 7
/// test: Do(0) == 1
[node("Test/Do")]
float Do(float limit) {
    float power = 1;
    int count = 0;
    do {
        power *= 2;
        count++;
    } while (power < limit);
    return count;
}

/// A limit that only the shader knows.
/// test: Sum(4) == 6
/// test: Sum(0) == 0
/// test: Sum(-3) == 0
[node("Test/Sum")]
float Sum(float x) {
    int count = x;
    int sum = 0;
    for (int i = 0; i < count; i++) sum += i;
    return sum;
}

/// The first index at which the sum is larger, and the sum.
/// test: Break(5) == float2(3, 6)
/// test: Break(1000) == float2(-1, 45)
[node("Test/Break")]
float2 Break(float limit) {
    int found = -1;
    float sum = 0;
    for (int i = 0; i < 10; i++) {
        sum += i;
        if (sum > limit) {
            found = i;
            break;
        }
    }
    return float2(found, sum);
}

/// 1 + 3 + 5 + 7 + 9
/// test: Continue(0) == 25
[node("Test/Continue")]
float Continue(float x) {
    float sum = x;
    for (int i = 0; i < 10; i++) {
        if (i % 2 == 0) continue;
        sum += i;
    }
    return sum;
}

/// A continue and a break in a loop inside of a loop: pairs (i, j) with j < i that are both not 2, up to i = 4.
/// test: Nested(0) == 6
[node("Test/Nested")]
float Nested(float x) {
    float pairs = x;
    for (int i = 0; i < 100; i++) {
        if (i == 2) continue;
        if (i > 4) break;
        for (int j = 0; j < 100; j++) {
            if (j >= i) break;
            if (j == 2) continue;
            pairs++;
        }
    }
    return pairs;
}

/// test: Early(-1) == 1
/// test: Early(0) == 2
/// test: Early(1) == 3
/// test: Early(2) == 4
[node("Test/Early")]
float Early(float x) {
    if (x < 0) return 1;
    float made = 2;
    if (x > 0.5) {
        if (x > 1.5) return 4;
        made = 3;
    }
    return made;
}

/// A return in the middle of a loop.
/// test: Found(3) == 30
/// test: Found(50) == -1
[node("Test/Found")]
float Found(float x) {
    for (int i = 0; i < 10; i++) {
        if (i == x) return i * 10;
    }
    return -1;
}

/// test: Switch(0) == 10
/// test: Switch(1) == 20
/// test: Switch(2) == 20
/// test: Switch(3) == 35
/// test: Switch(9) == 40
[node("Test/Switch")]
float Switch(float x) {
    float made = 5;
    switch ((int)x) {
        case 0:
            made = 10;
            break;
        case 1:
        case 2: made = 20; break;
        case 3: {
            made += 30;
            break;
        }
        default: made = 40;
    }
    return made;
}

/// A case that ends early, and cases that return.
/// test: Cases(1) == 1
/// test: Cases(4) == 40
/// test: Cases(5) == 5.5
/// test: Cases(7) == 7
[node("Test/Cases")]
float Cases(float x) {
    switch ((int)x) {
        case 4: return 40;
        case 5:
            if (x == 5) {
                x += 0.5;
                break;
            }
            x = 100;
            break;
    }
    return x;
}

/// A variable of a block hides that of the function.
/// test: Hidden(3) == 3
[node("Test/Hidden")]
float Hidden(float x) {
    {
        float x = 7;
        x += 1;
    }
    return x;
}

/// An element whose index only the shader knows.
/// test: Written(1) == float3(0, 5, 0)
/// test: Written(2) == float3(0, 0, 5)
[node("Test/Written")]
float3 Written(float x) {
    float values[3] = { 0, 0, 0 };
    int at = x;
    values[at] = 5;
    return float3(values[0], values[1], values[2]);
}

void swapped(inout float a, inout float b) {
    float old = a;
    a = b;
    b = old;
}

/// test: Swap(float2(1, 2)) == float2(2, 1)
[node("Test/Swap")]
float2 Swap(float2 v) {
    swapped(v.x, v.y);
    return v;
}

float measure(float2 v) { return v.x + v.y; }
float measure(float3 v) { return 100 + v.x + v.y + v.z; }
float measure(float v, float scale) { return v * scale; }
float measure(float2 v, float2 scale) { return v.x * scale.x; }

/// The function is that whose parameters fit.
/// test: Overloads(float3(1, 2, 3)) == float3(3, 106, 10)
[node("Test/Overloads")]
float3 Overloads(float3 v) {
    return float3(measure(v.xy), measure(v), measure(v.x, 10));
}

/// Calls in calls.
/// test: DeepOverloads(2) == 65536
[node("Test/DeepOverloads")]
float DeepOverloads(float x) {
    return measure(measure(measure(measure(measure(measure(measure(measure(measure(measure(measure(measure(measure(
        measure(measure(x, 2), 2), 2), 2), 2), 2), 2), 2), 2), 2), 2), 2), 2), 2), 2);
}

struct Shape {
    float2 center, size;
    float angle;
};

/// (Shape)0 is a struct of zeros.
/// test: Struct(4) == float3(0, 4, 0)
[node("Test/Struct")]
float3 Struct(float x) {
    Shape shape = (Shape)0;
    shape.size.x = x;
    return float3(shape.center.x, shape.size.x, shape.angle);
}

/// The value of a list of expressions is that of the last.
/// test: Listed(3) == float2(8, 4)
[node("Test/Listed")]
float2 Listed(float x) {
    float y = (x += 1, 2 * x);
    return float2(y, x);
}

void bounded(float x, out float made) {
    made = 0;
    if (x < 0) return;
    made = 100;
    if (x > 10) {
        return;
    }
    made = x * x;
}
/// A function that returns from several places, with an output.
/// test: Bounded(-1) == 0
/// test: Bounded(2) == 4
/// test: Bounded(20) == 100
[node("Test/Bounded")]
float Bounded(float x) {
    float made;
    bounded(x, made);
    return made;
}
