namespace UnityEngine;

/// <summary>Functions for rotations that are given by the directions of their right, up and forward vectors.</summary>
static class RotationMatrix
{
    /// <summary>Converts a rotation to a quaternion. The three vectors must be orthonormal and form Unity's left-handed axes.</summary>
    internal static Quaternion ToQuaternion(Vector3 right, Vector3 up, Vector3 forward)
    {
        // Divides by a component of the quaternion that is at least 0.5, because a division by a small component would be less precise.
        var trace = right.x + up.y + forward.z;
        if (trace > 0)
        {
            var s = 2 * MathF.Sqrt(1 + trace);
            return new Quaternion((up.z - forward.y) / s, (forward.x - right.z) / s, (right.y - up.x) / s, s / 4);
        }

        if (right.x > up.y && right.x > forward.z)
        {
            var s = 2 * MathF.Sqrt(1 + right.x - up.y - forward.z);
            return new Quaternion(s / 4, (up.x + right.y) / s, (forward.x + right.z) / s, (up.z - forward.y) / s);
        }

        if (up.y > forward.z)
        {
            var s = 2 * MathF.Sqrt(1 + up.y - right.x - forward.z);
            return new Quaternion((up.x + right.y) / s, s / 4, (forward.y + up.z) / s, (forward.x - right.z) / s);
        }
        else
        {
            var s = 2 * MathF.Sqrt(1 + forward.z - right.x - up.y);
            return new Quaternion((forward.x + right.z) / s, (forward.y + up.z) / s, s / 4, (right.y - up.x) / s);
        }
    }
}
