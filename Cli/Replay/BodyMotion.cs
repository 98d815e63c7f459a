using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Replay;

/// <summary>Decides whether an object moves. Frames in which it rests are not scored.</summary>
static class BodyMotion
{
    /// <summary>An object counts as moving if it moves within this time before and after the display time, s.</summary>
    const double HalfInterval = 0.005;

    /// <summary>Minimum speeds of a moving object, m/s and rad/s.</summary>
    const double MinSpeed = 0.001, MinTurning = 0.005;

    /// <param name="poseAt">Returns the true pose of the object at a time, s.</param>
    public static bool IsMoving(Func<double, RigidTransform> poseAt, double time)
    {
        var (before, after) = (poseAt(time - HalfInterval), poseAt(time + HalfInterval));
        return before.DistanceTo(after) > 2 * HalfInterval * MinSpeed || before.AngleTo(after) > 2 * HalfInterval * MinTurning;
    }
}
