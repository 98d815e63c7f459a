using System;
using Nowpose.Motion;
using Nowpose.Session;

namespace Nowpose.Simulation
{
    /// <summary>
    /// A control system with its robot and a network, all in one process and without sockets: feeds a session as a gateway
    /// would, and knows where the robot truly is. Made of a seed: the same times give the same run. One thread.
    /// </summary>
    /// <remarks>Its settings and its clock may change while it runs; what is under way then arrives as it was sent.</remarks>
    public sealed class VirtualCell
    {
        /// <summary>After a longer pause between two calls what happened before is lost, as it is to a headset that slept.</summary>
        static readonly TimeSpan LongestPause = TimeSpan.FromSeconds(2);

        readonly IMotion _motion;
        readonly HeadsetTime _start;
        readonly VirtualClock _clock;
        readonly VirtualSamples _samples;
        readonly VirtualExchanges _exchanges;
        readonly VirtualPlans _plans;

        /// <param name="clock">The control clock.</param>
        /// <param name="seed">Of all delays and losses.</param>
        /// <param name="start">When the motion begins.</param>
        public VirtualCell(IMotion motion, VirtualClock clock, VirtualCellSettings settings, int seed, HeadsetTime start)
        {
            _motion = motion;
            _start = start;
            _clock = clock;
            _samples = new VirtualSamples(motion, clock, unchecked(seed * 100), start);
            _exchanges = new VirtualExchanges(clock, unchecked(seed * 100 + 50), start);
            _plans = new VirtualPlans(motion, clock, unchecked(seed * 100 + 70), start);
            Settings = settings;
        }

        public VirtualCellSettings Settings { get; set; }

        /// <summary>How much later than its set-points the robot is; null when it does not publish any. The next are sent within 0.25 s.</summary>
        public TimeSpan? PlanLag { get; set; }

        /// <summary>Hands the session what arrives until now. Allocates nothing but the messages.</summary>
        /// <param name="now">Not before the last call's.</param>
        /// <param name="session">May be another one than before.</param>
        public void Run(HeadsetTime now, CompensationSession session)
        {
            var from = now - LongestPause;
            _exchanges.Run(from, now, Settings, session);
            _samples.Run(from, now, Settings, session);
            if (PlanLag.HasValue) _plans.Run(from, now, PlanLag.Value, Settings, session);
        }

        /// <summary>Where the robot truly is; allocates nothing.</summary>
        /// <param name="joints">One per joint of the motion, rad or m.</param>
        public void TruthAt(HeadsetTime t, Span<double> joints) => _motion.At(ClockTicks.Seconds(t - _start), joints);
    }
}
