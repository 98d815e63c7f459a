using UnityEngine;

namespace Nowpose.Prefabs.Pictures;

/// <summary>The shader Nowpose/Hologram for pictures: brightness, opacity and stripes by the same formulas.</summary>
static class HologramLook
{
    /// <summary>Width of a stripe, NOWPOSE_STRIPE_METRES of the shader.</summary>
    public const float StripeMetres = 0.01f;

    /// <summary>Share of the opacity that the shader's stripes keep.</summary>
    public const double StripeKeeps = 1 - 0.85;

    static readonly float Diagonal = 0.70710678f / (2 * StripeMetres);

    /// <summary>Colour of a face that is seen at an angle.</summary>
    public static Color Shade(Color colour, Vector3 normal, Vector3 view) =>
        colour * (0.4f + 0.6f * Mathf.Abs(Vector3.Dot(normal.normalized, view.normalized)));

    public static double Opacity(double alpha, double fade) => alpha * (1 - 0.8 * fade);

    /// <summary>Number of the stripe, counted in stripes with their gaps: its second half is the fainter one.</summary>
    /// <param name="metres">Position on the object along its own axes, metres.</param>
    public static float Phase(Vector3 metres) => (metres.x + metres.y + metres.z) * Diagonal;
}
