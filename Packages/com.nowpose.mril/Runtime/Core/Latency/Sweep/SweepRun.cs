using System;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Where a sweep stands in its plan. Time moves with the frames that it is told of; not thread-safe, allocates nothing.</summary>
    sealed class SweepRun
    {
        readonly SweepPlan _plan;
        HeadsetTime? _since;

        public SweepRun(SweepPlan plan) => _plan = plan ?? throw new ArgumentNullException(nameof(plan));

        /// <summary>Loads that were gone through, which is the index of the present one.</summary>
        public int Index { get; private set; }

        public bool IsDone => Index == _plan.Loads.Count;

        /// <summary>The load that is to be shown; none once the sweep is done.</summary>
        public int Vertices => IsDone ? 0 : _plan.Loads[Index];

        /// <summary>A frame has gone.</summary>
        /// <param name="start">When it began.</param>
        /// <param name="isReady">
        /// Whether it showed the load in full and its control time is known. A load's time begins with the first such frame, and anew
        /// after any other.
        /// </param>
        /// <returns>Whether the present load is another one from now on, or the sweep is done.</returns>
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
