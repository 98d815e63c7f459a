using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>C2 mapped to C1: the time in a frame's timestamp code, and in a sweep's log of the same frame.</summary>
    static class FrameControlTime
    {
        /// <param name="source">The session of the frame, while the frame is shown.</param>
        /// <returns>Null unless the clock is synchronised: in holdover its error may be ten times the measured quantity's.</returns>
        public static ControlTime? Of(MrilSession source, DisplayFrame frame)
        {
            if (source.Session == null) return null;
            var clock = source.Session.Clock.ModelAt(frame.Start);
            return clock.State == ClockState.Synchronised ? clock.ToControl(frame.Start) : (ControlTime?)null;
        }
    }
}
