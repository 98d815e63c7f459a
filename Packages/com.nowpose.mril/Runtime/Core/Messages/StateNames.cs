namespace Nowpose.Messages
{
    /// <summary>Short labels for the states of joints and of measured values.</summary>
    static class StateNames
    {
        public const string OtherSourceLimit = "limit is for another source";
        public const string BeyondMeasured = "beyond measured range";
        public const string FramesMissRefreshes = "frames miss refreshes";
        public const string RenderTimeNotMeasured = "render time not measured";
        public const string ValuesUnusable = "no usable values";

        /// <summary>Start of the gateway's reason for a joint that may not be at rest. The text is part of the protocol.</summary>
        public const string UncertainRestReason = "may not be at rest: ";
    }
}
