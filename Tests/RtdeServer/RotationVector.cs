using Nowpose.Kinematics;

namespace Nowpose.RtdeServer;

/// <summary>Writes poses in UR's format: position in metres, then the rotation axis times the angle in radians.</summary>
static class RotationVector
{
    /// <summary>
    /// Threshold for the sine of the angle. Below it, the axis of a half turn is computed from the diagonal, where it is accurate.
    /// </summary>
    const double SmallSine = 1e-6;

    public static void Write(in RigidTransform pose, Span<double> to)
    {
        var m = pose.ToRowMajor16();
        (to[0], to[1], to[2]) = (m[3], m[7], m[11]);
        var (x, y, z) = (m[9] - m[6], m[2] - m[8], m[4] - m[1]);
        var sine = Math.Sqrt(x * x + y * y + z * z) / 2;
        var angle = Math.Atan2(sine, (m[0] + m[5] + m[10] - 1) / 2);
        if (sine < SmallSine && angle > 1)
        {
            (x, y, z) = (Root(m[0]), Root(m[5]) * Sign(m[1]), Root(m[10]) * Sign(m[2]));
            sine = 0.5;
        }

        var factor = sine == 0 ? 0 : angle / (2 * sine);
        (to[3], to[4], to[5]) = (x * factor, y * factor, z * factor);
    }

    static double Root(double diagonal) => Math.Sqrt(Math.Max(0, (diagonal + 1) / 2));

    static double Sign(double value) => value < 0 ? -1 : 1;
}
