using Nowpose.Kinematics;

namespace Nowpose.Cli.Demo;

/// <summary>Position of the tool centre point, metres in the robot's base frame.</summary>
readonly record struct ToolPosition(double X, double Y, double Z)
{
    public static ToolPosition Of(in RigidTransform pose) => new(pose.X, pose.Y, pose.Z);

    public bool IsFinite => double.IsFinite(X + Y + Z);

    public double DistanceMm(ToolPosition other)
    {
        var (dx, dy, dz) = (X - other.X, Y - other.Y, Z - other.Z);
        return 1000 * Math.Sqrt(dx * dx + dy * dy + dz * dz);
    }
}
