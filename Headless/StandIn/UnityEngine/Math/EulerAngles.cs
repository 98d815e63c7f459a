namespace UnityEngine;

/// <summary>Converts rotations to Euler angles in the order z, x, y.</summary>
static class EulerAngles
{
    // Sine of the angle about x (89.97 degrees) above which heading and roll turn about the same axis. The whole angle is then assigned to the
    // heading.
    const float GimbalLock = 0.9999999f;

    internal static Vector3 Of(Quaternion rotation)
    {
        var q = Quaternion.Normalize(rotation);
        // The third column of the rotation matrix is the rotated forward vector. Its y component is minus the sine of the angle about x.
        var sine = 2 * (q.w * q.x - q.y * q.z);
        if (MathF.Abs(sine) > GimbalLock)
        {
            var heading = 2 * MathF.Atan2(q.y, q.w);
            return Degrees(Mathf.Sign(sine) * MathF.PI / 2, heading, 0);
        }

        return Degrees(
            MathF.Asin(sine),
            MathF.Atan2(2 * (q.x * q.z + q.w * q.y), 1 - 2 * (q.x * q.x + q.y * q.y)),
            MathF.Atan2(2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z)));
    }

    static Vector3 Degrees(float x, float y, float z) => new(Positive(x), Positive(y), Positive(z));

    static float Positive(float radians)
    {
        var degrees = radians * Mathf.Rad2Deg;
        return degrees < 0 ? degrees + 360 : degrees;
    }
}
