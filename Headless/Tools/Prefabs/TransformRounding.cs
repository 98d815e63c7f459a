namespace Nowpose.Prefabs;

/// <summary>Removes rounding errors of trigonometric functions, for example 6.123234e-17 in place of 0.</summary>
static class TransformRounding
{
    /// <summary>Number of decimals: 0.1 µm or 0.1 µrad. The resolution of a float near 1 m is coarser.</summary>
    const int Digits = 7;

    public static void Apply(Transform root)
    {
        foreach (var transform in root.GetComponentsInChildren<Transform>(includeInactive: true))
        {
            transform.localPosition = Rounded(transform.localPosition);
            transform.localScale = Rounded(transform.localScale);
            var turn = transform.localRotation;
            transform.localRotation = new Quaternion(Rounded(turn.x), Rounded(turn.y), Rounded(turn.z), Rounded(turn.w));
        }
    }

    public static Vector3 Rounded(Vector3 v) => new(Rounded(v.x), Rounded(v.y), Rounded(v.z));

    // Adding 0.0 converts -0 to 0.
    static float Rounded(float value) => (float)(Math.Round((double)value, Digits) + 0.0);
}
