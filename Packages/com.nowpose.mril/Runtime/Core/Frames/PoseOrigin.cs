namespace Nowpose.Frames
{
    /// <summary>Origin of a pose at a given time: the least certain of the origins of the positions from which the pose was computed.</summary>
    /// <remarks>The origins are ordered by certainty, the least certain first, and are compared in this order.</remarks>
    enum PoseOrigin
    {
        /// <summary>No data exists for that time.</summary>
        None,

        /// <summary>The pose is the newest one of a frame whose source has stopped. The poses of frames on it are then <see cref="None"/>.</summary>
        Held,

        /// <summary>The pose is predicted.</summary>
        Forecast,

        /// <summary>The pose lies between samples, or is constant.</summary>
        Measured,
    }
}
