using System;
using Nowpose.Protocol;

namespace Nowpose.Sync
{
    /// <summary>One sync exchange: four time stamps, two on each clock (Schnierle &amp; Röck 2022, Fig. 7).</summary>
    /// <remarks>Only exchanges that passed <see cref="SyncExchangeRules.Check"/> should reach an estimator.</remarks>
    readonly struct SyncExchange
    {
        /// <param name="t1">Headset time at which the request was sent.</param>
        /// <param name="t2">Control time at which the request arrived.</param>
        /// <param name="t3">Control time at which the reply was sent.</param>
        /// <param name="t4">Headset time at which the reply arrived.</param>
        /// <param name="resolution">
        /// Resolution of the control clock; zero if unknown. If a clock rounds its time stamps down, they are early by half its resolution on
        /// average, so half the resolution is added to <paramref name="t2"/> and <paramref name="t3"/>.
        /// </param>
        /// <param name="serverErrorBound">Error bound that the server states for its own control clock.</param>
        /// <param name="serverSynchronised">False when the server states that its control clock is not synchronised.</param>
        public SyncExchange(
            HeadsetTime t1, ControlTime t2, ControlTime t3, HeadsetTime t4,
            TimeSpan resolution = default, TimeSpan serverErrorBound = default, bool serverSynchronised = true)
        {
            var half = new TimeSpan(resolution.Ticks / 2);
            T1 = t1;
            T2 = t2 + half;
            T3 = t3 + half;
            T4 = t4;
            Resolution = resolution;
            ServerErrorBound = serverErrorBound;
            ServerSynchronised = serverSynchronised;
        }

        /// <param name="t1">Headset time at which the request was sent.</param>
        /// <param name="t4">Headset time at which the reply arrived.</param>
        public static SyncExchange Of(HeadsetTime t1, in SyncFrame reply, HeadsetTime t4)
        {
            // Rounds the resolution up, so that rounding to ticks never invalidates an exchange that is valid in nanoseconds.
            var resolution = ((long)reply.ResolutionNs + ClockTicks.NanosecondsPerTick - 1) / ClockTicks.NanosecondsPerTick;
            return new SyncExchange(
                t1, ControlTime.FromNanoseconds(reply.T2Ns), ControlTime.FromNanoseconds(reply.T3Ns), t4,
                new TimeSpan(resolution), new TimeSpan(reply.ErrorBoundUs * 10L), reply.IsServerSynchronised);
        }

        /// <summary>Headset time at which the request was sent.</summary>
        public HeadsetTime T1 { get; }

        /// <summary>Control time at which the request arrived, plus half the resolution.</summary>
        public ControlTime T2 { get; }

        /// <summary>Control time at which the reply was sent, plus half the resolution.</summary>
        public ControlTime T3 { get; }

        /// <summary>Headset time at which the reply arrived.</summary>
        public HeadsetTime T4 { get; }

        /// <summary>Resolution of the control clock; zero when unknown.</summary>
        public TimeSpan Resolution { get; }

        public TimeSpan ServerErrorBound { get; }

        public bool ServerSynchronised { get; }

        /// <summary>
        /// Offset Φ* from this exchange alone, Eq. (5). It is exact if the delays in both directions are equal; otherwise its error is at most half
        /// of <see cref="RoundTripTime"/>.
        /// </summary>
        public ClockOffset Offset
        {
            get
            {
                var there = T1.SinceEpoch - T2.SinceEpoch;
                var back = T4.SinceEpoch - T3.SinceEpoch;
                // Uses half of the difference, because the sum would overflow if the epochs of the clocks are far apart.
                return new ClockOffset(there + new TimeSpan((back - there).Ticks / 2));
            }
        }

        /// <summary>Sum of the delays in both directions, without the time at the server: (t4 − t1) − (t3 − t2).</summary>
        public TimeSpan RoundTripTime => (T4 - T1) - (T3 - T2);
    }
}
