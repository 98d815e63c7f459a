namespace Nowpose.Latency
{
    /// <summary>Tells for each frame when its light appears, as a headset's runtime may predict it.</summary>
    /// <remarks>
    /// The moment of light is the middle of the interval in which the frame is shown, as OpenXR's predicted display time is; whoever
    /// has it on another clock, such as OpenXR's own or the performance counter, brings it to the headset clock.
    /// </remarks>
    public interface IDisplayTimeSource
    {
        /// <summary>When the light of a frame appears. Called once a frame, on its thread: quick, without allocating or throwing.</summary>
        /// <param name="frameStart">When the frame began, never earlier than the one before.</param>
        /// <returns>Null when it is not known for this frame.</returns>
        HeadsetTime? LightOf(HeadsetTime frameStart);
    }
}
