using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Prediction.Samples;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// Adds to a frame tree only the frames that are shown and their ancestors up to a robot's link. Keeps the newest pose of every other frame.
    /// </summary>
    /// <remarks>A ROS system publishes the links of its robots on /tf too, and each predicted frame needs memory and time.</remarks>
    sealed class NeededFrames
    {
        /// <summary>When there are too many frames, a new frame replaces a kept tracked frame that has been silent for longer than this.</summary>
        static readonly TimeSpan MaxSilence = TimeSpan.FromTicks(10 * TimeSpan.TicksPerSecond);

        readonly FrameTree _tree;
        readonly HashSet<string> _needed = new HashSet<string>(StringComparer.Ordinal);
        readonly Dictionary<string, (FrameTransform Pose, bool IsStationary)> _others =
            new Dictionary<string, (FrameTransform, bool)>(StringComparer.Ordinal);

        public NeededFrames(FrameTree tree) => _tree = tree;

        /// <summary>Adds a frame to the tree from now on, even if no pose of the frame has been received yet.</summary>
        public void Need(string name)
        {
            if (!_needed.Add(name) || !_others.TryGetValue(name, out var kept)) return;
            _others.Remove(name);
            Add(kept.Pose, kept.IsStationary);
        }

        /// <inheritdoc cref="FrameTree.Add(in FrameTransform, bool)"/>
        /// <param name="arrival">Control time of the arrival; null if unknown.</param>
        public DropReason Add(in FrameTransform pose, bool isStationary, ControlTime? arrival = null)
        {
            if (!_needed.Contains(pose.Child)) return Keep(pose, isStationary, arrival);
            var reason = _tree.Add(pose, isStationary);
            if (reason == DropReason.None && !_tree.IsLink(pose.Parent)) Need(pose.Parent);
            return reason;
        }

        /// <summary>Discards the kept poses of tracked frames, because their times are no longer valid.</summary>
        public void Restart()
        {
            var stale = new List<string>();
            foreach (var other in _others)
                if (!other.Value.IsStationary) stale.Add(other.Key);
            foreach (var name in stale) _others.Remove(name);
        }

        DropReason Keep(in FrameTransform pose, bool isStationary, ControlTime? arrival)
        {
            if (_others.TryGetValue(pose.Child, out var kept))
            {
                if (!isStationary && !kept.IsStationary && IsOvertaken(pose.Stamp, kept.Pose.Stamp)) return DropReason.LateSample;
            }
            else if (_others.Count + _tree.Count >= ProtocolLimits.Frames && !TryRemoveSilent(arrival)) return DropReason.TooManyFrames;
            _others[pose.Child] = (pose, isStationary);
            return DropReason.None;
        }

        // The clock of the source went back if the pose is much older.
        static bool IsOvertaken(ControlTime stamp, ControlTime newest) =>
            stamp <= newest && !ArrivalOrder.IsFarBehind(stamp, newest);

        // Removes the kept tracked frame with the oldest pose if its source has probably ended, because each new source may use new names.
        bool TryRemoveSilent(ControlTime? now)
        {
            var oldest = default(FrameTransform);
            foreach (var other in _others)
                if (!other.Value.IsStationary && (oldest.Child == null || other.Value.Pose.Stamp < oldest.Stamp)) oldest = other.Value.Pose;
            return oldest.Child != null && now - oldest.Stamp > MaxSilence && _others.Remove(oldest.Child);
        }
    }
}
