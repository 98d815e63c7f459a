using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Takes away what trigonometry leaves behind: 6.123234e-17 where 0 is meant.</summary>
static class Tidy
{
    /// <summary>Of lengths a tenth of a micrometre, of turns a tenth of a microradian: below what a float holds of a metre.</summary>
    const int Digits = 7;

    public static void Transforms(Transform root)
    {
        foreach (var transform in root.GetComponentsInChildren<Transform>(includeInactive: true))
        {
            transform.localPosition = Rounded(transform.localPosition);
            transform.localScale = Rounded(transform.localScale);
            var turn = transform.localRotation;
            transform.localRotation = new Quaternion(Rounded(turn.x), Rounded(turn.y), Rounded(turn.z), Rounded(turn.w));
        }
    }

    static Vector3 Rounded(Vector3 v) => new(Rounded(v.x), Rounded(v.y), Rounded(v.z));

    // The sum makes 0 of -0.
    static float Rounded(float value) => (float)(Math.Round((double)value, Digits) + 0.0);
}
