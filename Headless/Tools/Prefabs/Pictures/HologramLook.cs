namespace Nowpose.Prefabs.Pictures;

/// <summary>Computes brightness, opacity and stripes for pictures with the formulas of the shader Nowpose/Hologram.</summary>
static class HologramLook
{
    /// <summary>Width of a stripe and of the gap beside it, m. The value equals NOWPOSE_STRIPE_METRES in the shader.</summary>
    public const float StripeMetres = 0.01f;

    /// <summary>Opacity of a stripe relative to the gap beside it.</summary>
    public const double StripeKeeps = 1 - 0.85;

    static readonly float Diagonal = 0.70710678f / (2 * StripeMetres);

    /// <summary>Returns the colour of a face for an angle of view.</summary>
    public static Color Shade(Color colour, Vector3 normal, Vector3 view) =>
        colour * (0.4f + 0.6f * Mathf.Abs(Vector3.Dot(normal.normalized, view.normalized)));

    public static double Opacity(double alpha, double fade) => alpha * (1 - 0.8 * fade);

    /// <summary>Gets the phase of the stripes at a position. Its fractional part is below 0.5 in a gap, and at least 0.5 in a stripe.</summary>
    /// <param name="metres">Position in the frame of the object, metres.</param>
    public static float Phase(Vector3 metres) => (metres.x + metres.y + metres.z) * Diagonal;
}
