namespace Nowpose.Unity.Status
{
    /// <summary>Rows of the status panel, from the top; the message stands above them.</summary>
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

        /// <summary>Describes what went wrong. Takes the whole width above the other rows, and no space without a text.</summary>
        Message,
    }
}
