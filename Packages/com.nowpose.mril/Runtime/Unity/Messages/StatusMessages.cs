namespace Nowpose.Unity.Messages
{
    /// <summary>Values and reasons that the status panel shows.</summary>
    static class StatusMessages
    {
        public const string LatenciesDiffer = "runtime and calibration differ";
        public const string LatencyPredicted = "predicted by the runtime";
        public const string RenderingTooLong = "rendering takes too long";
        public const string TooFewSamples = "too few recent samples";
        public const string JointWithoutSamples = "a joint has no samples";
        public const string NoLimit = "no limit is known";
        public const string OtherSourceLimit = "limit is for another source";
    }
}
