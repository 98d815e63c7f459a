namespace Nowpose.Unity.Status
{
    /// <summary>Rows of the status panel, from the top; the message is above them.</summary>
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

        /// <summary>Objects and signals of the cell; uses no space where the scene shows none.</summary>
        Objects,

        /// <summary>Description of the problem. Uses the whole width above the other rows, and no space without a text.</summary>
        Message,
    }
}
