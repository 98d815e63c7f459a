using Nowpose.Kinematics;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Projects points in the robot's base frame, m, to a drawing. The view is from the front and above, without perspective.</summary>
/// <param name="scale">Length of one metre in units of the drawing.</param>
/// <param name="x">Horizontal position of the base frame's origin in the drawing; positive to the right.</param>
/// <param name="y">Vertical position of the base frame's origin in the drawing; positive downwards.</param>
sealed class Projection(double scale, double x, double y)
{
    // The viewpoint is in front of the robot, slightly to its right, and high enough that the swing is recognisable.
    const double Azimuth = -25 * Math.PI / 180;
    const double Elevation = 48 * Math.PI / 180;

    public double Scale => scale;

    public (double X, double Y) Of(double px, double py, double pz)
    {
        var right = -px * Math.Sin(Azimuth) + py * Math.Cos(Azimuth);
        var near = px * Math.Cos(Azimuth) + py * Math.Sin(Azimuth);
        return (x + scale * right, y - scale * (pz * Math.Cos(Elevation) - near * Math.Sin(Elevation)));
    }

    public (double X, double Y) Of(in RigidTransform pose) => Of(pose.X, pose.Y, pose.Z);
}
