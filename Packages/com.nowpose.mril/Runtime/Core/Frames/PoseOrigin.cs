namespace Nowpose.Frames
{
    /// <summary>Origin of a pose at a given time: the least certain origin of all positions from which it was computed.</summary>
    enum PoseOrigin
    {
        /// <summary>No data for that time.</summary>
        None,

        /// <summary>Predicted, or the newest pose of an object whose source has stopped.</summary>
        Forecast,

        /// <summary>Between samples, or constant.</summary>
        Measured,
    }
}
