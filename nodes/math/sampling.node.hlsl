// Sample sequences that need few samples for an accurate result.

/// A sequence of numbers that fills the range from 0 to 1 evenly: the digits of a count, mirrored at the binary point.
///
/// Together with index / count, it gives the points of Hammersley.
///
/// formula: sum over k of digit_k 2^(-k - 1), of the 24 lowest binary digits
/// source: van der Corput, "Verteilungsfunktionen", 1935; Hammersley 1960
/// test: RadicalInverse(1) == 0.5
/// test: RadicalInverse(2) == 0.25
/// test: RadicalInverse(3) == 0.75
/// test: RadicalInverse(6) == 0.375
/// test: RadicalInverse(0) == 0
[node("Math/Sampling/Radical Inverse")]
float RadicalInverse(
    int index = 1  ///< which number of the sequence, 0 or more
) {
    float inverse = 0;
    float digit = 0.5;
    int rest = index;
    for (int i = 0; i < 24; i++) {
        inverse += digit * float(rest & 1);
        rest = rest >> 1;
        digit *= 0.5;
    }
    return inverse;
}

/// Samples the GGX distribution: the cosine between normal and half vector of a random facet, distributed as the facets
/// of GGX are.
///
/// formula: sqrt((1 - u) / (1 + (alpha^2 - 1) u))
/// source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 35
/// test: SampleGGXCosine(0.5, 1) == 0.7071067811865476
/// test: SampleGGXCosine(0.5, 0.5) == 0.8944271909999159
/// test: SampleGGXCosine(0.5, 0) == 1
/// test: SampleGGXCosine(0, 0.3) == 1
/// test: SampleGGXCosine(1, 0.3) == 0
[node("Math/Sampling/GGX Cosine")]
float SampleGGXCosine(
    [range(0, 1)] float u = 0.5,      ///< a uniformly distributed random number
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float rest = max(1 - u, 0);
    // 1 + (alpha^2 - 1) u, in a form that keeps its precision where both are small.
    return sqrt(rest / max(rest + alpha * alpha * u, 1e-7));
}
