namespace Nowpose.Prediction
{
    /// <summary>Tells where one joint is at a time near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// Times are seconds of control time since an epoch the caller chooses near by (within 1e6 s costs no accuracy that
    /// matters); the same epoch for samples and questions. One thread at a time. Nothing here allocates after
    /// construction.
    /// </remarks>
    public interface IJointPredictor
    {
        /// <summary>Takes a sample in any order; solves the section anew when the sample counts.</summary>
        SampleOutcome Add(in JointSample sample);

        /// <summary>The position at a time; never NaN: where nothing better is known the newest sample's, held.</summary>
        /// <returns><see cref="PredictionKind.None"/> with position 0 before the first sample.</returns>
        JointPrediction At(double time);

        /// <summary>The newest sample's position, what a display without compensation shows; 0 before the first.</summary>
        double Hold { get; }

        /// <summary>Time of the newest sample as told, s; negative infinity before the first.</summary>
        double NewestTime { get; }

        /// <summary>Forgets all samples, for a restart of the control system or its clock.</summary>
        void Reset();
    }
}
