using Nowpose.Kinematics;

namespace Nowpose.Cli.SessionFiles;

/// <summary>A received pose of a frame in the cell.</summary>
/// <param name="Position">Position in the parent's frame, m.</param>
/// <param name="Rotation">Rotation from the frame to its parent.</param>
/// <param name="Dropped">Reason why the session dropped the pose; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the recording gateway; null in a headset's recording.</param>
sealed record PoseLine(
    ControlTime Stamp, string Frame, string Parent, Vector3D Position, UnitQuaternion Rotation, bool IsStationary, string Dropped,
    ControlTime? ControlArrival = null) : SessionLine;
