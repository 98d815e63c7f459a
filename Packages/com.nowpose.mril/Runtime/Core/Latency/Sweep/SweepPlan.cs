using System;
using System.Collections.Generic;
using Nowpose.Messages;

namespace Nowpose.Latency.Sweep
{
    /// <summary>The loads of a sweep in their order, and the duration of each. Immutable; validated by the constructor.</summary>
    sealed class SweepPlan
    {
        /// <summary>Maximum number of vertices of a load.</summary>
        public const int MaxVertices = 2_000_000;

        readonly int[] _loads;

        /// <param name="maxLoad">Number of vertices of the largest load, 1000 to <see cref="MaxVertices"/>.</param>
        /// <param name="steps">Number of steps from no load to the largest load, 2 to 100.</param>
        /// <param name="secondsPerLoad">Duration of each load after settling, 0.5 to 600 s.</param>
        /// <param name="settleSeconds">
        /// Settling time of each load, 0 to 60 s. Its frames are logged as well; they do not affect the fit.
        /// </param>
        /// <param name="goesDown">
        /// Whether the loads are repeated in reverse order. A change that is caused by elapsed time and not by the load, for example by a processor
        /// that heats up, then appears as a difference between the two directions.
        /// </param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public SweepPlan(
            int maxLoad = MaxVertices, int steps = 10, double secondsPerLoad = 5, double settleSeconds = 1, bool goesDown = true)
        {
            MaxLoad = SettingRange.RequireCount(maxLoad, 1000, MaxVertices, SettingNames.MaxSweepLoad);
            SettingRange.RequireCount(steps, 2, 100, SettingNames.SweepSteps);
            Settling = SettingRange.RequireSeconds(settleSeconds, 0, 60, SettingNames.SettlingTime);
            TimePerLoad = Settling + SettingRange.RequireSeconds(secondsPerLoad, 0.5, 600, SettingNames.LoadTime);
            _loads = new int[goesDown ? 2 * steps + 1 : steps + 1];
            for (var i = 0; i <= steps; i++)
            {
                _loads[i] = (int)((long)maxLoad * i / steps);
                if (goesDown) _loads[2 * steps - i] = _loads[i];
            }
        }

        /// <summary>Number of vertices of the largest load.</summary>
        public int MaxLoad { get; }

        /// <summary>Numbers of vertices in the order of the sweep.</summary>
        public IReadOnlyList<int> Loads => _loads;

        /// <summary>Time from the first complete frame of a load to the next load, including the settling time.</summary>
        public TimeSpan TimePerLoad { get; }

        /// <summary>Settling time, the first part of <see cref="TimePerLoad"/>.</summary>
        public TimeSpan Settling { get; }

        /// <summary>Duration of all loads, without the time to build them.</summary>
        public TimeSpan Duration => new TimeSpan(TimePerLoad.Ticks * _loads.Length);
    }
}
