using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>The loads of a sweep in their order, and how long each is shown. Immutable, checked once.</summary>
    sealed class SweepPlan
    {
        /// <summary>The most vertices that a load has.</summary>
        public const int GreatestVertices = 2_000_000;

        readonly int[] _loads;

        /// <param name="mostVertices">The greatest load, 1000 to <see cref="GreatestVertices"/>.</param>
        /// <param name="steps">From no load to the greatest, 2 to 100.</param>
        /// <param name="secondsPerLoad">For which each load is shown once it has settled, 0.5 to 600 s.</param>
        /// <param name="settleSeconds">
        /// For which it is shown before, 0 to 60 s. These frames are logged like any other: the fit takes no harm.
        /// </param>
        /// <param name="goesDown">
        /// Whether the loads are gone through in reverse afterwards. Whatever changes with time and not with the load, a processor that
        /// grows warm say, then shows as a difference between both ways.
        /// </param>
        /// <exception cref="InputException">Out of range.</exception>
        public SweepPlan(
            int mostVertices = GreatestVertices, int steps = 10, double secondsPerLoad = 5, double settleSeconds = 1, bool goesDown = true)
        {
            MostVertices = SettingRange.RequireCount(mostVertices, 1000, GreatestVertices, "greatest load of the sweep, vertices");
            SettingRange.RequireCount(steps, 2, 100, "steps of the sweep");
            Settling = SettingRange.RequireSeconds(settleSeconds, 0, 60, "time for a load to settle");
            TimePerLoad = Settling + SettingRange.RequireSeconds(secondsPerLoad, 0.5, 600, "time of a load");
            _loads = new int[goesDown ? 2 * steps + 1 : steps + 1];
            for (var i = 0; i <= steps; i++)
            {
                _loads[i] = (int)((long)mostVertices * i / steps);
                if (goesDown) _loads[2 * steps - i] = _loads[i];
            }
        }

        /// <summary>Of the greatest load.</summary>
        public int MostVertices { get; }

        /// <summary>Vertices, one after the other.</summary>
        public IReadOnlyList<int> Loads => _loads;

        /// <summary>From when a load is shown in full to the next one, the time to settle included.</summary>
        public TimeSpan TimePerLoad { get; }

        /// <summary>The first part of <see cref="TimePerLoad"/>.</summary>
        public TimeSpan Settling { get; }

        /// <summary>Of all loads; building them comes on top.</summary>
        public TimeSpan Duration => new TimeSpan(TimePerLoad.Ticks * _loads.Length);
    }
}
