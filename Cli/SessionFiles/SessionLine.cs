using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Cli.SessionFiles;

/// <summary>A line of a session file below the header. Kinds that no command uses have no derived type.</summary>
abstract record SessionLine;

/// <summary>A displayed frame.</summary>
/// <param name="Light">Display time; null while the clock was unsynchronised.</param>
/// <param name="Joints">Displayed position of each joint of the header, rad or m.</param>
sealed record FrameLine(HeadsetTime Start, ControlTime? Light, double[] Joints) : SessionLine;

/// <summary>An object in a displayed frame.</summary>
/// <param name="Light">Display time; null while the clock was unsynchronised.</param>
/// <param name="Pose">Displayed pose of the object in the world.</param>
/// <param name="IsCurrent">Whether the pose was shown as current.</param>
sealed record ObjectLine(ControlTime? Light, string Frame, RigidTransform Pose, bool IsCurrent) : SessionLine;

/// <summary>A received message of joint positions.</summary>
/// <param name="Positions">Positions in rad or m, one per name.</param>
/// <param name="Velocities">Velocities in rad/s or m/s, one per name, NaN if unknown; null if all are unknown.</param>
/// <param name="Accelerations">Accelerations in rad/s² or m/s², one per name, NaN if unknown; null if all are unknown.</param>
/// <param name="Dropped">Reason why the session dropped the sample; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the recording gateway; null in a headset's recording.</param>
sealed record SampleLine(
    HeadsetTime Arrival, ControlTime Stamp, string[] Names, double[] Positions, double[] Velocities, double[] Accelerations,
    string Dropped, ControlTime? ControlArrival = null) : SessionLine;

/// <summary>A received message of set-points.</summary>
/// <param name="Dropped">Reason why the session dropped the message; null if it was used.</param>
sealed record PlanLine(Arrival<JointTrajectoryMessage> Arrival, string Dropped) : SessionLine;

/// <summary>A received pose of a frame in the cell.</summary>
/// <param name="Position">Position in the parent's frame, m.</param>
/// <param name="Rotation">Rotation from the frame to its parent.</param>
/// <param name="Dropped">Reason why the session dropped the pose; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the recording gateway; null in a headset's recording.</param>
sealed record PoseLine(
    ControlTime Stamp, string Frame, string Parent, Vector3D Position, UnitQuaternion Rotation, bool IsStationary, string Dropped,
    ControlTime? ControlArrival = null) : SessionLine;

/// <summary>A received value of a signal.</summary>
/// <param name="Stamp">Time of the control cycle in which the signal took this value.</param>
/// <param name="Dropped">Reason why the session dropped the value; null if it was used.</param>
sealed record SignalLine(ControlTime Stamp, string Name, double Value, string Dropped) : SessionLine;

/// <summary>A received sync exchange.</summary>
/// <param name="T4Nanoseconds">t4 as in the file, ns. The time types round to 100 ns.</param>
sealed record SyncLine(long T4Nanoseconds, SyncExchange Exchange) : SessionLine;

/// <summary>A change of the clock model.</summary>
/// <param name="IsNewStart">
/// Whether the session discarded all samples, because their time stamps precede a clock step or were never checked.
/// </param>
sealed record ClockChangeLine(bool IsNewStart) : SessionLine;

/// <summary>A further robot of a headset's session.</summary>
/// <param name="Joints">Its moving joints, with its namespace.</param>
sealed record RobotLine(IReadOnlyList<SessionHeader.Joint> Joints) : SessionLine;

/// <summary>The last line of a complete recording.</summary>
sealed record EndLine : SessionLine;

/// <summary>States how many lines are missing at this point because the recording could not keep up.</summary>
sealed record LostLine(long Count) : SessionLine;
