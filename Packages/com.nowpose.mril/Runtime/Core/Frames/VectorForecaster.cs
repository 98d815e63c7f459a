namespace Nowpose.Frames
{
    /// <summary>Forecasts the position or the angles of a body from its newest samples.</summary>
    /// <remarks>Allocates nothing after construction. Not thread-safe.</remarks>
    abstract class VectorForecaster
    {
        /// <summary>Maximum time of a forecast after the newest sample, in s; infinite without a maximum.</summary>
        public abstract double Span { get; }

        /// <summary>Number of newest samples that the forecaster uses.</summary>
        public abstract int Samples { get; }

        /// <summary>Whether the newest sample is a jump, so that the velocity there is unknown.</summary>
        public virtual bool HasJumped => false;

        /// <summary>Fits the forecaster to the newest samples, of which there is at least one.</summary>
        /// <param name="isElsewhere">Whether the other part of the pose has jumped at the newest sample.</param>
        /// <returns>Whether the forecaster can forecast from these samples; it depends only on their times.</returns>
        public abstract bool Solve(BodySamples samples, bool isElsewhere);

        /// <summary>Returns the forecast relative to the newest sample, from the last solve.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more; for the paper's polynomials any time.</param>
        public abstract Vector3D At(double ahead);

        /// <summary>Discards all learned state.</summary>
        public virtual void Reset() { }
    }
}
