using Nowpose.Cli.SessionFiles;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Cli.Replay;

/// <summary>The newest received pose of each frame of a recorded session.</summary>
sealed class NewestPoses
{
    readonly Dictionary<string, PoseLine> _newest = [];

    public void Add(PoseLine pose) => _newest[pose.Frame] = pose;

    /// <summary>Gets the pose in its newest parent of a frame with a given pose in the world; null if this parent is unknown or can move.</summary>
    public RigidTransform? PoseInParent(string frame, in RigidTransform inWorld) =>
        _newest.TryGetValue(frame, out var pose) && WorldOf(pose.Parent) is { } parent ? parent.Inverse * inWorld : null;

    RigidTransform? WorldOf(string frame)
    {
        var world = RigidTransform.Identity;
        for (var depth = 0; frame != FrameParents.World; depth++)
        {
            if (depth == ProtocolLimits.FrameDepth || !_newest.TryGetValue(frame, out var pose) || !pose.IsStationary) return null;
            world = pose.Rotation.At(pose.Position.X, pose.Position.Y, pose.Position.Z) * world;
            frame = pose.Parent;
        }
        return world;
    }
}
