using System;
using System.Collections.Generic;

namespace Nowpose.Protocol.Cell
{
    /// <summary>Parents of the cell's frames. Enforces the protocol's limits: number of frames, depth, and no cycles. Not thread-safe.</summary>
    /// <remarks>A frame without a known parent, such as the world, is a root. Setting the same parent again costs one look-up.</remarks>
    sealed class FrameParents
    {
        /// <summary>Name of the cell's own frame, which is anchored in the room.</summary>
        public const string World = "world";

        // Without a cycle, a path has at most two steps per frame: one from the frame to its parent, and one from a link to its root link.
        const int MaxSteps = 2 * ProtocolLimits.Frames + 1;

        readonly Dictionary<string, string> _parents = new Dictionary<string, string>(StringComparer.Ordinal);
        // Number of frames that have this parent.
        readonly Dictionary<string, int> _children = new Dictionary<string, int>(StringComparer.Ordinal);
        readonly Func<string, string> _rootOfLink;

        /// <param name="rootOfLink">
        /// Returns the root link of the robot to which a link belongs; null for a frame that is not a link. The function is needed to detect
        /// cycles through a robot. The links of a robot do not count towards the depth.
        /// </param>
        public FrameParents(Func<string, string> rootOfLink = null) => _rootOfLink = rootOfLink ?? (_ => null);

        /// <summary>Parent of a frame; null if none is known.</summary>
        public string this[string child] => _parents.TryGetValue(child, out var parent) ? parent : null;

        /// <summary>Sets the parent of a frame. If the new parent would violate a limit, the previous parent is kept.</summary>
        public DropReason TrySet(string child, string parent)
        {
            var isKnown = _parents.TryGetValue(child, out var present);
            if (isKnown && present == parent) return DropReason.None;
            var reason = Check(child, parent, isKnown);
            if (reason != DropReason.None) return reason;
            Remove(child);
            _parents.Add(child, parent);
            _children[parent] = _children.TryGetValue(parent, out var count) ? count + 1 : 1;
            return reason;
        }

        /// <summary>
        /// Whether a frame depends on itself. This is possible only through the links of a robot that was described after the frame got its parent.
        /// </summary>
        public bool IsInCycle(string child)
        {
            var frame = child;
            for (var steps = 0; steps <= MaxSteps; steps++)
            {
                frame = Above(frame, out _);
                if (frame == null || frame == child) return frame != null;
            }

            return false;
        }

        public bool Remove(string child)
        {
            if (!_parents.TryGetValue(child, out var parent)) return false;
            if (--_children[parent] == 0) _children.Remove(parent);
            return _parents.Remove(child);
        }

        public bool HasChildren(string parent) => _children.ContainsKey(parent);

        DropReason Check(string child, string parent, bool isKnown)
        {
            if (child == parent) return DropReason.OwnParent;
            if (child == World) return DropReason.WorldAsChild;
            if (!isKnown && _parents.Count >= ProtocolLimits.Frames) return DropReason.TooManyFrames;
            var depth = DistanceToRoot(parent, child, out var isCycle);
            if (isCycle) return DropReason.FrameCycle;
            return depth + 1 + HeightBelow(child) > ProtocolLimits.FrameDepth ? DropReason.FrameTooDeep : DropReason.None;
        }

        // Returns the root link of a link, which moves with its robot even if a source publishes its pose; otherwise the parent of the frame, which is
        // null for a root.
        string Above(string frame, out bool isLink)
        {
            var root = _rootOfLink(frame);
            isLink = root != null && root != frame;
            return isLink ? root : this[frame];
        }

        // Returns the number of transforms between a frame and its root; stops at the forbidden frame.
        int DistanceToRoot(string frame, string forbidden, out bool isReached)
        {
            var depth = 0;
            for (var steps = 0; steps <= MaxSteps; steps++)
            {
                isReached = frame == forbidden;
                if (isReached) return depth;
                var above = Above(frame, out var isLink);
                if (above == null) return depth;
                if (!isLink) depth++;
                frame = above;
            }

            // The path did not end: a robot that was added after the frames has closed a cycle.
            isReached = true;
            return depth;
        }

        // Returns the maximum number of transforms from a descendant of a frame up to the frame. Most frames have no descendants: neither children, nor
        // links as the root of a robot.
        int HeightBelow(string frame)
        {
            var height = 0;
            if (!HasChildren(frame) && _rootOfLink(frame) != frame) return height;
            foreach (var descendant in _parents.Keys)
            {
                var distance = DistanceToRoot(descendant, frame, out var isBelow);
                if (isBelow && distance > height) height = distance;
            }

            return height;
        }
    }
}
