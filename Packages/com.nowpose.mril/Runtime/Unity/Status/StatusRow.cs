namespace Nowpose.Unity.Status
{
    /// <summary>Rows of the status panel in order from the top, and the message, which is above all rows.</summary>
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

        /// <summary>Objects and signals of the cell. The row takes no space if the scene shows none.</summary>
        Objects,

        /// <summary>
        /// Rows for the objects, signals and robots with a fault of their own, one row each. If there are more, the last row states their number. A row
        /// takes no space while it is not needed.
        /// </summary>
        FirstPart,
        SecondPart,
        ThirdPart,
        FourthPart,
        FifthPart,
        LastPart,

        /// <summary>Description of a problem, or other text, in the full width above the rows. It takes no space while it is empty.</summary>
        Message,
    }
}
