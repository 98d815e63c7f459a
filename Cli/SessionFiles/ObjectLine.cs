using Nowpose.Kinematics;

namespace Nowpose.Cli.SessionFiles;

/// <summary>An object in a displayed frame.</summary>
/// <param name="Light">Display time; null while the clock was unsynchronised.</param>
/// <param name="Pose">Displayed pose of the object in the world.</param>
/// <param name="IsCurrent">Whether the pose was shown as current.</param>
sealed record ObjectLine(ControlTime? Light, string Frame, RigidTransform Pose, bool IsCurrent) : SessionLine;
