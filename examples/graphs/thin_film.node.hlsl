/// The colour of light that a thin transparent film reflects: oil on water, a soap bubble, a beetle's shell.
///
/// Light reflected by the film's upper and lower side interferes. Three wavelengths stand for red, green and blue; the
/// loss of half a wave at the upper side turns the cosine of the phase into a sine, so a vanishing film is black.
///
/// formula: sin^2(2 pi n d cos(t) / wavelength), where sin(t) = sin(view) / n
/// source: Born and Wolf, "Principles of Optics", section 7.5 (interference of two beams)
/// test: ThinFilm(1, 0, 1.5) == float3(0, 0, 0)
/// test: ThinFilm(1, 400, 1.5) == float3(0.2159676266344, 0.5177120415810, 0.75)
/// test: ThinFilm(0, 500, 1.25) == float3(0.2159676266344, 0.9217838359937, 0.75)
[node("Examples/Thin Film")]
float3 ThinFilm(
    [range(0, 1)] float cosine,                            ///< of the angle between normal and view
    [range(0, 2000)] [unit("nm")] float thickness = 400,   ///< of the film
    [range(1, 3)] float index = 1.5                        ///< refractive index of the film
) {
    const float3 wavelengths = float3(650, 532, 450);
    float sineInside = sqrt(saturate(1 - cosine * cosine)) / index;
    float cosineInside = sqrt(1 - sineInside * sineInside);
    float3 wave = sin(6.283185307179586 * index * thickness * cosineInside / wavelengths);
    return wave * wave;
}
