namespace Nowpose.Prediction
{
    /// <summary>What became of a sample given to a predictor.</summary>
    public enum SampleOutcome
    {
        /// <summary>It is the newest.</summary>
        Accepted,

        /// <summary>It came out of order and was put in its place among the samples still kept.</summary>
        Late,

        /// <summary>Refused: a sample of the same moment (within 1 µs) is kept already.</summary>
        Duplicate,

        /// <summary>Refused: older than all the samples a prediction needs.</summary>
        TooOld
    }
}
