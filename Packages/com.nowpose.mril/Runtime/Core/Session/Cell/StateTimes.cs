using System;
using System.Collections.Generic;
using Nowpose.Frames;

namespace Nowpose.Session.Cell
{
    /// <summary>Display times since which the frames of a tree have had their states.</summary>
    sealed class StateTimes
    {
        readonly List<(CellFrame Frame, FrameState State, ControlTime? Since)> _states = new List<(CellFrame, FrameState, ControlTime?)>();

        /// <summary>Updates the times after the frames have been evaluated for a display time, which is null while it is unknown.</summary>
        public void Update(FrameTree tree, ControlTime? at)
        {
            for (var i = 0; i < tree.Count; i++)
            {
                if (i == _states.Count) _states.Add((tree[i], tree[i].State, at));
                else if (_states[i].Frame != tree[i] || _states[i].State != tree[i].State) _states[i] = (tree[i], tree[i].State, at);
            }
        }

        /// <summary>Returns the time since which a frame has had its state; null if unknown.</summary>
        public ControlTime? SinceOf(int index) => index < _states.Count ? _states[index].Since : null;

        /// <summary>Returns the time since a state began, not negative; null if it is unknown.</summary>
        public static TimeSpan? Age(ControlTime? since, ControlTime? now)
        {
            var age = now - since;
            return age < TimeSpan.Zero ? TimeSpan.Zero : age;
        }

        /// <summary>Discards all times, because they are no longer valid.</summary>
        public void Restart()
        {
            for (var i = 0; i < _states.Count; i++) _states[i] = (_states[i].Frame, _states[i].State, null);
        }
    }
}
