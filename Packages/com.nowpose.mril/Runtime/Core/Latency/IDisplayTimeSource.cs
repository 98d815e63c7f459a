namespace Nowpose.Latency
{
    /// <summary>Provides the display time of each frame, for example the prediction of a headset's runtime.</summary>
    /// <remarks>
    /// The display time is the middle of the interval in which the frame is shown, like OpenXR's predicted display time. An
    /// implementation converts times of other clocks, such as OpenXR's own or the performance counter, to the headset clock.
    /// </remarks>
    public interface IDisplayTimeSource
    {
        /// <summary>
        /// Returns the display time of a frame. Called once per frame on the frame loop's thread; must be fast and must not allocate or throw.
        /// </summary>
        /// <param name="frameStart">Start of the frame, never earlier than in the previous call.</param>
        /// <returns>Null if the display time of this frame is unknown.</returns>
        HeadsetTime? LightOf(HeadsetTime frameStart);
    }
}
