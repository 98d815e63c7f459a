using Nowpose.Frames;

namespace Nowpose.Cli.Sessions;

/// <summary>The received pose of a frame of the cell.</summary>
/// <param name="Position">In the parent's frame, m.</param>
/// <param name="Rotation">From the frame to its parent.</param>
/// <param name="Dropped">The reason why the session dropped it; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the gateway that recorded it; null in a headset's recording.</param>
sealed record PoseLine(
    ControlTime Stamp, string Frame, string Parent, Vector3D Position, UnitQuaternion Rotation, bool IsStationary, string Dropped,
    ControlTime? ControlArrival = null) : SessionLine;
