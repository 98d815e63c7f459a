using System;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Progress of a sweep through its plan. Time advances with the frames that are added. Not thread-safe; allocates nothing.</summary>
    sealed class SweepRun
    {
        readonly SweepPlan _plan;
        HeadsetTime? _since;

        public SweepRun(SweepPlan plan) => _plan = plan ?? throw new ArgumentNullException(nameof(plan));

        /// <summary>Number of completed loads, which is the index of the current load.</summary>
        public int Index { get; private set; }

        public bool IsDone => Index == _plan.Loads.Count;

        /// <summary>Number of vertices of the current load; 0 once the sweep is done.</summary>
        public int Vertices => IsDone ? 0 : _plan.Loads[Index];

        /// <summary>Adds a finished frame.</summary>
        /// <param name="start">Start of the frame.</param>
        /// <param name="isReady">
        /// Whether the frame showed the complete load and the control time of the frame is known. The time of a load starts with the first
        /// such frame and restarts after any other frame.
        /// </param>
        /// <returns>Whether this frame completed the load, so that the next load begins or the sweep is done.</returns>
        public bool Advance(HeadsetTime start, bool isReady)
        {
            if (IsDone) return false;
            if (!isReady) _since = null;
            else _since ??= start;
            if (!(_since is HeadsetTime since) || start - since < _plan.TimePerLoad) return false;
            Index++;
            _since = null;
            return true;
        }
    }
}
