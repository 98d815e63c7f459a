namespace Nowpose.Unity
{
    /// <summary>Rows of the status panel, from the top.</summary>
    enum StatusRow
    {
        Pose,
        Clock,
        ApplicationLatency,
        VisualisationLatency,
        Horizon,
        RenderTime,
        Range,
        Reduction,
        Error,
        Connection,
        Robot,
        Base,

        /// <summary>What went wrong, in words, over the whole width.</summary>
        Message,
    }
}
