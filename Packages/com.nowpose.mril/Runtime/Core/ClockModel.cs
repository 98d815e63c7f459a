using System;

namespace Nowpose
{
    /// <summary>
    /// What is known of Φ(t): a line through <see cref="ReferenceOffset"/> at <see cref="Reference"/> with slope
    /// <see cref="Skew"/>.
    /// </summary>
    /// <remarks>
    /// Schnierle &amp; Röck 2022, Eq. (3), on the headset clock: Φ(C2) = Φ(ref) + (γ₂−1)·(C2 − ref). Immutable, so any
    /// thread may read it. <c>default</c> is unsynchronised: it converts nothing, ask <see cref="IsKnown"/> first.
    /// </remarks>
    public readonly struct ClockModel
    {
        /// <param name="estimatedError">Null where nothing better than <paramref name="errorBound"/> is known.</param>
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

        /// <summary>The headset time the line is anchored at, near the newest exchange.</summary>
        public HeadsetTime Reference { get; }

        /// <summary>Φ at <see cref="Reference"/>.</summary>
        public ClockOffset ReferenceOffset { get; }

        /// <summary>γ₂−1, dimensionless (1e-6 is 1 ppm); positive when the headset clock runs fast.</summary>
        public double Skew { get; }

        /// <summary>Proven limit of the offset's error, both ways, at the time the model was asked for.</summary>
        public TimeSpan ErrorBound { get; }

        /// <summary>
        /// Estimated limit of the offset's error, both ways, at the time the model was asked for: three standard errors
        /// and the server's stated error bound, at most <see cref="ErrorBound"/>. This is the ± that panels and reports show.
        /// </summary>
        /// <remarks>
        /// It counts on least delays that are equal in both directions. Half their difference adds to the error, and no
        /// estimator can see it; only <see cref="ErrorBound"/> allows for it.
        /// </remarks>
        public TimeSpan EstimatedError { get; }

        public ClockState State { get; }

        /// <summary>How often a clock stepped before; when it changes, earlier control times belong to another time line.</summary>
        public int Steps { get; }

        /// <summary>Whether the model can convert at all.</summary>
        public bool IsKnown => State != ClockState.Unsynchronised;

        /// <summary>Φ at a headset time.</summary>
        public ClockOffset OffsetAt(HeadsetTime t) =>
            ReferenceOffset + new TimeSpan((long)Math.Round((t - Reference).Ticks * Skew));

        /// <exception cref="InvalidOperationException">The clock is unsynchronised.</exception>
        public ControlTime ToControl(HeadsetTime t)
        {
            RequireKnown();
            return OffsetAt(t).ToControl(t);
        }

        /// <summary>The inverse of <see cref="ToControl"/>, to within one tick of 100 ns.</summary>
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
                throw new InvalidOperationException("the headset clock is not synchronised: no control time is known yet; check State first");
        }
    }
}
