using System;
using Nowpose.Messages;

namespace Nowpose
{
    /// <summary>
    /// Estimate of Φ(t): a line through <see cref="ReferenceOffset"/> at <see cref="Reference"/> with slope
    /// <see cref="Skew"/>.
    /// </summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Eq. (3), on the headset clock: Φ(C2) = Φ(ref) + (γ₂−1)·(C2 − ref). Immutable, so any
    /// thread may read it. <c>default</c> is unsynchronised and converts nothing: check <see cref="IsKnown"/> first.
    /// </remarks>
    public readonly struct ClockModel
    {
        /// <param name="estimatedError">Null to use <paramref name="errorBound"/>.</param>
        public ClockModel(
            HeadsetTime reference, ClockOffset referenceOffset, double skew, TimeSpan errorBound, ClockState state, int steps = 0,
            TimeSpan? estimatedError = null)
        {
            Reference = reference;
            ReferenceOffset = referenceOffset;
            Skew = skew;
            ErrorBound = errorBound;
            EstimatedError = estimatedError ?? errorBound;
            State = state;
            Steps = steps;
        }

        /// <summary>Headset time at which <see cref="ReferenceOffset"/> applies, near the newest exchange.</summary>
        public HeadsetTime Reference { get; }

        /// <summary>Φ at <see cref="Reference"/>.</summary>
        public ClockOffset ReferenceOffset { get; }

        /// <summary>γ₂−1, dimensionless (1e-6 is 1 ppm); positive when the headset clock runs faster than the control clock.</summary>
        public double Skew { get; }

        /// <summary>Proven bound on the absolute error of the offset, at the time for which the model was requested.</summary>
        public TimeSpan ErrorBound { get; }

        /// <summary>
        /// Estimated bound on the absolute error of the offset, at the time for which the model was requested: three standard errors plus the clock
        /// error that the gateway states, at most <see cref="ErrorBound"/>. Panels and reports show it after ±.
        /// </summary>
        /// <remarks>
        /// The estimate assumes that the minimum delays in both directions are equal. If they differ, half the difference adds to the
        /// error. No estimator can observe this difference; only <see cref="ErrorBound"/> includes it.
        /// </remarks>
        public TimeSpan EstimatedError { get; }

        public ClockState State { get; }

        /// <summary>Number of clock steps so far. Control times from before and after a step cannot be compared.</summary>
        public int Steps { get; }

        /// <summary>Whether the model can convert.</summary>
        public bool IsKnown => State != ClockState.Unsynchronised;

        /// <summary>Returns Φ at a headset time.</summary>
        public ClockOffset OffsetAt(HeadsetTime t) =>
            ReferenceOffset + new TimeSpan((long)Math.Round((t - Reference).Ticks * Skew));

        /// <exception cref="InvalidOperationException">The clock is unsynchronised.</exception>
        public ControlTime ToControl(HeadsetTime t)
        {
            RequireKnown();
            return OffsetAt(t).ToControl(t);
        }

        /// <summary>Inverts <see cref="ToControl"/>, to within one tick of 100 ns.</summary>
        /// <exception cref="InvalidOperationException">The clock is unsynchronised.</exception>
        public HeadsetTime ToHeadset(ControlTime t)
        {
            RequireKnown();
            // C2 = C1 + Φref + skew·(C2 − ref), solved for C2 − ref.
            var straight = ReferenceOffset.ToHeadset(t) - Reference;
            return Reference + new TimeSpan((long)Math.Round(straight.Ticks / (1 - Skew)));
        }

        void RequireKnown()
        {
            if (!IsKnown)
                throw new InvalidOperationException(ClockMessages.NotSynchronised);
        }
    }
}
