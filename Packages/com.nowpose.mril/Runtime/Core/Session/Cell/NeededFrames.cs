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
    /// <remarks>
    /// A ROS system publishes the links of its robots on /tf too, and each predicted frame needs memory and time. A frame that is no longer shown stays
    /// in the tree, so that it is the same when it is shown again, until a new frame replaces it.
    /// </remarks>
    sealed class NeededFrames
    {
        /// <summary>
        /// A new frame replaces a tracked frame that is not shown and has been silent for longer than this: one in the tree always, a kept one when there
        /// are too many frames. If the tree is full, a new frame also replaces a stationary frame that is not shown.
        /// </summary>
        static readonly TimeSpan MaxSilence = TimeSpan.FromTicks(10 * TimeSpan.TicksPerSecond);

        readonly FrameTree _tree;
        readonly DropCounters _drops;
        readonly Predicate<string> _isBeforeConnection;
        readonly HashSet<string> _needed = new HashSet<string>(StringComparer.Ordinal);
        // Root links of robots. A frame with such a name places its robot.
        readonly HashSet<string> _roots = new HashSet<string>(StringComparer.Ordinal);
        readonly ShownNames _shown = new ShownNames();
        readonly Dictionary<string, (FrameTransform Pose, bool IsStationary)> _others =
            new Dictionary<string, (FrameTransform, bool)>(StringComparer.Ordinal);

        // Control time of the newest arrival; null if unknown.
        ControlTime? _now;

        /// <param name="isBeforeConnection">Returns whether the stationary pose of a frame has not been sent again since the newest connection.</param>
        public NeededFrames(FrameTree tree, DropCounters drops, Predicate<string> isBeforeConnection) =>
            (_tree, _drops, _isBeforeConnection) = (tree, drops, isBeforeConnection);

        /// <summary>Raised with the name of a frame in the tree, or of a stationary frame, that another frame has replaced.</summary>
        public event Action<string> Replaced;

        /// <summary>Names of the frames that components show.</summary>
        public IReadOnlyCollection<string> Shown => _shown.All;

        public bool IsShown(string name) => _shown.Contains(name);

        /// <summary>Adds a frame to the tree from now on, even if no pose of the frame has been received yet, because it is shown once more.</summary>
        public void Show(string name)
        {
            _shown.Add(name);
            Need(name);
        }

        /// <summary>Adds the frame that places a robot to the tree, if there is one.</summary>
        public void ShowRoot(string name)
        {
            _roots.Add(name);
            Need(name);
        }

        /// <summary>Reverses one <see cref="Show"/>.</summary>
        public void Hide(string name)
        {
            if (_shown.Remove(name)) Release(name);
        }

        void Release(string name)
        {
            if (!_shown.Contains(name) && !_roots.Contains(name) && _tree.IndexOf(name) < 0 && !_tree.HasChildren(name)) _needed.Remove(name);
        }

        /// <summary>Adds a frame to the tree from now on, even if no pose of the frame has been received yet.</summary>
        public void Need(string name)
        {
            if (!_needed.Add(name) || !_others.TryGetValue(name, out var kept)) return;
            _others.Remove(name);
            // The tree may refuse the pose. It was counted as used when it arrived, because only its frame's number was checked then.
            _drops.Count(Add(kept.Pose, kept.IsStationary));
        }

        /// <inheritdoc cref="FrameTree.Add(in FrameTransform, bool, int)"/>
        /// <param name="arrival">Control time of the arrival; null if unknown.</param>
        public DropReason Add(in FrameTransform pose, bool isStationary, ControlTime? arrival = null)
        {
            if (arrival.HasValue) _now = arrival;
            if (!_needed.Contains(pose.Child)) return Keep(pose, isStationary, arrival);
            var replaced = _tree.IndexOf(pose.Child) < 0 ? FindUnused(pose.Parent) : -1;
            var former = replaced < 0 ? null : _tree[replaced].Name;
            var formerParent = _tree.ParentOf(former ?? pose.Child);
            var reason = _tree.Add(pose, isStationary, replaced);
            if (former != null && _tree.IndexOf(former) < 0)
            {
                _needed.Remove(former);
                Replaced?.Invoke(former);
            }
            if (reason == DropReason.None && !_tree.IsLink(pose.Parent)) Need(pose.Parent);
            if (formerParent != null && formerParent != pose.Parent) Release(formerParent);
            return reason;
        }

        /// <summary>Discards the kept poses of tracked frames, because their times are no longer valid.</summary>
        public void Restart()
        {
            _now = null;
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
            else if (_others.Count + _tree.Count >= ProtocolLimits.Frames && !TryRemoveSilent(arrival) && !TryRemoveOutdated()
                && (_others.Count + _tree.Count > ProtocolLimits.Frames || FindUnused(pose.Parent) < 0)) return DropReason.TooManyFrames;
            _others[pose.Child] = (pose, isStationary);
            return DropReason.None;
        }

        // The clock of the source went back if the pose is much older.
        static bool IsOvertaken(ControlTime stamp, ControlTime newest) =>
            stamp <= newest && !ArrivalLimits.IsFarBehind(stamp, newest);

        // Returns a frame of the tree that neither is shown nor has children, and whose source has probably ended, or in a full tree a stationary one;
        // −1 if there is none, or while the places of all frames are needed for a change of parent.
        int FindUnused(string except)
        {
            if (_tree.IsHandingOver) return -1;
            for (var i = 0; _now.HasValue && i < _tree.Count; i++)
                if (_tree[i].IsSilentAt(_now.Value, MaxSilence) && IsReplaceable(i, except)) return i;
            for (var i = 0; _tree.Count >= ProtocolLimits.Frames && i < _tree.Count; i++)
                if (_tree[i].HasStationarySource && IsReplaceable(i, except)) return i;
            return -1;
        }

        bool IsReplaceable(int index, string except)
        {
            var name = _tree[index].Name;
            return _tree[index].IsFree && name != except && !_shown.Contains(name) && !_roots.Contains(name) && !_tree.HasChildren(name);
        }

        // Removes the kept tracked frame with the oldest pose if its source has probably ended, because each new source may use new names.
        bool TryRemoveSilent(ControlTime? now)
        {
            var oldest = default(FrameTransform);
            foreach (var other in _others)
                if (!other.Value.IsStationary && (oldest.Child == null || other.Value.Pose.Stamp < oldest.Stamp)) oldest = other.Value.Pose;
            return oldest.Child != null && now - oldest.Stamp > MaxSilence && _others.Remove(oldest.Child);
        }

        // Removes a kept stationary frame that the gateway may no longer have. It sends all its frames at the start of a connection, and these are not too
        // many.
        bool TryRemoveOutdated()
        {
            foreach (var other in _others)
            {
                if (!other.Value.IsStationary || !_isBeforeConnection(other.Key)) continue;
                _others.Remove(other.Key);
                Replaced?.Invoke(other.Key);
                return true;
            }
            return false;
        }
    }
}
