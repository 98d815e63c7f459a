using Nowpose.Kinematics;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Looks at the robot from ahead and above, without perspective: metres in its base frame to places in a drawing.</summary>
/// <param name="scale">Units of the drawing in a metre.</param>
/// <param name="x">Where the base frame's origin is drawn, to the right.</param>
/// <param name="y">The same, downwards.</param>
sealed class Projection(double scale, double x, double y)
{
    // Ahead of the robot, a little to its right, and steeply enough from above that a swing is seen as one.
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
